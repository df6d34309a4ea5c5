#include "stats/height/material_ratio.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/words.hpp"
#include "math/hermite.hpp"

namespace asperity {
namespace {

// Those that are there; runs are sorted by a thread each and merged pairwise.
std::vector<double> sorted_descending(const Field& z, int threads) {
  std::vector<double> heights(z.data(), z.data() + z.size());
  std::erase_if(heights, [](double height) { return std::isnan(height); });
  const auto n = static_cast<Index>(heights.size()),
             runs = std::clamp<Index>(threads, 1, std::max<Index>(n, 1));
  auto at = [&](Index run) { return heights.begin() + std::min(run, runs) * n / runs; };
  parallel_ranges(runs, threads, [&](Index begin, Index end, int) {
    for (Index r = begin; r < end; ++r) std::sort(at(r), at(r + 1), std::greater<>());
  });
  for (Index width = 1; width < runs; width *= 2)
    for (Index r = 0; r + width < runs; r += 2 * width)
      std::inplace_merge(at(r), at(r + width), at(r + 2 * width), std::greater<>());
  return heights;
}

void check_share(double ratio) {
  if (!(ratio >= 0 && ratio <= 1))
    throw ParameterError("material-ratio", "'" + shortest(ratio) + "' is not a number from 0 to 1");
}

void check_shares(const std::array<double, 2>& ratios) {
  for (const double ratio : ratios) check_share(ratio);
  if (ratios[0] > ratios[1])
    throw ParameterError("material-ratio",
                         "'" + shortest(ratios[0]) + "' is above the second, " + shortest(ratios[1]));
}

// A straight piece of the curve: rank and height at either end.
struct Piece {
  double from, to, above, below;

  double width() const { return to - from; }
  double mean() const { return 0.5 * (above + below); }
  // ∫ (t - origin) c dt / width.
  double moment(double origin) const {
    return ((2 * from + to - 3 * origin) * above + (from + 2 * to - 3 * origin) * below) / 6;
  }
};

}  // namespace

MaterialRatioCurve::MaterialRatioCurve(const Field& z, int threads)
    : descending_(sorted_descending(z, threads)) {
  if (descending_.size() < 2) throw DataError("heights", "a material ratio curve needs at least two heights");
}

std::size_t MaterialRatioCurve::piece_at(double rank) const {
  return static_cast<std::size_t>(std::clamp(std::floor(rank), 0.0, last() - 1));
}

double MaterialRatioCurve::within(std::size_t k, double rank) const {
  const double fraction = rank - rank_of(k);
  return descending_[k] + fraction * (descending_[k + 1] - descending_[k]);
}

double MaterialRatioCurve::height(double ratio) const {
  check_share(ratio);
  return at(ratio * last());
}

double MaterialRatioCurve::ratio(double height) const {
  const auto below = std::lower_bound(descending_.begin(), descending_.end(), height, std::greater<>());
  if (below == descending_.begin()) return 0;
  if (below == descending_.end()) return 1;
  const auto k = static_cast<std::size_t>(below - 1 - descending_.begin());
  const double fraction = (descending_[k] - height) / (descending_[k] - *below);
  return (rank_of(k) + fraction) / last();
}

template <class Visit>
void MaterialRatioCurve::segments(double begin, double stop, Visit visit) const {
  for (std::size_t k = piece_at(begin); k + 1 < descending_.size() && rank_of(k) < stop; ++k) {
    const double first = std::max(begin, rank_of(k)), end = std::min(stop, rank_of(k + 1));
    visit(Piece{first, end, within(k, first), within(k, end)});
  }
}

// ∫ (c - level) dp.
double MaterialRatioCurve::area(double from, double to, double level) const {
  long double sum = 0;
  segments(from * last(), to * last(),
           [&](const Piece& piece) { sum += piece.width() * (piece.mean() - level); });
  return static_cast<double>(sum) / last();
}

double MaterialRatioCurve::round_off() const {
  constexpr double ulps = 256;
  return ulps * std::numeric_limits<double>::epsilon() *
         std::max(std::abs(descending_.front()), std::abs(descending_.back()));
}

// Without a width in ranks that is rounded where it is whole: a step of equal heights would be cut.
double MaterialRatioCurve::core_span() const { return 2 * last() / 5; }

// The fall over the core's width changes its slope only where either end passes a corner of the curve.
template <class Visit>
void MaterialRatioCurve::falls(Visit visit) const {
  const double span = core_span(), room = last() - span;
  for (std::size_t k = 0; k < descending_.size(); ++k) {
    const double rank = rank_of(k);
    if (rank <= room) visit(rank, descending_[k] - at(rank + span));
    if (rank >= span) visit(rank - span, at(rank - span) - descending_[k]);
  }
}

// The rank where the first of them begins.
double MaterialRatioCurve::flattest() const {
  double least = std::numeric_limits<double>::infinity(), first = least;
  falls([&](double, double fall) { least = std::min(least, fall); });
  falls([&](double start, double fall) {
    if (fall <= least + round_off()) first = std::min(first, start);
  });
  return first;
}

MaterialRatioCurve::Line MaterialRatioCurve::line_from(double start) const {
  const double width = core_span(), middle = start + 0.5 * width;
  long double level = 0, tilt = 0;
  segments(start, start + width, [&](const Piece& piece) {
    level += piece.width() * piece.mean();
    tilt += piece.width() * piece.moment(middle);
  });
  const double centre = static_cast<double>(level) / width;
  const double slope = 12 * static_cast<double>(tilt) / (width * width * width);  // per rank, ≤ 0
  return {centre - slope * middle, centre + slope * (last() - middle)};
}

CoreParameters MaterialRatioCurve::core() const {
  const double start = flattest();
  const auto [upper, lower] = line_from(start);
  const double tiny = round_off();
  auto length = [&](double value) { return value > tiny ? value : 0; };

  CoreParameters out{.sk = length(upper - lower),
                     .smr1 = ratio(upper + tiny),
                     .smr2 = ratio(lower - tiny),
                     .upper = upper,
                     .lower = lower,
                     .begin = start / last()};
  if (out.smr1 > 0) out.spk = length(2 / out.smr1 * area(0, out.smr1, upper));
  if (out.smr2 < 1) out.svk = length(-2 / (1 - out.smr2) * area(out.smr2, 1, lower));
  out.spkx = length(descending_.front() - upper), out.svkx = length(lower - descending_.back());
  out.sak1 = out.smr1 * out.spk / 2, out.sak2 = (1 - out.smr2) * out.svk / 2;
  return out;
}

double MaterialRatioCurve::fall(const std::array<double, 2>& ratios) const {
  check_shares(ratios);
  return height(ratios[0]) - height(ratios[1]);
}

VolumeParameters MaterialRatioCurve::volumes(double p, double q) const {
  check_shares({p, q});
  const double upper = height(p), lower = height(q);
  const double peak = area(0, p, upper), dale = 0 - area(q, 1, lower);
  auto volume = [tiny = round_off()](double value) { return value > tiny ? value : 0; };
  return {.vmp = volume(peak),
          .vmc = volume(area(0, q, lower) - peak),
          .vvc = volume(0 - area(p, 1, upper) - dale),
          .vvv = volume(dale)};
}

double material_height_error(double ratio, const Moments& moments, const EffectiveSampleSize& size,
                             Fitted fitted) {
  check_share(ratio);
  if (ratio == 0 || ratio == 1) return std::numeric_limits<double>::infinity();
  const double a = gsl_cdf_ugaussian_Qinv(ratio), density = gsl_ran_ugaussian_pdf(a);
  const bool sq_fitted = fitted == Fitted::mean_and_sq;
  HermiteFunction hermite(a, 1.0);
  auto weight = [&](int k) {
    const double h = hermite.next();
    return k == 1 || (k == 2 && sq_fitted) ? 0 : h * h / k;
  };
  const double all = ratio * (1 - ratio) / (density * density) - 1 - (sq_fitted ? a * a / 2 : 0);
  return moments.sq * std::sqrt(size.variance_of_mean(weight, all));
}

std::vector<QuantilePoint> quantile_plot(const MaterialRatioCurve& curve, const Moments& moments,
                                         const EffectiveSampleSize& size, int rows) {
  if (rows < 1) throw ParameterError("rows", "'" + std::to_string(rows) + "' is below 1");
  std::vector<QuantilePoint> out(static_cast<std::size_t>(rows));
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double share = (static_cast<double>(i) + 0.5) / rows, x = gsl_cdf_ugaussian_Pinv(share);
    out[i] = {.share = share,
              .normal = x,
              .height = curve.quantile(share),
              .height_error = material_height_error(1 - share, moments, size),
              .gaussian = moments.mean + moments.sq * x,
              .misfit_error = material_height_error(1 - share, moments, size, Fitted::mean_and_sq)};
  }
  return out;
}

}  // namespace asperity
