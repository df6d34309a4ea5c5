#include <algorithm>

#include "acf/equations.hpp"
#include "core/calibration.hpp"

namespace asperity {

using calibration::acf::inverse_floor;

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
