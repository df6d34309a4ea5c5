/// Digits of the moments against the offset of the heights, and their time against sizes and other ways.
///
/// Heights are 1 nm rough, Gaussian, on an offset; the reference sums them in long double about the first
/// height, in three passes. `digits` are -log10 of the relative error, of Sq, Sa, Ssk and Sku (of Ssk
/// absolute, it is nearly zero). Ways:
///     asperity   two passes about a shifted origin                             stats/sample/moments.hpp
///     gsl        gsl_stats: recurrences in long double, a division a point and moment
///     naive      Σz, Σz², Σz³, Σz⁴ in one pass: what loses its digits
/// `ratio` is the time over that of reading the field once, a sum of its heights.
///
///     moments_error_time [LARGEST_N]     2048 unless given
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

#include <fmt/format.h>
#include <gsl/gsl_statistics.h>

#include "stats/sample/moments.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

using Long = long double;

Field rough(Index n, double offset) {
  std::mt19937_64 generator(1);
  std::normal_distribution<double> height(0, 1e-9);
  return Field::NullaryExpr(n, n, [&](Index, Index) { return offset + height(generator); });
}

// Sa, Sq, Ssk, Sku.
using Values = std::array<Long, 4>;

Values reference(const Field& z) {
  const Long n = static_cast<Long>(z.size()), origin = z(0, 0);
  Long mean = 0;
  for (const double height : z.reshaped()) mean += height - origin;
  mean /= n;
  std::array<Long, 5> sum{};
  for (const double height : z.reshaped()) {
    const Long d = height - origin - mean;
    sum[1] += std::abs(d);
    sum[2] += d * d;
    sum[3] += d * d * d;
    sum[4] += d * d * d * d;
  }
  const Long sq = std::sqrt(sum[2] / n);
  return {sum[1] / n, sq, sum[3] / n / (sq * sq * sq), sum[4] / n / (sq * sq * sq * sq)};
}

Values ours(const Field& z) {
  const Moments m = moments(z);
  return {m.sa, m.sq, m.ssk, m.sku};
}

Values by_gsl(const Field& z) {
  const auto n = static_cast<std::size_t>(z.size());
  const double *data = z.data(), mean = gsl_stats_mean(data, 1, n);
  const double sq = std::sqrt(gsl_stats_variance_with_fixed_mean(data, 1, n, mean));
  return {gsl_stats_absdev_m(data, 1, n, mean), sq, gsl_stats_skew_m_sd(data, 1, n, mean, sq),
          gsl_stats_kurtosis_m_sd(data, 1, n, mean, sq) + 3};
}

Values naive(const Field& z) {
  const double n = static_cast<double>(z.size()), mean = z.sum() / n, absolute = (z - mean).abs().sum() / n;
  const double s2 = z.square().sum() / n, s3 = z.cube().sum() / n, s4 = z.square().square().sum() / n;
  const double variance = s2 - mean * mean, sq = std::sqrt(variance);
  return {absolute, sq, (s3 - 3 * mean * s2 + 2 * mean * mean * mean) / (variance * sq),
          (s4 - 4 * mean * s3 + 6 * mean * mean * s2 - 3 * std::pow(mean, 4)) / (variance * variance)};
}

std::string digits(const Values& values, const Values& exact) {
  std::string out;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Long scale = i == 2 ? 1 : std::abs(exact[i]);
    const Long error = std::abs(values[i] - exact[i]) / scale;
    out += std::isfinite(error) ? fmt::format("\t{:.1f}", static_cast<double>(-std::log10(error + 1e-19L)))
                                : "\tnone";
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index largest = argc > 1 ? std::atol(argv[1]) : 2048;
  struct Way {
    const char* name;
    Values (*values)(const Field&);
  };
  const Way ways[] = {{"asperity", ours}, {"gsl", by_gsl}, {"naive", naive}};
  fmt::print("# way\tpoints\toffset_m\tdigits_Sa\tSq\tSsk\tSku\tseconds\tseconds_spread\tratio\n");
  for (Index n = 128; n <= largest; n *= 4)
    for (const double offset : {0.0, 1e-6, 1e-3, 1.0}) {
      const Field z = rough(n, offset);
      const Values exact = reference(z);
      volatile double sink = 0;
      const Seconds once = seconds_of([&] { sink = z.sum(); });
      for (const Way& way : ways) {
        const Seconds seconds = seconds_of([&] { sink = static_cast<double>(way.values(z)[0]); });
        fmt::print("{}\t{}x{}\t{:g}{}\t{:.2e}\t{:.1f}\n", way.name, n, n, offset,
                   digits(way.values(z), exact), seconds, seconds / once);
      }
    }
  return 0;
}
