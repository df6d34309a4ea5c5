#include "math/noise.hpp"

#include <algorithm>
#include <stdexcept>

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_version.h>

#include "core/error.hpp"

namespace asperity {
namespace {

// The finaliser of SplitMix64: each bit of the result depends on each bit of x.
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;

std::uint64_t hash(std::uint64_t seed, std::uint64_t counter, std::uint64_t row) {
  return mix(mix(mix(seed + golden) + counter + golden) + row + golden);
}

std::uint64_t below_2_32(const char* name, std::uint64_t count) {
  if (count >> 32 != 0) throw ParameterError(name, std::to_string(count) + ": must be below 2^32");
  return count;
}

// taus2 keeps three words of 32 bits, at least 2, 8 and 16, one in an unsigned long.
struct Taus2 {
  unsigned long s1, s2, s3;
};

Taus2 state_from(std::uint64_t h) {
  auto word = [&](int n) {
    return static_cast<unsigned long>(mix(h + static_cast<std::uint64_t>(n) * golden) >> 32);
  };
  return {std::max(word(1), 2ul), std::max(word(2), 8ul), std::max(word(3), 16ul)};
}

std::shared_ptr<void> taus2() {
  gsl_rng* const rng = gsl_rng_alloc(gsl_rng_taus2);
  if (rng == nullptr) throw std::bad_alloc();
  if (gsl_rng_size(rng) != sizeof(Taus2))
    throw std::runtime_error("this version of GSL has a different taus2 state");
  return {rng, gsl_rng_free};
}

}  // namespace

WhiteNoise::WhiteNoise(std::uint64_t seed, std::uint64_t surface, std::uint64_t stream, Pointwise translation)
    : seed_(seed),
      surface_(below_2_32("first", surface)),
      stream_(below_2_32("stream", stream)),
      translation_(std::move(translation)),
      taus2_(taus2()) {}
WhiteNoise::WhiteNoise(const WhiteNoise& other)
    : WhiteNoise(other.seed_, other.surface_, other.stream_, other.translation_) {}

void WhiteNoise::row(std::int64_t index, std::span<double> out) {
  auto* const rng = static_cast<gsl_rng*>(taus2_.get());
  const std::uint64_t start = hash(seed_, (stream_ << 32) + surface_, static_cast<std::uint64_t>(index));
  *static_cast<Taus2*>(gsl_rng_state(rng)) = state_from(start);
  for (double& eta : out) eta = gsl_ran_gaussian_ziggurat(rng, 1);
  if (translation_) translation_(out);
}

std::string WhiteNoise::generator() {
  return "taus2 by rows, gsl_ran_gaussian_ziggurat, GSL " + std::string(gsl_version);
}

}  // namespace asperity
