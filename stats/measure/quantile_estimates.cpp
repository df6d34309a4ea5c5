#include "stats/measure/quantile_estimates.hpp"

#include <algorithm>
#include <cmath>

#include "stats/height/distribution.hpp"
#include "stats/height/material_ratio.hpp"
#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

// Of heights that the form has lowered by the factor `left`.
Interval freed(double height, double left, double low, double high) {
  return Interval::of(height, std::min(height, low / left), std::max(height, high / left));
}

// (1) of the header, of the field's quantiles at so many shares.
class FormSmear {
 public:
  explicit FormSmear(const Sample& sample)
      : taken_(sample.taken_by_form()), relative_error_(taken_ > 0 ? sample.error_of_taken() / taken_ : 0) {
    std::vector<double> shares(400);
    for (std::size_t k = 0; k < shares.size(); ++k)
      shares[k] = (static_cast<double>(k) + 0.5) / static_cast<double>(shares.size());
    const std::vector<double> heights = sample.quantiles(shares);
    kept_ = (1 - taken_) * Eigen::Map<const Eigen::ArrayXd>(heights.data(), std::ssize(heights));
    width_ = sample.moments().sq * std::sqrt(2 * taken_ * (1 - taken_));
  }
  double relative_error() const { return relative_error_; }  // of w
  // q' - q.
  double shift(double share, double height) const {
    if (!(taken_ > 0)) return 0;
    double low = kept_.minCoeff() - 4 * width_, high = kept_.maxCoeff() + 4 * width_;
    for (int step = 0; step < 50; ++step) {
      const double middle = 0.5 * (low + high);
      (below(middle) < share ? low : high) = middle;
    }
    return 0.5 * (low + high) - height;
  }

 private:
  double below(double height) const {
    return ((height - kept_) / width_).unaryExpr([](double u) { return 0.5 * std::erfc(-u); }).mean();
  }

  double taken_, relative_error_, width_ = 0;
  Eigen::ArrayXd kept_;
};

}  // namespace

std::string few_beyond(const Sample& sample, double share) {
  constexpr double least = 1;
  const bool few = sample.extent().patches * std::min(share, 1 - share) < least;
  return few && sample.size().gives_errors()
             ? "no standard error: less than one independent height lies beyond it"
             : "";
}

std::vector<Estimate> quantile_estimates(const Sample& sample, const std::vector<double>& shares,
                                         const std::vector<double>& heights, Origin origin) {
  std::vector<Estimate> out;
  if (origin == Origin::own_mean && !sample.distribution() && sample.correlation_gives_errors()) {
    const double left = std::sqrt(1 - sample.taken_by_form());
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const double error = material_height_error(1 - shares[i], sample.moments(), sample.size()),
                   half = half_width_95 * error;
      out.push_back({heights[i], error, freed(heights[i], left, heights[i] - half, heights[i] + half)});
    }
    return out;
  }
  const auto errors = shares.empty() ? std::nullopt : sample.quantile_errors(heights);
  auto quantiles_beside = [&](const std::vector<double>& widths) {
    std::vector<double> at;
    for (std::size_t k = 0; k < shares.size(); ++k)
      for (const double sign : {-1, 1})
        at.push_back(std::isnan(widths[k]) ? shares[k] : std::clamp(shares[k] + sign * widths[k], 0.0, 1.0));
    return sample.quantiles(at);
  };
  if (!errors) {
    for (const double height : heights) out.push_back({height});
    return out;
  }
  std::vector<double> width, half;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const WaveError of_share = (*errors)(k);
    width.push_back(of_share.error), half.push_back(of_share.half_width());
  }
  const std::vector<double> near = quantiles_beside(width), ends = quantiles_beside(half);
  const std::optional<FormSmear> form =
      origin == Origin::own_mean ? std::optional<FormSmear>(sample) : std::nullopt;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    out.push_back({heights[k]});
    out[k].why = few_beyond(sample, shares[k]);
    if (!out[k].why.empty()) continue;
    const double apart = near[2 * k + 1] - near[2 * k], share = width[k];
    if (!(apart > 0 && share > 0)) continue;  // as of heights of two values
    const double density = origin == Origin::own_mean ? 2 * share / apart : 0,
                 of_all = errors->with_mean(k, density).error / share;
    out[k].standard_error = of_all * apart / 2;
    const double shift = form ? form->shift(shares[k], heights[k]) : 0,
                 of_form = form ? half[k] / share * form->relative_error() * shift : 0;
    auto reach = [&](double apart_from_end) {
      return std::hypot(of_all * std::max(apart_from_end, 0.0), of_form);
    };
    // Where the field holds no such share, the heights beyond are as dense as those within the error.
    const double slope = half[k] / share * apart / 2,
                 below = shares[k] > half[k] ? heights[k] - ends[2 * k] : slope,
                 above = 1 - shares[k] > half[k] ? ends[2 * k + 1] - heights[k] : slope,
                 freed_height = heights[k] - shift;
    out[k].interval = Interval::of(heights[k], std::min(heights[k], freed_height - reach(below)),
                                   std::max(heights[k], freed_height + reach(above)));
  }
  return out;
}

Estimate share_above(const Sample& sample, const MaterialRatioCurve& curve, double c) {
  const Moments& m = sample.moments();
  const double level = m.mean + c, share = curve.ratio(level);
  Estimate out{.value = share, .why = few_beyond(sample, share)};
  if (!sample.needs_errors() || !out.why.empty()) return out;
  // Of classes on either side, each at most half an error of the mean wide, which is Sq/√N_eff at least.
  const double reach = std::max(m.sp - c, m.sv + c),
               width = 0.5 * m.sq / std::sqrt(std::max(sample.extent().patches, 1.0));
  const auto half = static_cast<Index>(std::clamp(std::ceil(reach / width), 1.0, 1e4));
  const HeightClasses classes(sample.surface().heights, sample.grid(), sample.extent(),
                              {level - reach, level + reach, 2 * half}, true);
  ShareErrors::Function above(classes.errors());
  for (Index b = half; b < 2 * half; ++b) above.add(b, 1);
  std::vector<Frequency> of{classes.frequency(
      above, share * sample.size().points(), [&](double delta) { return 1 - classes.below(level + delta); })};
  of[0].value = share;
  set_intervals(of, 1);
  out.standard_error = of[0].error, out.interval = of[0].interval;
  return out;
}

}  // namespace asperity
