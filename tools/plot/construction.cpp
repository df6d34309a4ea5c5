#include "tools/plot/construction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tools/plot/text.hpp"

namespace asperity::plot {
namespace {

constexpr double line_height = 1.3, half_line = 0.5 * line_height;  // [em]
constexpr double from_line = 0.5, step_up = 0.25;                   // [em]

struct Box {
  double left, right, low, high;

  bool meets(const Box& b) const { return left < b.right && b.left < right && low < b.high && b.low < high; }
};

// The panel in em from its lower left corner.
struct Sheet {
  const Construction& of;
  Range heights;
  double width, height;

  double x(double percent) const { return 0.01 * percent * width; }
  double y(double z) const { return (z - heights.low) / heights.width() * height; }

  // How many of the lines go through a box: the curve, the core line, both ends of the core.
  int crossings(const Box& box) const {
    const double upper = y(of.core.upper), lower = y(of.core.lower);
    auto core = [&](double at) { return upper + (lower - upper) * at / width; };
    int out = (core(box.right) < box.high && core(box.left) > box.low) ? 1 : 0;
    for (const double at : {upper, lower}) out += box.low < at && at < box.high ? 1 : 0;
    Range within{unlimited, -unlimited};  // of the curve, which falls
    const auto points = of.curve.rows();
    for (Index k = 0; k + 1 < points; ++k)
      if (x(of.curve(k + 1, 0)) > box.left && x(of.curve(k, 0)) < box.right)
        within = united(within, {y(of.curve(k + 1, 1)), y(of.curve(k, 1))});
    return out + (within.low < box.high && box.low < within.high ? 1 : 0);
  }
};

// ---- lengths beside the panel ----

struct Length {
  const char* name;
  Range of;
  double at = 0;  ///< of its label [em]
};

// Moves labels apart, from below and then back from the upper end.
void spread(std::vector<Length>& labels, double height) {
  std::ranges::sort(labels, {}, &Length::at);
  double least = half_line;
  for (Length& l : labels) l.at = std::max(l.at, least), least = l.at + line_height;
  double most = height - half_line;
  for (auto l = labels.rbegin(); l != labels.rend(); ++l)
    l->at = std::min(l->at, most), most = l->at - line_height;
}

std::vector<Length> lengths_of(const Sheet& sheet) {
  const Construction& c = sheet.of;
  std::vector<Length> out;
  for (const auto& [name, all] : {std::pair{"Spk", Range{c.core.upper, c.peak()}},
                                  {"Sk", Range{c.core.lower, c.core.upper}},
                                  {"Svk", Range{c.dale(), c.core.lower}}}) {
    const Range shown{std::max(all.low, sheet.heights.low), std::min(all.high, sheet.heights.high)};
    if (shown.low < shown.high) out.push_back({name, shown, sheet.y(0.5 * (shown.low + shown.high))});
  }
  return out;
}

void add_lengths(Figure& figure, Script& script, const Sheet& sheet) {
  std::vector<Length> labels = lengths_of(sheet);
  while (!labels.empty() && static_cast<double>(labels.size()) * line_height > sheet.height) {
    const auto shortest = std::ranges::min_element(labels, {}, [](const Length& l) { return l.of.width(); });
    figure.notes.push_back(fmt::format("{} has no room beside the panel: give more height", shortest->name));
    labels.erase(shortest);
  }
  spread(labels, sheet.height);
  for (const Length& l : labels) {
    script.line(
        "set arrow from graph 1.03,graph {} to graph 1.03,graph {} heads size screen 0.006,90 "
        "linewidth 1",
        sheet.y(l.of.low) / sheet.height, sheet.y(l.of.high) / sheet.height);
    script.line("set label {} at graph 1.05,graph {} left noenhanced", gnuplot_string(l.name),
                l.at / sheet.height);
  }
}

// ---- ratios in the panel ----

struct Ratio {
  const char* name;
  double share;
  bool inner_right;  ///< the core lies on its right
};

// Beside its line: the place with the fewest crossings, the lowest of them, the inner one of these.
std::optional<Box> place_of(const Sheet& sheet, const Ratio& r, double length,
                            const std::vector<Box>& taken) {
  std::optional<Box> out;
  int fewest = 0;
  const double at = sheet.x(100 * r.share);
  for (double y = 0.8; y + half_line <= sheet.height; y += step_up)
    for (const bool right : {r.inner_right, !r.inner_right}) {
      const double left = right ? at + from_line : at - from_line - length;
      const Box box{left, left + length, y - half_line, y + half_line};
      const bool free = box.left >= 0 && box.right <= sheet.width &&
                        std::ranges::none_of(taken, [&](const Box& b) { return b.meets(box); });
      const int crossings = free ? sheet.crossings(box) : 0;
      if (free && (!out || crossings < fewest)) out = box, fewest = crossings;
    }
  return out;
}

void add_ratios(Figure& figure, Script& script, const Sheet& sheet) {
  std::vector<Box> taken;
  const CoreParameters& core = sheet.of.core;
  for (const Ratio& r : {Ratio{"Smr1", core.smr1, true}, {"Smr2", core.smr2, false}}) {
    const std::string text = fmt::format("{} = {} %", r.name, brief(100 * r.share));
    const auto box = place_of(sheet, r, length_of(text), taken);
    if (!box) {
      figure.notes.push_back(text + " has no room in the panel: give more width");
      continue;
    }
    taken.push_back(*box);
    const bool right = box->left > sheet.x(100 * r.share);
    script.line("set label {} at graph {},graph {} {} noenhanced front", gnuplot_string(text),
                (right ? box->left : box->right) / sheet.width, 0.5 * (box->low + box->high) / sheet.height,
                right ? "left" : "right");
  }
}

}  // namespace

void add_labels(Figure& figure, std::size_t panel, const Construction& of, Range heights,
                const Layout& layout) {
  const Sheet sheet{of, heights, layout.panel_width / layout.em, layout.panel_height / layout.em};
  Script script;
  add_lengths(figure, script, sheet);
  if (!figure.comparison) add_ratios(figure, script, sheet);
  figure.panels[panel].commands.add(script);
}

}  // namespace asperity::plot
