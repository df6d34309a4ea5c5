#include "transform/chirp.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

ChirpTransform::ChirpTransform(Index terms, Index values, double theta)
    : terms_(terms),
      values_(values),
      theta_(theta),
      transform_(fast_length(terms + values - 1), 1),
      given_(size(transform_.size())),
      found_(given_.size()),
      symbol_(given_.size()),
      phase_(size(std::max(terms, values))) {
  const Index points = transform_.points();
  for (Index k = 0; k < std::ssize(phase_); ++k) phase_[size(k)] = chirp(k, 1);
  for (Index m = 0; m < values; ++m) given_[size(m)] = chirp(m, -1) / static_cast<double>(points);
  for (Index k = 1; k < terms; ++k) given_[size(points - k)] = chirp(k, -1) / static_cast<double>(points);
  transform_.forward(given_.data(), symbol_.data());
}

// exp(±iθk²/2).
Complex ChirpTransform::chirp(Index k, double sign) const {
  const double turns = theta_ / (4 * std::numbers::pi) * static_cast<double>(k * k);
  return std::polar(1.0, sign * 2 * std::numbers::pi * (turns - std::floor(turns)));
}

const Complex* ChirpTransform::apply() {
  for (Index k = 0; k < terms_; ++k) given_[size(k)] *= phase_[size(k)];
  std::fill(given_.begin() + terms_, given_.begin() + transform_.points(), Complex{});
  transform_.forward(given_.data(), found_.data());
  for (Index k = 0; k < transform_.points(); ++k) found_[size(k)] *= symbol_[size(k)];
  transform_.inverse(found_.data(), given_.data());
  for (Index m = 0; m < values_; ++m) given_[size(m)] *= phase_[size(m)];
  return given_.data();
}

}  // namespace asperity
