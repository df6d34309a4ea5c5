// Slopes, spectral moments and peaks of a field of a single row or column: a profile.
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

// Columns of local functions: heights, their squares and those of differences, 1 where there are the
// neighbours, the spacing there, and peaks.
enum Local {
  first,
  all,
  first_square,
  second,
  sloped,
  surrounded,
  length,
  peak,
  run,
  height,
  square,
  curvature,
  local
};
using Values = Eigen::Array<double, Eigen::Dynamic, local>;

struct Line {
  Index n;
  bool periodic;

  // The place of point i, or -1.
  Index at(Index i) const { return periodic ? (i + n) % n : i < n ? i : -1; }
};

void add_peaks(Values& out, const Eigen::ArrayXd& z, const Line& line, double step) {
  const SummitRows found = find_peaks(z, step, line.periodic);
  for (std::size_t k = 0; k < found.size(); ++k)
    for (const FoundSummit& p : found[k]) {
      const Index at = line.at(static_cast<Index>(k) + 1);
      out(at, peak) = 1, out(at, run) = p.points > 1;
      out(at, height) = p.height, out(at, square) = p.height * p.height, out(at, curvature) = p.curvature;
    }
}

// NaN where a height is missing.
Values local_values(const Eigen::ArrayXd& z, const Line& line, double step) {
  Values out = Values::Zero(z.size(), local);
  out.col(first) = z, out.col(all) = z.square();
  auto set = [&](Index i, Local value, Local there, double v) {
    if (!std::isnan(v)) out(i, value) = v * v, out(i, there) = 1;
  };
  for (Index i = 0; i < z.size(); ++i) {
    const Index before = line.at(i - 1), after = line.at(i + 1);
    if (after < 0) continue;
    set(i, first_square, sloped, (z(after) - z(i)) / step);
    if (before >= 0) set(i, second, surrounded, (z(before) - 2 * z(i) + z(after)) / (step * step));
  }
  out.col(length) = step * out.col(surrounded);
  add_peaks(out, z, line, step);
  return out;
}

using Means = Eigen::VectorXd;

double m2(const Means& m) { return m(first_square) / m(sloped); }
double m4(const Means& m) { return m(second) / m(surrounded); }
double alpha(const Means& m) { return (m(all) - m(first) * m(first)) * m4(m) / (m2(m) * m2(m)); }
double peak_density(const Means& m) { return m(peak) / m(length); }
double peak_height(const Means& m) { return m(height) / m(peak) - m(first); }
double peak_deviation(const Means& m) {
  return std::sqrt(std::max(0.0, m(square) / m(peak) - std::pow(m(height) / m(peak), 2)));
}
double peak_curvature(const Means& m) { return m(curvature) / m(peak); }
double peak_radius(const Means& m) { return m(peak) / m(curvature); }

// The means of a profile, and why what rests on them has no error.
struct Profile {
  LocalMeans means;
  bool errors;
  std::string few, slopes = {}, curvatures = {}, peaks = {};

  Estimate operator()(double (*f)(const Means&), const std::string& doubt, double least = 0) const {
    const double value = means(f);
    if (!errors || !std::isfinite(value)) return {value};
    if (!few.empty()) return {.value = value, .why = few};
    if (!doubt.empty()) return {.value = value, .why = "no standard error: " + doubt};
    const WaveError error = means.error(f);
    constexpr double round_off = 1e-12;
    if (!(error.error > round_off * value && value > 0)) return {value};
    const Interval ends = Interval::of_ratio(value, error.half_width() / value);
    return {value, error.error, Interval::of(value, std::max(ends.low, std::min(least, value)), ends.high)};
  }
};

Profile profile_of(const Sample& sample, bool along_x) {
  const Grid& grid = sample.grid();
  const Surface& surface = sample.surface();
  const Line line{surface.heights.size(), along_x ? grid.periodic.x : grid.periodic.y};
  const double spacing = along_x ? grid.dx : grid.dy, part = std::pow(surface.step / spacing, 2);
  const Values values =
      local_values(surface.heights.reshaped<Eigen::RowMajor>() - sample.moments().mean, line, spacing);
  LocalSums sums(grid, local);
  sums.add_rows(grid.shape.nx, 1, [&](Index i, LocalSums::Values& row) {
    row.rightCols(local) = values.middleRows(along_x ? i : 0, row.rows()).matrix();
  });
  Profile out{sums.means(sample.extent()), sample.needs_errors(), {}};
  out.few = too_few_points(out.means, sums.count(), surrounded, "both neighbours");
  out.slopes = steps_in_slopes(surface.step, part / 6 / out.means(m2));
  out.curvatures = steps_in_curvatures(surface.step, part / 2 / (spacing * spacing) / out.means(m4));
  if (out.means([](const Means& m) { return m(run) / m(peak); }) > 0.01)
    out.peaks = "more than one in a hundred peaks is a run of equal heights";
  return out;
}

constexpr Definition<Profile> derivative_table[] = {
    {"m2_{}", "1", "mean square slope {}", [](const Profile& p) { return p(m2, p.slopes); }},
    {"m4_{}", "m-2", "mean square second derivative {}",
     [](const Profile& p) { return p(m4, p.curvatures); }},
    {"alpha_{}", "1", "bandwidth parameter m0 m4 / m2^2 {}",
     [](const Profile& p) { return p(alpha, p.curvatures, 1); }}};

template <double (*f)(const Means&)>
Estimate of_peaks(const Profile& p) {
  return p(f, p.peaks);
}

constexpr Definition<Profile> peak_table[] = {
    {"peak_density", "m-1", "peaks per length, counted", of_peaks<peak_density>},
    {"peak_height", "m", "mean height of peaks above the mean height, counted", of_peaks<peak_height>},
    {"peak_deviation", "m", "standard deviation of peak heights, counted", of_peaks<peak_deviation>},
    {"peak_curvature", "m-1", "mean curvature of peaks, counted", of_peaks<peak_curvature>},
    {"peak_radius", "m", "1 / mean curvature of peaks, counted", of_peaks<peak_radius>}};

}  // namespace

Parameters profile_derivatives(const Sample& sample, const Estimate& m0) {
  const bool along_x = sample.grid().shape.ny == 1;
  const std::string axis = along_x ? "x" : "y";
  const Profile profile = profile_of(sample, along_x);
  ParameterList out(sample.surface().units);
  out.add("m0", "m2", "spectral moment of order 0, Sq squared", m0);
  out.add(derivative_table, profile, {axis, "along " + axis, "no value: too few neighbours are measured"});
  out.add(peak_table, profile, {.why = "no value: the profile has no peak"});
  return std::move(out).with_known_errors(sample.size());
}

}  // namespace asperity
