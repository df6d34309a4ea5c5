#include <algorithm>
#include <cmath>

#include "acf/equations.hpp"
#include "core/calibration.hpp"

namespace asperity {
namespace {

using calibration::acf::inverse_floor;

double fejer(Index k, Index n) { return 1 - static_cast<double>(std::abs(k)) / static_cast<double>(n); }

double root_mean_square(std::span<const double> v) {
  double sum = 0;
  for (double x : v) sum += x * x;
  return std::sqrt(sum / static_cast<double>(v.size()));
}

double least_over_most(std::span<const double> v) {
  const auto [least, most] = std::minmax_element(v.begin(), v.end());
  return *least / *most;
}

double negative_share(std::span<const double> v) {
  double negative = 0, all = 0;
  for (double x : v) {
    all += std::abs(x);
    negative += std::max(-x, 0.0);
  }
  return negative / all;
}

}  // namespace

Shape ZeroPhaseEquations::least_torus(Shape lags) { return {3 * lags.nx - 2, 3 * lags.ny - 2}; }

ZeroPhaseEquations::ZeroPhaseEquations(const Target& target, Shape lags, bool oriented)
    : transform_(zero_phase_transform(lags, least_torus(lags), oriented)) {
  target_ = transform_->rows_of_part([&](Index p, Index q, std::span<double> row) {
    target.row(static_cast<double>(p), static_cast<double>(q), row);
  });
  multiplicity_ = transform_->multiplicity();
  window_ = transform_->part([&](Index k, Index l) { return fejer(k, lags.nx) * fejer(l, lags.ny); });
  transfer_.resize(size(transform_->spectrum_size()));
  inverse_.resize(transfer_.size());
}

std::vector<double> ZeroPhaseEquations::start() {
  std::vector<double> u(target_.size());
  transform_->filter(target_, u, [](Index, std::span<double> block) {
    for (double& s : block) s = std::sqrt(std::max(s, 0.0));
  });
  for (std::size_t i = 0; i < u.size(); ++i) u[i] *= window_[i];
  normalise(u, multiplicity_, target_[0]);
  return u;
}

bool ZeroPhaseEquations::residual(std::span<const double> u, std::span<double> f) {
  double least = 1;
  const double scale = 1 / static_cast<double>(transform_->torus().cells());
  transform_->filter(u, f, [&](Index, std::span<double> values) {
    Eigen::Map<Eigen::ArrayXd> block(values.data(), static_cast<Index>(values.size()));
    least = std::min(least, block.minCoeff<Eigen::PropagateNaN>());
    block = scale * block.square();
  });
  for (std::size_t i = 0; i < f.size(); ++i) f[i] -= target_[i];
  return least > 0;
}

void ZeroPhaseEquations::linearize(std::span<const double> u) {
  transform_->forward(u, transfer_);
  const double floor = inverse_floor * root_mean_square(transfer_);
  const double scale = 1 / static_cast<double>(transform_->torus().cells());
  for (std::size_t i = 0; i < transfer_.size(); ++i) {
    inverse_[i] = std::copysign(0.5 * scale / std::max(std::abs(transfer_[i]), floor), transfer_[i]);
    transfer_[i] *= 2 * scale;
  }
}

void ZeroPhaseEquations::jacobian(std::span<const double> v, std::span<double> out) {
  transform_->filter(v, out, [&](Index offset, std::span<double> block) {
    const double* transfer = transfer_.data() + offset;
    for (std::size_t i = 0; i < block.size(); ++i) block[i] *= transfer[i];
  });
}

void ZeroPhaseEquations::precondition(std::span<double> v) {
  transform_->filter(v, v, [&](Index offset, std::span<double> block) {
    const double* inverse = inverse_.data() + offset;
    for (std::size_t i = 0; i < block.size(); ++i) block[i] *= inverse[i];
  });
}

Feasibility ZeroPhaseEquations::feasibility() {
  AlignedVector<double>& spectrum = transfer_;  // not in use before the first linearisation
  transform_->forward(target_, spectrum);
  Feasibility out{least_over_most(spectrum), negative_share(spectrum), 0};
  if (out.least >= 0) return out;
  std::vector<double> windowed(target_);
  for (std::size_t i = 0; i < windowed.size(); ++i) windowed[i] *= window_[i];
  transform_->forward(windowed, spectrum);
  out.windowed = least_over_most(spectrum);
  return out;
}

}  // namespace asperity
