/// Coverage of the 95 % intervals of heights that are not Gaussian.
///
/// Of FIELDS fields of 128 × 128 points, in per cent, those whose interval holds the truth of the mean, Sa,
/// Sq, Ssk and Sku. Fields are white noise averaged over w × w neighbours and translated by Johnson's
/// distribution of this skewness and kurtosis. `law` says what the errors rest on: "drawn", that distribution
/// and the correlation below it (stats/uncertainty/translation_error.hpp); "evident", what the field itself
/// shows of both; "gaussian", the intervals of Gaussian heights with the correlation estimated, for
/// comparison. The standard error of a count is √(0.05 · 0.95 / FIELDS).
///
///     heights_coverage [FIELDS]     400 unless given
#include <algorithm>
#include <array>
#include <cstdlib>

#include "acf/kernel.hpp"
#include "marginal/johnson.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/moment_interval.hpp"
#include "stats/uncertainty/translation_error.hpp"
#include "surface/synthesis.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

const Grid grid{{128, 128}, 1, 1, false};

// The truth, and how often each interval held it.
class Coverage {
 public:
  explicit Coverage(const Translation& g) {
    const NormalQuadrature law(NormalQuadrature::step_for(g) / 8);  // for the corner of |g|
    const HeightMoments shape = height_moments(g);
    truth_ = {0, (law.weights * law.heights(g).abs()).sum(), 1, shape.skewness, shape.kurtosis};
  }
  void count(const MomentIntervals& i) {
    const std::array<Interval, 5> intervals{i.mean, i.sa, i.sq, i.ssk, i.sku};
    for (std::size_t k = 0; k < 5; ++k)
      held_[k] += intervals[k].low <= truth_[k] && truth_[k] <= intervals[k].high;
    ++fields_;
  }
  void print(const char* law) const {
    fmt::print("\t{}", law);
    for (double held : held_) fmt::print("\t{:.1f}", 100 * held / fields_);
    fmt::print("\n");
  }

 private:
  std::array<double, 5> truth_, held_{};
  double fields_ = 0;
};

// What a field shows of its own distribution.
MomentIntervals evident(const Moments& m, const LagField& acf, const EffectiveSampleSize& size) {
  const auto g = evident_translation(m, standard_errors(m, size));
  if (!g) return confidence_intervals(m, size);
  const LagField below = underlying_correlation(acf, CorrelationMap(*g));
  return confidence_intervals(m, TranslationErrors(*g, EffectiveSampleSize::of_estimate(below, grid)), size);
}

void print_rows(double skewness, double kurtosis, Index width, int fields) {
  const Translation g = johnson_translation(skewness, kurtosis);
  const CorrelationMap map(g);
  const Field kernel = Field::Constant(width, width, 1 / static_cast<double>(width));
  const LagField rho(autocorrelation(kernel, width, 2 * width - 1));
  const EffectiveSampleSize below(rho, grid),
      size(LagField(rho.half_plane().unaryExpr([&](double r) { return map(r); })), grid);
  const TranslationErrors errors(g, below);
  const Synthesis synthesis(kernel, grid.shape, {.translation = g.apply});
  Coverage drawn(g), own(g), gaussian(g);
  for (int f = 0; f < fields; ++f) {
    const Field z = synthesis.surface(WhiteNoise(3, static_cast<std::uint64_t>(f)));
    const Moments m = moments(z);
    const LagField acf = estimate_autocorrelation(z, grid, {.max_lag = default_max_lag(grid)});
    const EffectiveSampleSize estimated = EffectiveSampleSize::of_estimate(acf, grid);
    drawn.count(confidence_intervals(m, errors, size));
    own.count(evident(m, acf, estimated));
    gaussian.count(confidence_intervals(m, estimated));
  }
  for (const auto& [law, coverage] :
       {std::pair{"drawn", &drawn}, std::pair{"evident", &own}, std::pair{"gaussian", &gaussian}}) {
    fmt::print("{}\t{}\t{}\t{:.0f}", skewness, kurtosis, width, size.effective(2));
    coverage->print(law);
  }
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const int fields = argc > 1 ? std::max(1, std::atoi(argv[1])) : 400;
  fmt::print("# skewness\tkurtosis\twidth\tN_eff\tlaw\tmean\tSa\tSq\tSsk\tSku\n");
  for (const auto& [skewness, kurtosis] : {std::pair{0.0, 1.8}, std::pair{-0.5, 4.0}, std::pair{1.0, 6.0},
                                           std::pair{-1.3, 6.0}, std::pair{-2.0, 10.0}})
    for (Index width : {2, 4, 8}) print_rows(skewness, kurtosis, width, fields);
  return 0;
}
