#include "plastic/flowing_body.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"

namespace asperity {
namespace {

constexpr Index numbers = deviator::components;

}  // namespace

FlowingBody::FlowingBody(const Grid& grid, const PlasticBox& box, const PlasticMaterial& material, int alike,
                         int threads)
    : grid_(box.grid(grid)),
      material_(material),
      alike_(alike),
      threads_(threads),
      body_(grid_, box.edges, material.shear_modulus(), material.poisson, threads),
      strain_(box.layers(), numbers, grid_.shape),
      equivalent_(box.layers(), 1, grid_.shape),
      stress_(strain_),
      is_unknown_(size(equivalent_.values.size()), 0) {}

FlowingBody::FlowingBody(const Grid& grid, const PlasticBox& box, const FlowingBody& smaller,
                         const PlasticBox& own)
    : FlowingBody(grid, box, smaller.material_, smaller.alike_, smaller.threads_) {
  const PlasticBox inner{
      {own.x.first - box.x.first, own.x.count}, {own.y.first - box.y.first, own.y.count}, {}};
  auto place = [&](LayeredField& f, const LayeredField& g) {
    for (Index k = 0; k < g.layers(); ++k)
      for (Index c = 0; c < g.components(); ++c) inner.of(f(k, c)) = g(k, c);
  };
  place(strain_, smaller.strain_);
  place(equivalent_, smaller.equivalent_);
  dissipated_ = smaller.dissipated_;
}

double FlowingBody::memory(const PlasticBox& box) {
  const auto points = static_cast<double>(box.x.count * box.y.count * box.layers());
  constexpr double fields = 11 * sizeof(double) + 1, kernel = 5 * sizeof(float),
                   spectra = 5 * sizeof(Complex), a_point = (3 * 5 + 9 + 6) * numbers * sizeof(double),
                   share_of_points = 0.25;
  return std::min(spectra * points, LayeredBody::most_spectra) +
         points * (fields + kernel + share_of_points * a_point);
}

double FlowingBody::weight(Index point) const {
  return std::sqrt(body_.thickness(point / grid_.shape.cells()));
}

// In a field of five components.
Index FlowingBody::place(Index point, Index component) const {
  const Index cells = grid_.shape.cells();
  return (point / cells * numbers + component) * cells + point % cells;
}

double FlowingBody::stored() {
  begin();
  body_.set_strain(strain_);
  body_.stress(nullptr, stress_);
  double sum = 0;
  for (Index k = 0; k < layers(); ++k)
    for (Index c = 0; c < numbers; ++c)
      sum -= 0.5 * body_.thickness(k) * (strain_(k, c) * stress_(k, c)).sum();
  return alike_ * grid_.cell_area() * sum;
}

// ---- an increment ----

void FlowingBody::begin() {
  restore();
  for (const Index point : points_) is_unknown_[size(point)] = 0;
  points_.clear();
  gamma_.clear();
}

Index FlowingBody::add_points(double share) {
  const auto before = points_.size();
  for (Index n = 0; n < equivalent_.values.size(); ++n)
    if (is_unknown_[size(n)] == 0 && stress_.values[place(n, 0)] > share) {
      is_unknown_[size(n)] = 1;
      points_.push_back(n);
    }
  gamma_.resize(points_.size());
  return static_cast<Index>(points_.size() - before);
}

void FlowingBody::set_scale(std::span<double> scale) const {
  for (std::size_t n = 0; n < points_.size(); ++n)
    std::fill_n(scale.begin() + static_cast<Index>(n) * numbers, numbers,
                2 * material_.shear_modulus() / (material_.hardening.yield * weight(points_[n])));
}

std::vector<double> FlowingBody::former(double factor) {
  begin();
  std::vector<double> out;
  for (std::size_t n = 0; n < former_points_.size(); ++n) {
    const double* last = former_.data() + n * numbers;
    if (std::all_of(last, last + numbers, [](double v) { return v == 0; })) continue;
    is_unknown_[size(former_points_[n])] = 1;
    points_.push_back(former_points_[n]);
    std::transform(last, last + numbers, std::back_inserter(out), [&](double v) { return factor * v; });
  }
  gamma_.resize(points_.size());
  return out;
}

Field FlowingBody::displaced(std::span<const double> unknowns) {
  restore();
  before_.reserve(unknowns.size());
  for (std::size_t n = 0; n < points_.size(); ++n)
    for (Index c = 0; c < numbers; ++c) {
      double& strain = strain_.values[place(points_[n], c)];
      before_.push_back(strain);
      strain += unknowns[n * numbers + size(c)] / weight(points_[n]);
    }
  body_.set_strain(strain_);
  return alike_ * body_.displacement();
}

// ε_n, where it is ε_n + D.
void FlowingBody::restore() {
  for (std::size_t n = 0; n < before_.size(); ++n)
    strain_.values[place(points_[n / numbers], static_cast<Index>(n % numbers))] = before_[n];
  before_.clear();
}

double FlowingBody::respond(const Field& pressure, std::span<const double> unknowns, std::span<double> out) {
  body_.stress(&pressure, stress_);
  restore();
  parallel_ranges(std::ssize(points_), threads_, [&](Index begin, Index end, int) {
    for (Index n = begin; n < end; ++n)
      flow(n, unknowns.subspan(size(n * numbers), numbers), out.subspan(size(n * numbers), numbers));
  });
  parallel_ranges(layers(), threads_, [&](Index begin, Index end, int) {
    for (Index k = begin; k < end; ++k) set_shares(k);
  });
  for (const Index point : points_) stress_.values[place(point, 0)] = 0;
  double largest = 0;
  for (Index k = 0; k < layers(); ++k) largest = std::max(largest, stress_(k, 0).maxCoeff());
  return largest;
}

// Of a layer, as if all of it were elastic, in place of the stress.
void FlowingBody::set_shares(Index layer) {
  Field square = stress_(layer, 0).square();
  for (Index c = 1; c < numbers; ++c) square += stress_(layer, c).square();
  const Hardening& h = material_.hardening;
  const auto strain = equivalent_(layer, 0);
  if (h.strength > 0)
    stress_(layer, 0) = (1.5 * square).sqrt() / (h.strength * (h.offset + strain).pow(h.exponent));
  else
    stress_(layer, 0) = (1.5 * square).sqrt() / (h.yield + h.modulus * strain);
}

// (1) of a point.
void FlowingBody::flow(Index n, std::span<const double> change, std::span<double> out) {
  const Index point = points_[size(n)];
  const double h = weight(point), stiff = 2 * material_.shear_modulus();
  deviator::Vector trial;
  double square = 0;
  for (Index c = 0; c < numbers; ++c) {
    trial[size(c)] = stress_.values[place(point, c)] + stiff * change[size(c)] / h;
    square += trial[size(c)] * trial[size(c)];
  }
  const double q = deviator::root_three_halves * std::sqrt(square),
               gamma = material_.hardening.flow(q, equivalent_.values[point], material_.shear_modulus());
  gamma_[size(n)] = gamma;
  for (Index c = 0; c < numbers; ++c) out[size(c)] = gamma > 0 ? 1.5 * gamma / q * h * trial[size(c)] : 0;
}

void FlowingBody::commit(std::span<const double> unknowns) {
  const Hardening& hardening = material_.hardening;
  const Index cells = grid_.shape.cells();
  former_points_ = points_;
  former_.assign(unknowns.begin(), unknowns.end());
  for (std::size_t n = 0; n < points_.size(); ++n) {
    const Index point = points_[n];
    double& equivalent = equivalent_.values[point];
    const double before = hardening.flow_stress(equivalent);
    equivalent += gamma_[n];
    dissipated_ += alike_ * grid_.cell_area() * body_.thickness(point / cells) * gamma_[n] *
                   (before + hardening.flow_stress(equivalent)) / 2;
    for (Index c = 0; c < numbers; ++c)
      strain_.values[place(point, c)] += unknowns[n * numbers + size(c)] / weight(point);
  }
}

FlowReach FlowingBody::reached() const {
  FlowReach out;
  const auto [cells, ny] = std::pair(grid_.shape.cells(), grid_.shape.ny);
  for (std::size_t n = 0; n < points_.size(); ++n)
    if (const Index layer = points_[n] / cells, cell = points_[n] % cells; gamma_[n] > 0)
      out.add({cell / ny, 1}, {cell % ny, 1}, layer + 1);
  return out;
}

}  // namespace asperity
