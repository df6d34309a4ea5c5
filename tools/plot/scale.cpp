#include "tools/plot/scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"

namespace asperity::plot {
namespace {

constexpr double narrowest = 1e-13;                            // of the numbers
constexpr double least_drawn = 1e-290, largest_drawn = 1e300;  // that steps and units can be found for
constexpr double most_multiples = 1000;

}  // namespace

Range drawable(Range r) {
  if (!(std::abs(r.low) <= largest_drawn && std::abs(r.high) <= largest_drawn))
    throw DataError("picture", fmt::format("values beyond {:g} cannot be drawn", largest_drawn));
  if (r.width() > std::max(narrowest * r.magnitude(), least_drawn)) return r;
  const double half = r.magnitude() > least_drawn ? 0.05 * r.magnitude() : 0.5;
  return {r.low - half, r.high + half};
}

double Range::magnitude() const { return std::max(std::abs(low), std::abs(high)); }

Range range_of(const Field& values) {
  Range out{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double v : values.reshaped<Eigen::RowMajor>())
    if (std::isfinite(v)) out = {std::min(out.low, v), std::max(out.high, v)};
  return out.low <= out.high ? out : Range{0, 0};
}

Range united(Range a, Range b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

double round_step(double width, double most_steps) {
  const double least = width / most_steps, decade = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * decade >= least * (1 - 1e-9)) return digit * decade;
  return 10 * decade;
}

std::vector<double> multiples(Range range, double step) {
  const double slack = 1e-9 * step, first = std::ceil((range.low - slack) / step),
               number = std::floor((range.high + slack) / step) - first + 1;
  std::vector<double> out;
  if (!(number <= most_multiples)) return out;
  for (double k = 0; k < number; ++k) out.push_back((first + k) * step + 0.0);
  return out;
}

std::string brief(double value) {
  const char* sign = value < 0 ? "−" : "";
  const std::string out = fmt::format("{:.3g}", std::abs(value));
  const auto e = out.find('e');
  if (e == out.npos) return sign + out;
  const int power = std::stoi(out.substr(e + 1));
  if (power > 0 && power < 6) return fmt::format("{}{:.0f}", sign, std::stod(out));
  return fmt::format("{}{}·10{}", sign, out.substr(0, e), cli::superscript(power));
}

const std::vector<std::string>& control_colours(Palette palette) {
  static const std::vector<std::string> viridis{"#440154", "#482576", "#414487", "#35608d",
                                                "#2a788e", "#21908c", "#22a884", "#43bf71",
                                                "#7ad151", "#bbdf27", "#fde725"};
  static const std::vector<std::string> diverging{"#025079", "#046fa7", "#0391d8", "#63b1f1",
                                                  "#b0d0f4", "#f1f1f1", "#f6c1b9", "#ee9286",
                                                  "#df6258", "#cb262c", "#9b0218"};
  return palette == Palette::sequential ? viridis : diverging;
}

Colours sequential(Range values) { return {drawable(values), Palette::sequential}; }

Colours one_sided(Range values) {
  const bool near_zero = values.low >= 0 && values.low < 0.5 * values.high;
  return sequential(near_zero ? Range{0, values.high} : values);
}

Colours about_zero(Range values) {
  const double half = values.magnitude();
  return {drawable({-half, half}), Palette::diverging};
}

}  // namespace asperity::plot
