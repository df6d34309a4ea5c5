// Steps that change heights at their points: form and waves, and single points by those around them.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/morphology.hpp"
#include "stats/filter/outliers.hpp"
#include "stats/filter/row_alignment.hpp"
#include "stats/height/distribution.hpp"
#include "stats/uncertainty/aligned_share.hpp"
#include "tools/filter/chain.hpp"
#include "tools/measure/preparation_words.hpp"

namespace asperity::cli {
namespace {

// ---- form and waves ----

// "a dome of radius 5mm; ", of what is no polynomial.
std::string words_of(const WithoutForm& found, Form::Kind kind) {
  if (kind == Form::Kind::polynomial) return "";
  std::string out = (found.radius > 0 ? "a dome" : "a bowl") + std::string(" of radius ") +
                    figure(std::abs(found.radius), "m");
  if (kind == Form::Kind::cylinder)
    out += ", axis at " + in_digits(found.axis * 180 / std::numbers::pi, 4) + "deg";
  return out + "; ";
}

Act without_form(const std::string& value) {
  return [form = parse_form("remove-form", value)](const Tool& tool, Surface& surface) -> StepReport {
    if (form.kind != Form::Kind::polynomial) check_lengths(surface, "the radius of a form");
    WithoutForm found = asperity::without_form(surface.heights, surface.grid, form, tool.thread_count());
    const Field former = std::exchange(surface.heights, std::move(found.heights));
    surface.degree = std::max(surface.degree, form.modes());
    const Removal removal(former, surface.heights);
    std::string words = words_of(found, form.kind) + removal.words(surface.units);
    const Index lost = missing_in(surface.heights) - missing_in(former);
    if (lost > 0) words += "; " + share_of(lost, former.size()) + " lie beyond it and are missing now";
    const bool poor = form.kind != Form::Kind::polynomial && !removal.most();
    if (poor) words += "; no more was removed than is left: --crop the map to the " + form.words();
    return {words, poor || lost > 0};
  };
}

// The waves on one side of the cut-off stay.
template <bool longer_stay>
StepReport filtered(const std::string& option, const Cutoff& cutoff, const Tool& tool, Surface& surface) try {
  check_cutoff(option, cutoff, surface.grid);
  warn_of_cutoff(tool, cutoff, surface.grid);
  MeanSurface waves = mean_surface(surface.heights, surface.grid, cutoff, tool.thread_count());
  if (!longer_stay) surface.degree = degree_behind(surface.degree, surface.grid, cutoff);
  if (!longer_stay) waves.surface = surface.heights - waves.surface;
  const Field former = std::exchange(surface.heights, std::move(waves.surface));
  return {removed(former, surface.heights, surface.units), false, waves.doubt};
} catch (const ParameterError& error) {
  throw ParameterError(option, error.what());
}

Act short_waves_removed(const std::string& value) {
  return [cutoff = parse_cutoff("lambda-s", value)](const Tool& tool, Surface& surface) {
    return filtered<true>("lambda-s", cutoff, tool, surface);
  };
}

Act long_waves_removed(const std::string& value) {
  return [cutoff = parse_cutoff("lambda-c", value)](const Tool& tool, Surface& surface) {
    return filtered<false>("lambda-c", cutoff, tool, surface);
  };
}

// "moved 31 of 1024 points, by 0.2um at most; removed …"
std::string moved(const Field& before, const Surface& now) {
  const Field difference = (now.heights - before).abs();
  const double most = std::max(0.0, difference.maxCoeff<Eigen::PropagateNumbers>());
  return fmt::format("moved {}, by {} at most; {}", share_of((difference > 0).count(), difference.size()),
                     figure(most, now.units), removed(before, now.heights, now.units));
}

template <auto filter>
Act by_ball(const char* option, const std::string& value) {
  const double radius = parse_quantity(option, value, "m");
  if (!(radius > 0 && std::isfinite(radius))) refuse(option, value, "is not a positive length");
  return [radius](const Tool& tool, Surface& surface) -> StepReport {
    check_lengths(surface, "the radius of a ball");
    const StructuringElement ball{StructuringElement::Kind::ball, radius};
    Field now = filter(surface.heights, surface.grid, ball, tool.thread_count());
    const Field former = std::exchange(surface.heights, std::move(now));
    return {moved(former, surface)};
  };
}

Act closed(const std::string& value) { return by_ball<closing>("closing", value); }
Act opened(const std::string& value) { return by_ball<opening>("opening", value); }

// The points of a width in samples, or in metres.
Shape window_of(const SampledLength& width, const Grid& grid) {
  if (!width.samples) return median_window(grid, width.value);
  const auto count = [&](Index n) { return std::min(static_cast<Index>(width.value), (n - 1) / 2 * 2 + 1); };
  return {count(grid.shape.nx), count(grid.shape.ny)};
}

// "5px" are whole and, from `least` on, odd.
SampledLength width_of(const std::string& option, const std::string& text, int least) {
  const SampledLength width = parse_length(option, text);
  const bool odd = std::fmod(width.value, 2) == 1 && width.value >= least && width.value <= 1 << 20;
  if (width.samples && !odd)
    refuse(option, text, "is not an odd number of points, " + std::to_string(least) + "px or more");
  if (!(width.value > 0 && std::isfinite(width.value))) refuse(option, text, "is not a positive length");
  return width;
}

Act median(const std::string& value) {
  return [width = width_of("median", value, 3)](const Tool& tool, Surface& surface) -> StepReport {
    const Shape window = window_of(width, surface.grid);
    Field now = median_surface(surface.heights, surface.grid, window, tool.thread_count());
    const Field former = std::exchange(surface.heights, std::move(now));
    return {"windows of " + text(window) + " points; " + moved(former, surface)};
  };
}

// ---- scan lines ----

int degree_of(const std::string& method) {
  return method == "mean" ? 0 : to_number<int>(method).value_or(-1);
}

// "2", "median,y".
RowAlignment alignment_of(const std::string& value) {
  using enum RowAlignment::Method;
  const char* name = "align-rows";
  const std::vector<std::string> words = split(value, ',');
  RowAlignment out;
  if (words.size() > 2 || (words.size() == 2 && words[1] != "x" && words[1] != "y"))
    refuse(name, value, "is not METHOD, METHOD,x or METHOD,y");
  if (words.size() == 2 && words[1] == "y") out.along = Axis1D::y;
  const std::string& method = words.front();
  if (method == "median" || method == "median-difference" || method == "jumps") {
    out.method = method == "median" ? median : method == "jumps" ? jumps : median_difference;
    return out;
  }
  const int degree = degree_of(method);
  if (degree < 0 || degree > largest_form_degree)
    refuse(name, method,
           "is none of median|mean|median-difference|jumps, nor a degree from 0 to " +
               std::to_string(largest_form_degree));
  out.method = polynomial, out.degree = degree;
  return out;
}

// "2 of 255 steps between lines jump, by 4nm at most; ", of jumps.
std::string words_of(const AlignedRows& aligned, const RowAlignment& how, const std::string& units) {
  if (how.method != RowAlignment::Method::jumps) return "";
  const std::string steps = counted(aligned.lines - 1, "step") + " between lines ";
  if (aligned.jumps == 0) return "none of " + steps + "jumps; ";
  return std::to_string(aligned.jumps) + " of " + steps + "jump, by " + figure(aligned.largest, units) +
         " at most; ";
}

Act rows_aligned(const std::string& value) {
  return [asked = alignment_of(value)](const Tool& tool, Surface& surface) -> StepReport {
    RowAlignment how = asked;
    const HeightSteps steps = height_steps(surface.heights);
    how.step = steps.values > 2 ? steps.step : 0;
    AlignedRows aligned = aligned_rows(surface.heights, surface.grid, how);
    const TakenByAlignment taken = taken_by_alignment(aligned, surface.grid, how, tool.thread_count());
    constexpr double least_share = 1e-9;  // beyond round-off
    const auto left = [](double share) { return 1 - share * share; };
    if (taken.share > least_share) surface.aligned = std::sqrt(1 - left(surface.aligned) * left(taken.share));
    const Field former = std::exchange(surface.heights, std::move(aligned.heights));
    std::string words =
        words_of(aligned, how, surface.units) + removed(former, surface.heights, surface.units);
    if (taken.share > least_share)
      words += fmt::format(
          "; {} of the surface itself, {} % of its Sq",
          taken.all ? "all of that may be" : "some " + figure(taken.rms, surface.units) + " rms of that are",
          in_digits(100 * taken.share, 2));
    return {std::move(words), true};
  };
}

// ---- points ----

// "2.1nm over 1 point, 6.3nm over 3".
std::string words_of(const std::vector<Outliers::Scale>& scales, bool profile, const std::string& units) {
  std::string out;
  for (const auto& [width, deviation] : scales) {
    if (std::isnan(deviation)) continue;
    const Index points = std::max(width.nx, width.ny);
    const bool oblong = !profile && width.nx != width.ny;
    out += (out.empty() ? "" : ", ") + figure(deviation, units) + " over " +
           (oblong        ? text(width)
            : out.empty() ? counted(points, "point")
                          : std::to_string(points));
  }
  return out;
}

std::string words_of(const Outliers& found, double bound, const std::string& units) {
  const auto all = static_cast<double>(found.heights.size());
  std::string out =
      share_of(found.removed, found.heights.size()) +
      " made missing: " + (found.removed > 0 ? "they stand" : "none stands") +
      " out from all sides by more than " + shortest(bound) + " standard deviations of the surface there (" +
      words_of(found.scales, found.heights.rows() == 1 || found.heights.cols() == 1, units) + ")";
  if (static_cast<double>(found.removed) > std::max(5.0, 1e-4 * all))
    out += "; or the surface itself is spiky: " + in_digits(100 * found.spiky, 2) +
           " % of all heights lie beyond " + shortest(bound) + " robust deviations";
  return out;
}

Act outliers(const std::string& value) {
  const std::size_t comma = std::min(value.find(','), value.size());
  const auto bound = to_number<double>(value.substr(0, comma));
  if (!bound || !(*bound > 0 && std::isfinite(*bound)))
    refuse("outliers", value, "does not begin with a number of deviations above 0");
  const SampledLength width =
      width_of("outliers", comma == value.size() ? "3px" : value.substr(comma + 1), 1);
  return [bound = *bound, width](const Tool& tool, Surface& surface) -> StepReport {
    const HeightSteps steps = height_steps(surface.heights);
    Outliers found = without_outliers(
        surface.heights, surface.grid,
        {bound, window_of(width, surface.grid), steps.values > 2 ? steps.step : 0}, tool.thread_count());
    std::string words = words_of(found, bound, surface.units);
    surface.heights = std::move(found.heights);
    return {std::move(words), true};
  };
}

constexpr std::array fillings{"laplace", "mean", "least"};  // in the order of Filling

Act fill(const std::string& value) {
  const auto* word = std::ranges::find(fillings, value);
  if (word == fillings.end()) refuse("fill", value, "is none of laplace|mean|least");
  return
      [filling = static_cast<Filling>(word - fillings.begin())](const Tool&, Surface& surface) -> StepReport {
        const Index holes = missing_in(surface.heights);
        surface.heights = filled(std::move(surface.heights), surface.grid, filling);
        surface.filled += static_cast<double>(holes) / static_cast<double>(surface.heights.size());
        return {"filled " + share_of(holes, surface.heights.size()), true};
      };
}

Act scale(const std::string& value) {
  const auto factor = to_number<double>(value);
  if (!factor || *factor == 0 || !std::isfinite(*factor)) refuse("scale", value, "is not a number besides 0");
  return [factor = *factor](const Tool&, Surface& surface) -> StepReport {
    surface.heights *= factor;
    return {"multiplied by " + shortest(factor)};
  };
}

}  // namespace

std::vector<StepKind> value_steps() {
  const char *group = "Form and waves", *points = "Points";
  return {
      {"remove-form", form_kind, "Subtract a form: " + form_words, group, without_form},
      {"lambda-s", cutoff_kind, "Keep the waves longer than this, by the S-filter. " + filter_words, group,
       short_waves_removed},
      {"lambda-c", cutoff_kind, "Keep the waves shorter than this, by the L-filter. FILTER as of --lambda-s",
       group, long_waves_removed},
      {"align-rows", "METHOD[,AXIS]",
       "Put the scan lines along AXIS, x or y, level with each other, by what METHOD finds of each; median, "
       "mean, a degree K: its polynomial; median-difference: the sum of the medians of the differences of "
       "neighbours; jumps: that of those alone that stand out of all. median,y; default AXIS: x. It takes "
       "waves of the surface too: the history tells how much, and later tools warn of what it touches",
       group, rows_aligned},
      {"closing", "RADIUS",
       "Fill the valleys that a ball of this radius does not reach from above: morphological closing", group,
       closed},
      {"opening", "RADIUS", "Cut the summits that a ball does not reach from below", group, opened},
      {"median", "WIDTH", "Put the median of a window in place of each height; 5px, 10um", group, median},
      {"outliers", "K[,WIDTH]",
       "Make points missing that stand out from all sides by more than K standard deviations of the surface "
       "there, alone or up to WIDTH wide; 5, 5,3px, 5,2um. Default WIDTH: 3px. The map's corners, which have "
       "no two sides, are not judged",
       points, outliers},
      {"fill", "laplace|mean|least",
       "Fill missing points; laplace: with a membrane over each hole (Laplace's equation), mean: with the "
       "mean height, least: with the smallest height",
       points, fill},
      {"scale", "NUMBER", "Multiply the heights; -1 turns summits into valleys", points, scale}};
}

}  // namespace asperity::cli
