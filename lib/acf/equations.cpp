#include "acf/equations.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

// Of the rms of the spectrum: inverses of less would amplify errors (validation/acf_error_time).
constexpr double inverse_floor = 1e-3;

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

// ---- Patir's ----

PatirEquations::PatirEquations(const Target& target, Shape lags)
    : lags_(lags), transform_({fast_length(2 * lags.nx, 2), fast_length(2 * lags.ny, 2)}) {
  target_.resize(size(lags.cells()));
  for (Index p = 0; p < lags.nx; ++p)
    target.row(static_cast<double>(p), 0, std::span(target_).subspan(size(p * lags.ny), size(lags.ny)));
  multiplicity_.assign(target_.size(), 1.0);
  field_.resize(size(transform_.shape().cells()));
  spectrum_.resize(size(transform_.spectrum_size()));
  transfer_.resize(spectrum_.size());
  inverse_.resize(spectrum_.size());
}

Eigen::Map<Field> PatirEquations::plane() {
  return {field_.data(), transform_.shape().nx, transform_.shape().ny};
}

void PatirEquations::load(std::span<const double> u) {
  plane().setZero();
  plane().topLeftCorner(lags_.nx, lags_.ny) = Eigen::Map<const Field>(u.data(), lags_.nx, lags_.ny);
}

void PatirEquations::forward() { transform_.forward(field_.data(), spectrum_.data()); }
void PatirEquations::backward() { transform_.inverse(spectrum_.data(), field_.data()); }

void PatirEquations::keep_causal() {
  const Index ahead_x = plane().rows() / 2 + 1, ahead_y = plane().cols() / 2 + 1;
  plane().topRightCorner(ahead_x, plane().cols() - ahead_y).setZero();
  plane().bottomRows(plane().rows() - ahead_x).setZero();
  field_[0] /= 2;
}

void PatirEquations::restrict_to(std::span<double> out, double scale) {
  Eigen::Map<Field>(out.data(), lags_.nx, lags_.ny) = scale * plane().topLeftCorner(lags_.nx, lags_.ny);
}

std::vector<double> PatirEquations::start() {
  std::vector<double> u = target_;
  normalise(u, multiplicity_, target_[0]);
  return u;
}

bool PatirEquations::residual(std::span<const double> u, std::span<double> f) {
  load(u);
  forward();
  for (Complex& a : spectrum_) a = std::norm(a);
  backward();
  restrict_to(f, 1 / static_cast<double>(field_.size()));
  for (std::size_t i = 0; i < f.size(); ++i) f[i] -= target_[i];
  return true;
}

void PatirEquations::linearize(std::span<const double> u) {
  load(u);
  forward();
  std::copy(spectrum_.begin(), spectrum_.end(), transfer_.begin());
  double power = 0;
  for (const Complex& a : transfer_) power += std::norm(a);
  const double floor = inverse_floor * inverse_floor * power / static_cast<double>(transfer_.size());
  std::transform(transfer_.begin(), transfer_.end(), inverse_.begin(),
                 [&](const Complex& a) { return 1 / std::max(std::norm(a), floor); });
}

void PatirEquations::jacobian(std::span<const double> v, std::span<double> out) {
  load(v);
  forward();
  for (std::size_t i = 0; i < spectrum_.size(); ++i)
    spectrum_[i] = (std::conj(transfer_[i]) * spectrum_[i]).real();
  backward();
  restrict_to(out, 2 / static_cast<double>(field_.size()));
}

void PatirEquations::precondition(std::span<double> v) {
  const double middle = v[0];
  load(v);
  forward();
  // v at (p,q) and at (-p,-q): its spectrum is real.
  for (std::size_t i = 0; i < spectrum_.size(); ++i)
    spectrum_[i] = (2 * spectrum_[i].real() - middle) * inverse_[i];
  backward();
  keep_causal();
  forward();
  for (std::size_t i = 0; i < spectrum_.size(); ++i) spectrum_[i] *= transfer_[i];
  backward();
  const double points = static_cast<double>(field_.size());
  restrict_to(v, 1 / (points * points));
}

Field PatirEquations::kernel(std::span<const double> u) const {
  return Eigen::Map<const Field>(u.data(), lags_.nx, lags_.ny);
}

}  // namespace asperity
