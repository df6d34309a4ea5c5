#include "transform/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gsl/gsl_sf_bessel.h>

namespace asperity {
namespace {

constexpr double bell_width = Interpolation::taps;
constexpr double beta = 0.75 * std::numbers::pi * bell_width;  // the bell's spectrum falls until 3π/2

double bell(double x) {
  const double u = 2 * x / bell_width;
  return std::abs(u) < 1 ? gsl_sf_bessel_I0(beta * std::sqrt(1 - u * u)) : 0;
}

}  // namespace

double Interpolation::prepared(double k) {
  const double g = std::sqrt(beta * beta - k * k * bell_width * bell_width / 4);
  return g / (bell_width * std::sinh(g));
}

Interpolation::Interpolation(Index s)
    : s_(s),
      lanes_(std::max<Index>(s, 8)),
      weights_(size(s * taps)),
      matrix_(size(lanes_ * (taps + lanes_ / s - 1))) {
  for (Index q = 0; q < s; ++q)
    for (Index t = 0; t < taps; ++t)
      weights_[size(q * taps + t)] =
          bell(static_cast<double>(q) / static_cast<double>(s) + static_cast<double>(before - t));
  for (Index lane = 0; lane < lanes_; ++lane)
    for (Index t = 0; t < taps; ++t)
      matrix_[size((lane / s + t) * lanes_ + lane)] = weights_[size(lane % s * taps + t)];
}

void Interpolation::refine(const double* samples, Index count, double* out) const {
  using Lanes = Eigen::Array<double, 8, 1>;
  const Index around = taps + lanes_ / s_ - 1;
  for (Index j = 0; j < count; j += lanes_, samples += lanes_ / s_)
    for (Index first = 0; first < lanes_; first += 8) {
      const double* column = matrix_.data() + first;
      Lanes sum = Lanes::Zero();
      for (Index t = 0; t < around; ++t, column += lanes_)
        sum += Eigen::Map<const Lanes>(column) * samples[t];
      Eigen::Map<Lanes>(out + j + first) = sum;
    }
}

}  // namespace asperity
