#include "plastic/residual_stress.hpp"

#include <algorithm>
#include <cmath>

#include "plastic/layered_body.hpp"

namespace asperity {
namespace {

constexpr double further = 5;  // times the depth of the strain

std::vector<double> with_further_edges(std::vector<double> edges) {
  const double depth = edges.back();
  for (double step = depth - edges[edges.size() - 2]; edges.back() < further * depth; step *= 2)
    edges.push_back(edges.back() + step);
  return edges;
}

}  // namespace

double ResidualStress::memory(Shape cells, const std::vector<double>& edges) {
  constexpr double five = deviator::components, six = five + 1;
  const auto given = static_cast<double>(edges.size() - 1),
             all = static_cast<double>(with_further_edges(edges).size() - 1),
             points = static_cast<double>(cells.cells());
  return points * (five * given + (five + six) * all) * sizeof(double) +
         std::min(points * six * all * sizeof(Complex), LayeredBody::most_spectra);
}

ResidualStress::ResidualStress(const Grid& grid, const std::vector<double>& edges, const LayeredField& strain,
                               double young, double poisson, int threads)
    : grid_(grid) {
  const std::vector<double> all = with_further_edges(edges);
  for (std::size_t k = 1; k < all.size(); ++k) middles_.push_back((all[k - 1] + all[k]) / 2);
  depths_.assign(middles_.begin(), middles_.begin() + std::ssize(edges) - 1);
  end_ = all.back();
  const auto layers = static_cast<Index>(middles_.size());
  LayeredField deeper(layers, deviator::components, grid.shape);
  deeper.values.head(strain.values.size()) = strain.values;
  stress_ = LayeredField(layers, deviator::components + 1, grid.shape);
  LayeredBody body(grid, all, young / (2 * (1 + poisson)), poisson, threads);
  body.set_strain(deeper);
  body.stress(nullptr, stress_);
  for (Index k = 0; k < layers; ++k)
    for (Index n = 0; n < grid.shape.cells(); ++n) {
      deviator::Vector d;
      for (Index c = 0; c < deviator::components; ++c) d[size(c)] = stress_(k, c).data()[n];
      const stress::Tensor t = deviator::tensor(d, stress_(k, deviator::components).data()[n]);
      for (const stress::Component c : stress::components) stress_(k, static_cast<Index>(c)).data()[n] = t[c];
    }
}

ResidualStress::Weights ResidualStress::weights(double z) const {
  if (z >= end_) return {0, 0, 0};
  const auto last = static_cast<Index>(middles_.size()) - 1;
  if (z >= middles_.back()) return {last - 1, 0, (end_ - z) / (end_ - middles_.back())};
  const auto below = std::ranges::upper_bound(middles_, z) - middles_.begin();
  const Index k = std::clamp<Index>(below - 1, 0, last - 1);
  const double lower = (z - middles_[size(k)]) / (middles_[size(k + 1)] - middles_[size(k)]);
  return {k, 1 - lower, lower};
}

Field ResidualStress::layer(double z, stress::Component c) const {
  const auto [k, upper, lower] = weights(z);
  const auto component = static_cast<Index>(c);
  return upper * stress_(k, component) + lower * stress_(k + 1, component);
}

stress::Tensor ResidualStress::at(double x, double y, double z) const {
  const auto [k, upper, lower] = weights(z);
  auto cell = [](double place, Index cells) {
    const double inside = std::clamp(place, 0.0, static_cast<double>(cells - 1));
    const Index first = std::min(static_cast<Index>(inside), std::max<Index>(cells - 2, 0));
    return std::pair{first, inside - static_cast<double>(first)};
  };
  const auto [i, across_x] =
      cell(x / grid_.dx + (static_cast<double>(grid_.shape.nx) - 1) / 2, grid_.shape.nx);
  const auto [j, across_y] =
      cell(y / grid_.dy + (static_cast<double>(grid_.shape.ny) - 1) / 2, grid_.shape.ny);
  stress::Tensor out{};
  for (const stress::Component c : stress::components)
    for (const Index l : {Index{0}, Index{1}}) {
      const auto layer = stress_(k + l, static_cast<Index>(c));
      for (Index m = 0; m < 2; ++m)
        for (Index n = 0; n < 2; ++n) {
          const double weight = (l == 0 ? upper : lower) * (m == 0 ? 1 - across_x : across_x) *
                                (n == 0 ? 1 - across_y : across_y);
          if (weight != 0) out[c] += weight * layer(i + m, j + n);
        }
    }
  return out;
}

}  // namespace asperity
