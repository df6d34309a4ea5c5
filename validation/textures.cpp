#include "textures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <utility>

namespace asperity::textures {
namespace {

constexpr double pi = std::numbers::pi;

double exponential(double x, double y, double l) { return std::exp(-std::hypot(x / (2 * l), y / l)); }

// Lengths 2:1, turned by 30°.
double oriented_gaussian(double x, double y, double l) {
  const double u = std::cos(pi / 6) * x + std::sin(pi / 6) * y,
               v = std::cos(pi / 6) * y - std::sin(pi / 6) * x;
  return std::exp(-std::pow(u / (2 * l), 2) - std::pow(v / l, 2));
}

// Of the spectrum 1 for q l ≤ 1, (q l)^-2(1+H) up to the grid's: a Hankel transform, tabulated.
class SelfAffine {
 public:
  SelfAffine(double hurst, double length) {
    const double most = pi;
    double sum = 0;
    table_.assign(4096, 0);
    for (int k = 0; k < steps; ++k) {
      const double q = most * (k + 0.5) / steps,
                   power = q * std::pow(std::max(q * length, 1.0), -2 - 2 * hurst);
      sum += power;
      for (std::size_t i = 0; i < table_.size(); ++i)
        table_[i] += power * std::cyl_bessel_j(0, q * static_cast<double>(i) * step);
    }
    for (double& value : table_) value /= sum;
  }
  double operator()(double x, double y) const {
    const double place = std::hypot(x, y) / step;
    const auto i = static_cast<std::size_t>(place);
    if (i + 1 >= table_.size()) return 0;
    return table_[i] + (place - static_cast<double>(i)) * (table_[i + 1] - table_[i]);
  }

 private:
  static constexpr int steps = 1000;
  static constexpr double step = 0.25;
  std::vector<double> table_ = {};
};

double lay(double along, double across, double l) {
  return std::exp(-std::hypot(along / (4 * l), across / l)) * std::cos(2 * pi * across / (3 * l));
}

double share(double y) { return 0.5 * std::erfc(-y / std::numbers::sqrt2); }

// A plateau of a tenth of the valleys' roughness, above 70 % of the surface.
double plateau(double y) {
  const double edge = 0.5244005127080407;  // the normal quantile of 0.7
  return y > -edge ? 0.1 * (y + edge) : y + edge;
}

// Two normal populations, 3 standard deviations apart, smoothed into one increasing map.
double bimodal(double y) { return 0.4 * y + std::tanh(4 * y); }

}  // namespace

std::vector<Texture> all(double l) {
  auto iso = [l](double x, double y) { return exponential(x, y, l); };
  auto self_affine = [l](double hurst) {
    return [hurst, l, table = std::optional<SelfAffine>()](double x, double y) mutable {
      if (!table) table.emplace(hurst, l);
      return (*table)(x, y);
    };
  };
  return {{"exponential", iso},
          {"gaussian", [l](double x, double y) { return oriented_gaussian(x, y, l); }},
          {"self_affine_0.3", self_affine(0.3)},
          {"self_affine_0.8", self_affine(0.8)},
          {"lay_along_x", [l](double x, double y) { return lay(x, y, l); }},
          {"lay_along_y", [l](double x, double y) { return lay(y, x, l); }},
          {"two_scales",
           [l](double x, double y) { return 0.5 * (x == 0 && y == 0) + 0.5 * exponential(x, y, l); }},
          {"lognormal", iso, [](double y) { return std::exp(0.3 * y); }},
          {"Weibull", iso, [](double y) { return std::pow(-std::log(share(-y)), 1 / 1.5); }},
          {"plateau", iso, plateau},
          {"bimodal", iso, bimodal},
          {"crossed", [l](double x, double y) { return 0.5 * (lay(x, y, l) + lay(y, x, l)); }},
          {"chi_squared", iso, [](double y) { return y * y; }},
          {"levels", iso, [](double y) { return std::clamp(std::floor(1.6 * y), -4.0, 3.0); }}};
}

namespace {

// The share of the heights' variance in each orthonormal Hermite polynomial of the Gaussian height, from the
// first on.
std::array<double, 40> hermite_shares(const std::function<double(double)>& heights) {
  constexpr double end = 8, step = 1e-3;
  std::array<double, 40> c{};
  for (double y = -end; y <= end; y += step) {
    const double weighted = heights(y) * std::exp(-y * y / 2);
    double before = 0, here = 1;
    for (std::size_t k = 1; k <= c.size(); ++k) {
      const double n = static_cast<double>(k);
      before = std::exchange(here, (y * here - std::sqrt(n - 1) * before) / std::sqrt(n));
      c[k - 1] += weighted * here;
    }
  }
  double sum = 0;
  for (double& value : c) sum += value *= value;
  for (double& value : c) value /= sum;
  return c;
}

}  // namespace

LagField correlation_of_heights(const Texture& texture, Shape max_lag, Index reach) {
  std::array<double, 40> shares{1};
  if (texture.heights) shares = hermite_shares(texture.heights);
  return LagField::of(max_lag, [&](Index p, Index q) {
    if (std::max(p, std::abs(q)) > reach) return 0.0;
    const double r = texture.correlation(static_cast<double>(p), static_cast<double>(q));
    double sum = 0, power = 1;
    for (const double share : shares) sum += share * (power *= r);
    return sum;
  });
}

double correlated_points(const Texture& texture, Index reach) {
  double sum = 0;
  for (Index p = -reach; p <= reach; ++p)
    for (Index q = -reach; q <= reach; ++q)
      sum += std::pow(texture.correlation(static_cast<double>(p), static_cast<double>(q)), 2);
  return sum;
}

Draw::Draw(const Texture& texture, Shape shape, Index reach)
    : shape_(shape),
      torus_{fast_length(std::max(2 * shape.nx, shape.nx + 2 * reach), 2),
             fast_length(std::max(2 * shape.ny, shape.ny + 2 * reach), 2)},
      heights_(texture.heights),
      transform_(torus_),
      root_(static_cast<std::size_t>(transform_.spectrum_size())) {
  AlignedVector<double> rho(static_cast<std::size_t>(torus_.cells()));
  auto lag = [](Index i, Index n) { return static_cast<double>(2 * i <= n ? i : i - n); };
  for (Index i = 0; i < torus_.nx; ++i)
    for (Index j = 0; j < torus_.ny; ++j)
      rho[static_cast<std::size_t>(i * torus_.ny + j)] =
          texture.correlation(lag(i, torus_.nx), lag(j, torus_.ny));
  AlignedVector<Complex> power(root_.size());
  transform_.forward(rho.data(), power.data());
  // Of the noise's spectrum to that of the field, and the inverse transform's factor.
  const double cells = static_cast<double>(torus_.cells());
  for (std::size_t k = 0; k < root_.size(); ++k) root_[k] = std::sqrt(std::max(power[k].real(), 0.0)) / cells;
}

Field Draw::operator()(std::mt19937_64& random) const {
  std::normal_distribution<double> normal;
  AlignedVector<double> noise(static_cast<std::size_t>(torus_.cells()));
  for (double& value : noise) value = normal(random);
  AlignedVector<Complex> spectrum(root_.size());
  transform_.forward(noise.data(), spectrum.data());
  for (std::size_t k = 0; k < root_.size(); ++k) spectrum[k] *= root_[k];
  transform_.inverse(spectrum.data(), noise.data());
  const Eigen::Map<const Field> whole(noise.data(), torus_.nx, torus_.ny);
  Field out = whole.topLeftCorner(shape_.nx, shape_.ny);
  if (heights_)
    for (double& z : out.reshaped()) z = heights_(z);
  return out;
}

}  // namespace asperity::textures
