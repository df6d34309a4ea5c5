#include "contact/repeated_cell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/influence.hpp"
#include "core/parallel.hpp"
#include "math/gauss_legendre.hpp"

namespace asperity {
namespace {

constexpr double least_images = 12, least_distance = 4;  // M, and M L in cells

// (3) for a point load, times L.
double tail_of_point(double X, double y, double length, double datum) {
  const double r = std::hypot(X, y), c = X / r, c2 = c * c, s2 = (length / r) * (length / r);
  const double P3 = c * (5 * c2 - 3) / 2, P5 = c * ((63 * c2 - 70) * c2 + 15) / 8,
               P7 = c * (((429 * c2 - 693) * c2 + 315) * c2 - 35) / 16;
  return -std::log((X + r) / datum) +
         s2 * (-c / 24 + s2 * (7 * P3 / 960 + s2 * (-31 * P5 / 8064 + s2 * (127 * P7 / 30720))));
}

struct Cell {
  double a, b, length, datum;

  template <std::size_t n>
  double tail(const GaussLegendre<n>& rule, double X, double y) const {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        sum += rule.weights[i] * rule.weights[j] *
               tail_of_point(X + a * rule.nodes[i], y + b * rule.nodes[j], length, datum);
    return a * b * sum / length;
  }

  // (3); n nodes leave (size/2X)^2n of it.
  double tail(double X, double y) const {
    const double distance = X / (2 * std::max(a, b));
    if (distance < 20) return tail(gauss8, X, y);
    if (distance < 80) return tail(gauss4, X, y);
    return distance < 1000 ? tail(gauss3, X, y) : tail(gauss2, X, y);
  }

  // All cells from the second period on, ahead.
  double ahead(double x, double y) const {
    const double M = std::max(least_images, std::ceil(least_distance * 2 * std::max(a, b) / length));
    double sum = 0;
    for (double m = 2; m <= M; ++m) sum += love_integral(x + m * length, y, a, b);
    return sum + tail(x + (M + 0.5) * length, y);
  }
};

}  // namespace

RepeatedCell::RepeatedCell(double a, double b, Index period, Index rows, double datum, int threads)
    : a_(a), b_(b), length_(2 * a * static_cast<double>(period)), far_(size(rows)) {
  parallel_ranges(rows, threads, [&](Index begin, Index end, int) {
    for (Index j = begin; j < end; ++j) far_[size(j)] = far_cells(2 * b * static_cast<double>(j), datum);
  });
}

// Chebyshev's interpolation on 0 ≤ (2x/L)² ≤ 1; the nearest of these cells, at 3 or more, leave 34^-10.
RepeatedCell::Series RepeatedCell::far_cells(double y, double datum) const {
  const Cell cell{a_, b_, length_, datum};
  auto angle = [](std::size_t k) {
    return std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(points);
  };
  Series values, out{};
  for (std::size_t k = 0; k < points; ++k) {
    const double x = length_ / 2 * std::cos(angle(k) / 2);
    values[k] = cell.ahead(x, y) + cell.ahead(-x, y);
  }
  for (std::size_t l = 0; l < points; ++l) {
    for (std::size_t k = 0; k < points; ++k)
      out[l] += values[k] * std::cos(static_cast<double>(l) * angle(k));
    out[l] *= (l == 0 ? 1.0 : 2.0) / static_cast<double>(points);
  }
  return out;
}

double RepeatedCell::operator()(Index i, Index j) const {
  const double x = 2 * a_ * static_cast<double>(i), y = 2 * b_ * static_cast<double>(j);
  const Series& c = far_[size(j)];
  const double t = 2 * x / length_, v = 2 * t * t - 1;
  double first = 0, second = 0;  // Clenshaw's
  for (std::size_t l = points; l-- > 1;) second = std::exchange(first, c[l] + 2 * v * first - second);
  const double far = c[0] + v * first - second;
  return far + love_integral(x, y, a_, b_) + love_integral(x + length_, y, a_, b_) +
         love_integral(x - length_, y, a_, b_);
}

}  // namespace asperity
