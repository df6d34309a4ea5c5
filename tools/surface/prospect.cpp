#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "acf/kernel.hpp"
#include "core/words.hpp"
#include "marginal/johnson.hpp"
#include "tools/surface/kernel_solution.hpp"

namespace asperity::cli {
namespace {

constexpr double long_share = 0.5;     // of the variance, in one offset
constexpr double white_rest = 0.01;    // of a correlation, a sample away
constexpr double large_dataset = 1e8;  // bytes
constexpr double near_bound = 3;       // Sq
constexpr double at_bound = 0.25;      // Sq, of a peak

const char* axes(bool x, bool y) { return x && y ? "x and y" : x ? "x" : "y"; }

void warn_if_short(const Tool& tool, const KernelProblem& problem, Shape surface) {
  const Target& target = problem.request.target;
  if (target.known || !target.reach) return;
  const Shape fallen = target.reach(white_rest);
  const bool x = fallen.nx == 1 && surface.nx != 1, y = fallen.ny == 1 && surface.ny != 1;
  if (x || y)
    tool.warn(
        fmt::format("--{} is far below a sample along {}: neighbouring heights correlate by less than "
                    "{:g}, as in white noise; sample more finely",
                    problem.extent, axes(x, y), white_rest));
}

// "+1.1 Sq (436nm)"
std::string in_rms(double z, const KernelProblem& problem) {
  const std::string height =
      problem.has_height ? " (" + format_quantity(std::stod(number(z * problem.request.rms)), "m") + ")" : "";
  return fmt::format("{:+.3g} Sq", z) + height;
}

void report_bounds(const Tool& tool, const KernelProblem& problem) {
  if (!problem.marginal || problem.marginal->measured) return;
  const auto [low, high, peaks] =
      density_shape(fit_johnson(problem.marginal->skewness, problem.marginal->kurtosis));
  const bool floor = low > -near_bound, ceiling = high < near_bound;
  if (!floor && !ceiling) return;
  std::string bounds = floor ? in_rms(low, problem) : "";
  if (ceiling) bounds += (floor ? " and " : "") + in_rms(high, problem);
  const std::string words =
      "heights are bounded at " + bounds + ", Johnson's " + problem.marginal->translation.family;
  const bool at_floor = peaks.front() - low < at_bound, at_ceiling = high - peaks.back() < at_bound;
  if (peaks.size() > 1)
    tool.warn(fmt::format(
        "{}; their density has two peaks, at {:+.3g} and {:+.3g} Sq; a larger --kurtosis gives one", words,
        peaks.front(), peaks.back()));
  else if (at_floor || at_ceiling)
    tool.warn(fmt::format(
        "{}; their density is J-shaped: largest {:.2g} Sq from its {} end; a larger --kurtosis moves the "
        "peak inwards",
        words, at_floor ? peaks.front() - low : high - peaks.back(), at_floor ? "lower" : "upper"));
  else
    tool.note(words);
}

// The lags that a search may come to: those at the tolerance, where a correlation falls so slowly that these
// are far beyond the first, as of self-affine surfaces.
Shape most_lags(const KernelRequest& request) {
  constexpr double slow = 2.5;  // times as many; 1.7 of exponentials, 3.4 of self-affine surfaces
  const Shape first = first_lags(request);
  if (request.lags != Shape{} || !request.target.reach) return first;
  const Shape far = request.target.reach(std::min(request.acf_tolerance, 0.5));
  return static_cast<double>(far.cells()) > slow * static_cast<double>(first.cells()) ? far : first;
}

void warn_of_cost(const Tool& tool, const KernelRequest& request, bool kept) {
  check_memory(request, first_lags(request), kernel_cost(first_lags(request)));
  const Shape lags = most_lags(request);
  constexpr Index widest = 13;  // torus of a table of long waves, the fourth that is tried
  const bool table = request.target.known.has_value();
  if (wider_kernel_cost(lags, table ? widest : 4).dataset <= large_dataset) return;
  const auto [memory, dataset] = wider_kernel_cost(lags);
  const auto shown = [](double bytes) {
    return format_bytes(static_cast<std::size_t>(std::min(bytes, 1e18)));
  };
  tool.warn(fmt::format(
      "a kernel of {} lags may need minutes{} {} of memory{}{} need less", text(lags), kept ? "," : " and",
      shown(memory), kept ? " and " + shown(dataset) + " of the dataset" : "",
      table ? ", of long waves ten times as much; fewer lags of the table (asperity-acf --max-lag) or a "
              "larger --acf-tolerance"
            : "; shorter lengths, wider samples or a larger --acf-tolerance"));
}

// (1) of foresee(), of not more than 64 lags each way.
double mean_correlation(const Target& target, Shape surface) {
  const Index step_x = (surface.nx + 63) / 64, step_y = (surface.ny + 63) / 64;
  double sum = 0, weights = 0;
  for (Index p = 0; p < surface.nx; p += step_x)
    for (Index q = -((surface.ny - 1) / step_y) * step_y; q < surface.ny; q += step_y) {
      const double weight = (p > 0 ? 2 : 1) * (1 - static_cast<double>(p) / static_cast<double>(surface.nx)) *
                            (1 - std::abs(static_cast<double>(q)) / static_cast<double>(surface.ny));
      const bool inside = !target.known || (p < target.known->nx && std::abs(q) < target.known->ny);
      if (inside) sum += weight * target(static_cast<double>(p), static_cast<double>(q));
      weights += weight;
    }
  return sum / weights;
}

}  // namespace

void foresee_extent(const Tool& tool, const Target& target, Shape surface, const char* option) {
  if (surface.cells() <= 1) return;
  const double mean = mean_correlation(target, surface);
  if (mean > long_share)
    throw UsageError(
        option,
        fmt::format(
            "the correlation is too long for the surface: {:.0f} % of the variance would be one offset of "
            "all "
            "heights; choose a shorter length, or draw a larger surface and cut it (asperity-filter --crop)",
            100 * mean));
  const double along_x = mean_correlation(target, {surface.nx, 1}),
               along_y = mean_correlation(target, {1, surface.ny});
  const bool x = surface.nx > 1 && along_x > long_share, y = surface.ny > 1 && along_y > long_share;
  if (x || y)
    tool.warn(
        fmt::format("the correlation reaches across the surface along {}: heights correlate by {:.2g} there "
                    "on average, and one surface does not average that out",
                    axes(x, y), x ? along_x : along_y));
}

void foresee(const Tool& tool, const KernelProblem& problem, Shape surface, bool kept) {
  if (problem.band) return;  // it has the surface's own waves, and no offset
  const Target& target = problem.request.target;
  foresee_extent(tool, target, surface, problem.extent);
  warn_if_short(tool, problem, surface);
  if (!problem.torus) warn_of_cost(tool, problem.request, kept);
  report_bounds(tool, problem);
}

}  // namespace asperity::cli
