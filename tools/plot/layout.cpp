#include "tools/plot/layout.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "tools/plot/tics.hpp"

namespace asperity::plot {
namespace {

constexpr double em_of_single = 37.5, em_of_many = 30;  // pixels, unless the size is given
constexpr double free_aspect = 0.62, free_aspect_of_rows = 0.45;
constexpr std::size_t most_of_title = 2, most_of_legend = 3;         // lines
constexpr double beside_text = 0.6, least_of_name = 12.5;            // [em]
constexpr double least_bar = 5, line_of_bar = 1.3, most_of_bar = 6;  // [em], [em], steps
constexpr double beside_numbers = 2.6, between_numbers = 0.7;  // label, tics and gaps of a y axis; of x axes

// The width of a sheet [em]: 32 for one column, 60 for three.
double em_across(std::size_t columns) { return 18.0 + 14.0 * static_cast<double>(columns); }

// Breaks a line before an entry that does not fit; names are at most `of_name` long.
std::vector<LegendLine> lines_of(const std::vector<LegendEntry>& entries, double longest, double of_name) {
  std::vector<LegendLine> out;
  for (LegendEntry e : entries) {
    e.name = shortened(e.name, of_name);
    if (out.empty() || length_of(out.back()) + legend_gap + length_of(e) > longest) out.emplace_back();
    out.back().push_back(e);
  }
  return out;
}

// Names as long as a line, or so short that three lines take them.
std::vector<LegendLine> legend_of(const std::vector<LegendEntry>& entries, double longest) {
  double of_name = longest - key_length;
  std::vector<LegendLine> out = lines_of(entries, longest, of_name);
  while (out.size() > most_of_legend && of_name > least_of_name) {
    of_name = std::max(0.9 * of_name, least_of_name);
    out = lines_of(entries, longest, of_name);
  }
  return out;
}

// Margins that the numbers of the axes need [em].
struct Room {
  double left, right, gap;
};
Room room_for(const Figure& figure, double wide, double high) {
  Room out{figure.left, figure.right, figure.gap_x};
  Overhang most;
  bool within = false;  // numbers of y stand between panels
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    const Panel& p = figure.panels[k];
    within = within || (k % figure.columns > 0 && p.y && labels_y(figure, k));
    if (p.y) out.left = std::max(out.left, beside_numbers + longest(tics_across(*p.y, high)));
    if (!p.x) continue;
    const auto [left, right] = overhang(*p.x, wide);
    most = {std::max(most.left, left), std::max(most.right, right)};
  }
  out.right = std::max(out.right, most.right + 0.3);
  if (figure.columns > 1) out.gap = std::max(out.gap, most.left + most.right + between_numbers);
  if (within) out.gap = std::max(out.gap, out.left + most.right + between_numbers);
  return out;
}

// Of the panels, with room for labels of x above other panels.
double gap_below(const Figure& figure) {
  for (std::size_t k = 0; k + figure.columns < figure.panels.size(); ++k)
    if (figure.comparison && figure.panels[k].x && labels_x(figure, k))
      return std::max(figure.gap_y, figure.bottom);
  return figure.gap_y;
}

bool same(const std::optional<Axis>& a, const std::optional<Axis>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const double slack = 1e-9 * a->range.width();  // of positions that are sums of spacings
  return std::abs(a->range.low - b->range.low) <= slack && std::abs(a->range.high - b->range.high) <= slack &&
         a->label == b->label && a->downwards == b->downwards && a->logarithmic == b->logarithmic;
}

// Fits panels into rows of this height.
void fit(Layout& layout, double room, bool keeps_aspect) {
  if (!(room >= 2 * layout.em))
    throw ParameterError("pixels", fmt::format("'{}x{}' is too flat for this figure: give more in height",
                                               layout.pixels.nx, layout.pixels.ny));
  if (!keeps_aspect) layout.panel_height = room;
  layout.panel_width = std::min(layout.panel_width, room / (layout.panel_height / layout.panel_width));
  layout.panel_height = std::min(layout.panel_height, room);
}

void place_panels(Layout& out, const Figure& figure, const Request& request, const Room& room) {
  const double above = figure.comparison ? label_height : 0,
               top = figure.top + line_of_title * static_cast<double>(out.title.size()) +
                     line_of_legend * static_cast<double>(out.legend.size()) + above;
  const double em = out.em, n = static_cast<double>(out.columns), m = static_cast<double>(out.rows),
               gap_x = room.gap * em, gap_y = (gap_below(figure) + above) * em,
               width = em_across(out.columns) * em, frame_x = (room.left + room.right) * em + (n - 1) * gap_x,
               frame_y = (figure.bottom + top) * em + (m - 1) * gap_y;
  const double aspect = figure.aspect > 0 ? figure.aspect : out.rows > 1 ? free_aspect_of_rows : free_aspect;
  out.margin = room.left;
  out.panel_width = (width - frame_x) / n;
  out.panel_height = out.panel_width * aspect;
  out.pixels = {static_cast<Index>(std::lround(width)),
                static_cast<Index>(std::lround(frame_y + m * out.panel_height))};
  if (request.pixels.nx > 0) {
    out.pixels = request.pixels;
    fit(out, (static_cast<double>(out.pixels.ny) - frame_y) / m, figure.aspect > 0);
  }
  const double spare_x = static_cast<double>(out.pixels.nx) - frame_x - n * out.panel_width,
               spare_y = static_cast<double>(out.pixels.ny) - frame_y - m * out.panel_height;
  out.left = room.left * em + 0.5 * spare_x;
  out.bottom = figure.bottom * em + 0.5 * spare_y;
  out.step_x = out.panel_width + gap_x;
  out.step_y = out.panel_height + gap_y;
  out.panels_wide = n * out.step_x - gap_x;
  out.panels_high = m * out.step_y - gap_y;
}

}  // namespace

double length_of(const LegendEntry& e) { return key_length + length_of(e.name); }

double length_of(const LegendLine& line) {
  double out = -legend_gap;
  for (const LegendEntry& e : line) out += length_of(e) + legend_gap;
  return out;
}

bool labels_x(const Figure& figure, std::size_t panel) {
  const std::size_t below = panel + figure.columns;
  return !figure.comparison || below >= figure.panels.size() ||
         !same(figure.panels[panel].x, figure.panels[below].x);
}

bool labels_y(const Figure& figure, std::size_t panel) {
  return !figure.comparison || panel % figure.columns == 0 ||
         !same(figure.panels[panel].y, figure.panels[panel - 1].y);
}

void add_note(Figure& figure, std::size_t panel, const std::string& text) {
  if (text.empty()) return;
  Panel& of = figure.panels[panel];
  const bool below = labels_x(figure, panel);
  std::string& note = below ? of.x->note : of.label;
  note += (note.empty() ? "" : ", ") + text;
  const auto noted = [](const Panel& p) { return p.x && !p.x->note.empty(); };
  if (below && note == text && std::ranges::count_if(figure.panels, noted) == 1)
    figure.bottom += line_of_note;
}

void tell_stretch(Figure& figure, std::size_t panel, double true_aspect, const char* along, const char* up) {
  for (const auto& [axis, factor] :
       {std::pair{along, true_aspect / figure.aspect}, {up, figure.aspect / true_aspect}})
    if (factor > 1.005) add_note(figure, panel, fmt::format("{} × {}", axis, brief(factor)));
}

double bar_height(const Layout& layout) { return std::max(layout.panels_high, least_bar * layout.em); }

double bar_step(const Layout& layout, Range shown) {
  return round_step(shown.width(), std::min(most_of_bar, bar_height(layout) / layout.em / line_of_bar));
}

Layout layout_of(const Figure& figure, const Request& request) {
  Layout out{};
  const double line = em_across(figure.columns) - 2 * beside_text;
  out.title = broken(request.titled ? request.title : figure.title, line, most_of_title);
  out.columns = figure.columns;
  out.rows = (figure.panels.size() + figure.columns - 1) / figure.columns;
  out.legend = legend_of(figure.legend, line);
  const bool given = request.pixels.nx > 0;
  out.em = given ? static_cast<double>(request.pixels.nx) / em_across(figure.columns)
                 : (figure.columns == 1 ? em_of_single : em_of_many);
  // The numbers depend on the size of the panels, and this on the room for the numbers: once is enough, for
  // in narrower panels there are no more of them.
  place_panels(out, figure, request, {figure.left, figure.right, figure.gap_x});
  place_panels(out, figure, request, room_for(figure, out.panel_width / out.em, out.panel_height / out.em));
  return out;
}

}  // namespace asperity::plot
