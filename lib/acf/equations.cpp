#include "acf/equations.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

// Spectral values this far below the rms are not inverted: they are where a preconditioner would only
// amplify.
constexpr double inverse_floor = 1e-3;

Shape symmetric_torus(const Field& target) {
  auto side = [](Index n) { return n == 1 ? Index{2} : fast_length(3 * n - 2, 4); };
  return {side(target.rows()), side(target.cols())};
}

Shape patir_torus(const Field& target) {
  return {fast_length(2 * target.rows(), 2), fast_length(2 * target.cols(), 2)};
}

double root_mean_square(const std::vector<double>& v) {
  double sum = 0;
  for (double x : v) sum += x * x;
  return std::sqrt(sum / static_cast<double>(v.size()));
}

std::vector<double> multiplicities(Index n, Index m) {
  std::vector<double> w;
  for (Index k = 0; k < n; ++k)
    for (Index l = 0; l < m; ++l) w.push_back((k == 0 ? 1.0 : 2.0) * (l == 0 ? 1.0 : 2.0));
  return w;
}

// u scaled to Σ w u² = variance.
void normalise(std::vector<double>& u, const std::vector<double>& w, double variance) {
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i) sum += w[i] * u[i] * u[i];
  for (double& x : u) x *= std::sqrt(variance / sum);
}

}  // namespace

SymmetricEquations::SymmetricEquations(const Field& target)
    : target_(target),
      transform_(symmetric_torus(target)),
      multiplicity_(multiplicities(target.rows(), target.cols())) {
  quarter_.resize(size(transform_.quarter().cells()));
  symbol_.resize(quarter_.size());
  inverse_.resize(quarter_.size());
}

void SymmetricEquations::spectrum(std::span<const double> u) {
  std::fill(quarter_.begin(), quarter_.end(), 0.0);
  const Index m = target_.cols(), stride = transform_.quarter().ny;
  for (Index k = 0; k < target_.rows(); ++k) std::copy_n(u.data() + k * m, m, quarter_.data() + k * stride);
  transform_.apply(quarter_.data());
}

void SymmetricEquations::restrict_to(std::span<double> out, double scale) {
  transform_.apply(quarter_.data());
  const Index m = target_.cols(), stride = transform_.quarter().ny;
  const double factor = scale / static_cast<double>(transform_.torus().cells());
  for (Index k = 0; k < target_.rows(); ++k)
    for (Index l = 0; l < m; ++l) out[size(k * m + l)] = factor * quarter_[size(k * stride + l)];
}

std::vector<double> SymmetricEquations::start() {
  const Index n = target_.rows(), m = target_.cols();
  std::vector<double> u(size(n * m));
  spectrum({target_.data(), u.size()});
  for (double& s : quarter_) s = std::sqrt(std::max(s, 0.0));
  restrict_to(u, 1);
  auto window = [](Index k, Index count) { return 1 - static_cast<double>(k) / static_cast<double>(count); };
  for (Index k = 0; k < n; ++k)
    for (Index l = 0; l < m; ++l) u[size(k * m + l)] *= window(k, n) * window(l, m);
  normalise(u, multiplicity_, target_(0, 0));
  return u;
}

bool SymmetricEquations::residual(std::span<const double> u, std::span<double> f) {
  spectrum(u);
  if (guard && !(*std::min_element(quarter_.begin(), quarter_.end()) > 0)) return false;
  for (double& a : quarter_) a *= a;
  restrict_to(f, 1);
  for (std::size_t i = 0; i < f.size(); ++i) f[i] -= target_.data()[i];
  return true;
}

void SymmetricEquations::linearize(std::span<const double> u) {
  spectrum(u);
  std::copy(quarter_.begin(), quarter_.end(), symbol_.begin());
  const double floor = inverse_floor * root_mean_square(symbol_);
  std::transform(symbol_.begin(), symbol_.end(), inverse_.begin(),
                 [&](double a) { return std::copysign(1 / std::max(std::abs(a), floor), a); });
}

void SymmetricEquations::jacobian(std::span<const double> v, std::span<double> out) {
  spectrum(v);
  for (std::size_t i = 0; i < quarter_.size(); ++i) quarter_[i] *= symbol_[i];
  restrict_to(out, 2);
}

void SymmetricEquations::precondition(std::span<double> v) {
  spectrum(v);
  for (std::size_t i = 0; i < quarter_.size(); ++i) quarter_[i] *= inverse_[i];
  restrict_to(v, 0.5);
}

double SymmetricEquations::feasibility() {
  spectrum({target_.data(), size(target_.size())});
  const auto [least, most] = std::minmax_element(quarter_.begin(), quarter_.end());
  return *least / *most;
}

NonlinearSystem SymmetricEquations::system() {
  NonlinearSystem s;
  s.residual = [this](std::span<const double> u, std::span<double> f) { return residual(u, f); };
  s.linearize = [this](std::span<const double> u) { linearize(u); };
  s.jacobian = [this](std::span<const double> v, std::span<double> out) { jacobian(v, out); };
  s.precondition = [this](std::span<double> v) { precondition(v); };
  for (double w : multiplicity_) s.scale.push_back(std::sqrt(w));
  return s;
}

Field SymmetricEquations::kernel(std::span<const double> u) const {
  const Index n = target_.rows(), m = target_.cols();
  return Field::NullaryExpr(2 * n - 1, 2 * m - 1, [&](Index k, Index l) {
    return u[size(std::abs(k - n + 1) * m + std::abs(l - m + 1))];
  });
}

PatirEquations::PatirEquations(const Field& target) : target_(target), transform_(patir_torus(target)) {
  field_.resize(size(transform_.shape().cells()));
  spectrum_.resize(size(transform_.spectrum_size()));
  symbol_.resize(spectrum_.size());
  inverse_.resize(spectrum_.size());
}

void PatirEquations::load(std::span<const double> u) {
  std::fill(field_.begin(), field_.end(), 0.0);
  const Index m = target_.cols(), stride = transform_.shape().ny;
  for (Index k = 0; k < target_.rows(); ++k) std::copy_n(u.data() + k * m, m, field_.data() + k * stride);
}

void PatirEquations::load_even(std::span<const double> v) {
  load(v);
  const auto [rows, columns] = transform_.shape();
  const Index m = target_.cols();
  for (Index p = 0; p < target_.rows(); ++p)
    for (Index q = 0; q < m; ++q)
      field_[size((rows - p) % rows * columns + (columns - q) % columns)] = v[size(p * m + q)];
}

void PatirEquations::forward() { transform_.forward(field_.data(), spectrum_.data()); }
void PatirEquations::backward() { transform_.inverse(spectrum_.data(), field_.data()); }

void PatirEquations::keep_causal() {
  const auto [rows, columns] = transform_.shape();
  for (Index p = 0; p < rows; ++p) {
    double* row = field_.data() + p * columns;
    std::fill(row + (p <= rows / 2 ? columns / 2 + 1 : 0), row + columns, 0.0);
  }
  field_[0] /= 2;
}

void PatirEquations::restrict_to(std::span<double> out, double scale) const {
  const Index m = target_.cols(), stride = transform_.shape().ny;
  for (Index k = 0; k < target_.rows(); ++k)
    for (Index l = 0; l < m; ++l) out[size(k * m + l)] = scale * field_[size(k * stride + l)];
}

std::vector<double> PatirEquations::start() const {
  std::vector<double> u(target_.data(), target_.data() + target_.size());
  normalise(u, std::vector<double>(u.size(), 1.0), target_(0, 0));
  return u;
}

void PatirEquations::residual(std::span<const double> u, std::span<double> f) {
  load(u);
  forward();
  for (Complex& a : spectrum_) a = std::norm(a);
  backward();
  restrict_to(f, 1 / static_cast<double>(field_.size()));
  for (std::size_t i = 0; i < f.size(); ++i) f[i] -= target_.data()[i];
}

void PatirEquations::linearize(std::span<const double> u) {
  load(u);
  forward();
  std::copy(spectrum_.begin(), spectrum_.end(), symbol_.begin());
  double power = 0;
  for (const Complex& a : symbol_) power += std::norm(a);
  const double floor = inverse_floor * inverse_floor * power / static_cast<double>(symbol_.size());
  std::transform(symbol_.begin(), symbol_.end(), inverse_.begin(),
                 [&](const Complex& a) { return 1 / std::max(std::norm(a), floor); });
}

void PatirEquations::jacobian(std::span<const double> v, std::span<double> out) {
  load(v);
  forward();
  for (std::size_t i = 0; i < spectrum_.size(); ++i)
    spectrum_[i] = (std::conj(symbol_[i]) * spectrum_[i]).real();
  backward();
  restrict_to(out, 2 / static_cast<double>(field_.size()));
}

void PatirEquations::precondition(std::span<double> v) {
  load_even(v);
  forward();
  for (std::size_t i = 0; i < spectrum_.size(); ++i) spectrum_[i] *= inverse_[i];
  backward();
  keep_causal();
  forward();
  for (std::size_t i = 0; i < spectrum_.size(); ++i) spectrum_[i] *= symbol_[i];
  backward();
  const double points = static_cast<double>(field_.size());
  restrict_to(v, 1 / (points * points));
}

NonlinearSystem PatirEquations::system() {
  NonlinearSystem s;
  s.residual = [this](std::span<const double> u, std::span<double> f) { return residual(u, f), true; };
  s.linearize = [this](std::span<const double> u) { linearize(u); };
  s.jacobian = [this](std::span<const double> v, std::span<double> out) { jacobian(v, out); };
  s.precondition = [this](std::span<double> v) { precondition(v); };
  s.scale.assign(size(target_.size()), 1.0);
  return s;
}

Field PatirEquations::kernel(std::span<const double> u) const {
  return Eigen::Map<const Field>(u.data(), target_.rows(), target_.cols());
}

}  // namespace asperity
