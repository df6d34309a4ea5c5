#include "tools/plot/figure.hpp"

#include <algorithm>
#include <cmath>

#include "tools/plot/layout.hpp"

namespace asperity::plot {
namespace {

constexpr double em_in_cm = 0.25, em_in_points = em_in_cm / 2.54 * 72;  // on paper
constexpr double pdf_line = 0.5;                                        // of linewidth 1 of pdfcairo [pt]
constexpr double em_of_cairo = 0.75;  // its points are 4/3 of a pixel or of a point
constexpr double bar_distance = 0.8, bar_width = 0.9;
constexpr int x_label_tag = 100, y_label_tag = 101;  // beyond the tags of labels that have none

// The length of the longest number on a colour bar, in characters.
std::size_t longest_tic(Range range, double step) {
  std::size_t longest = 1;
  for (const double v : multiples(range, step)) longest = std::max(longest, fmt::format("{:.6g}", v).size());
  return longest;
}

// An em is so many pixels of a PNG or an SVG, and 0.25 cm of a PDF.
std::string terminal(const Layout& at, const std::string& format) {
  const double em = at.em;
  if (format == "pdf")
    return fmt::format(
        "pdfcairo noenhanced size {:.4f}cm,{:.4f}cm font 'DejaVu Sans,{:.3f}' fontscale 1 linewidth {:.3f}",
        static_cast<double>(at.pixels.nx) * em_in_cm / em, static_cast<double>(at.pixels.ny) * em_in_cm / em,
        em_of_cairo * em_in_points, em_in_points / 16 / pdf_line);
  if (format == "png")
    return fmt::format("pngcairo noenhanced size {},{} font 'DejaVu Sans,{:.2f}' linewidth {:.2f}",
                       at.pixels.nx, at.pixels.ny, em_of_cairo * em, em / 16);
  return fmt::format("svg noenhanced name 'asperity' size {},{} font 'sans-serif,{:.2f}' linewidth {:.2f}",
                     at.pixels.nx, at.pixels.ny, em, em / 16);
}

// The commands of a figure, part by part.
class Writer {
 public:
  Writer(const Figure& figure, const Layout& layout) : figure_(figure), at_(layout), em_(layout.em) {}

  void begin(const std::string& format);
  void frame(std::size_t panel);
  void x_axis(std::size_t panel, const Axis& axis);
  void y_axis(std::size_t panel, const Axis& axis);
  void colours(const ColourBar& bar, bool with_bar);
  void legend();

  Script script;

 private:
  void colour_bar(Range shown, const ColourBar& bar);
  void legend_line(const LegendLine& entries, double y);
  void legend_key(const LegendEntry& entry, double x, double y);
  bool is_last(std::size_t panel) const { return panel + 1 == figure_.panels.size(); }
  double screen_x(double px) const { return px / static_cast<double>(at_.pixels.nx); }
  double screen_y(double px) const { return px / static_cast<double>(at_.pixels.ny); }

  const Figure& figure_;
  const Layout& at_;
  double em_;
};

void Writer::begin(const std::string& format) {
  script.line("set encoding utf8");
  script.line("set terminal {} background rgb 'white'", terminal(at_, format));
  script.line("set minussign");
  script.line("set border linewidth 0.8");
  script.line("set tics out nomirror scale 0.5 front");
  script.line("unset key");
  script.line("set multiplot");
  script.add(figure_.commands);
}

void Writer::frame(std::size_t panel) {
  const double x = at_.x_of(panel), y = at_.y_of(panel);
  script.line("unset label\nunset object\nunset arrow\nunset colorbox");
  script.line("set lmargin at screen {}\nset rmargin at screen {}", screen_x(x),
              screen_x(x + at_.panel_width));
  script.line("set bmargin at screen {}\nset tmargin at screen {}", screen_y(y),
              screen_y(y + at_.panel_height));
  if (figure_.comparison)
    script.line("set label {} at screen {},{} center noenhanced", gnuplot_string(figure_.panels[panel].label),
                screen_x(x + 0.5 * at_.panel_width), screen_y(y + at_.panel_height + 0.8 * em_));
  if (is_last(panel) && !at_.title.empty())
    script.line("set label {} at screen {},{} center noenhanced", gnuplot_string(at_.title),
                screen_x(at_.left + 0.5 * at_.panels_wide),
                screen_y(static_cast<double>(at_.pixels.ny) - 1.3 * em_));
}

// In a comparison only the lowest panels name their x axis, only those on the left their y axis.
void Writer::x_axis(std::size_t panel, const Axis& axis) {
  const Range range = drawable(axis.range);
  const double most = std::max(2.0, at_.panel_width / em_ / 3.2);
  script.line("set xrange [{}:{}]", range.low, range.high);
  script.line("set xtics {} format '%g'", round_step(range.width(), most));
  script.line("set label {} {} at screen {},{} center noenhanced", x_label_tag, gnuplot_string(axis.label),
              screen_x(at_.x_of(panel) + 0.5 * at_.panel_width),
              screen_y(at_.y_of(panel) - (figure_.bottom - 0.8) * em_));
  if (figure_.comparison && panel + at_.columns < figure_.panels.size())
    script.line("set xtics format ''\nunset label {}", x_label_tag);
}

void Writer::y_axis(std::size_t panel, const Axis& axis) {
  const Range range = drawable(axis.range);
  const double most = std::max(2.0, at_.panel_height / em_ / 1.8);
  script.line("set yrange [{}:{}]", axis.downwards ? range.high : range.low,
              axis.downwards ? range.low : range.high);
  script.line("set ytics {} format '%g'", round_step(range.width(), std::min(most, 8.0)));
  script.line("set label {} {} at screen {},{} rotate by 90 center noenhanced", y_label_tag,
              gnuplot_string(axis.label), screen_x(at_.x_of(panel) - (figure_.left - 0.9) * em_),
              screen_y(at_.y_of(panel) + 0.5 * at_.panel_height));
  if (figure_.comparison && panel % at_.columns > 0)
    script.line("set ytics format ''\nunset label {}", y_label_tag);
}

void Writer::colours(const ColourBar& bar, bool with_bar) {
  std::string stops;
  const auto& list = control_colours(bar.colours.palette);
  for (std::size_t i = 0; i < list.size(); ++i)
    stops += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, list[i]);
  script.line("set palette maxcolors 0 defined ({})", stops);
  const Range shown = drawable(bar.colours.range / bar.unit.factor);
  script.line("set cbrange [{}:{}]", shown.low, shown.high);
  if (with_bar && !bar.name.empty()) colour_bar(shown, bar);
}

// As high as the panels but not lower than is legible; its label stands right of its longest number.
void Writer::colour_bar(Range shown, const ColourBar& bar) {
  const double high = std::max(at_.panels_high, 5 * em_), middle = at_.bottom + 0.5 * at_.panels_high,
               x = at_.left + at_.panels_wide + bar_distance * em_;
  const double step = round_step(shown.width(), std::min(6.0, high / em_ / 1.6));
  const double label_x = x + (bar_width + 1.9 + 0.62 * static_cast<double>(longest_tic(shown, step))) * em_;
  script.line("set colorbox vertical user origin screen {},{} size screen {},{} front", screen_x(x),
              screen_y(middle - 0.5 * high), screen_x(bar_width * em_), screen_y(high));
  script.line("set cbtics {} format '%g' scale 0.5", step);
  script.line("set label {} at screen {},{} rotate by 90 center noenhanced",
              gnuplot_string(bar.unit.label(bar.name)), screen_x(label_x), screen_y(middle));
}

void Writer::legend() {
  double y = at_.bottom + at_.panels_high + (figure_.comparison ? label_height : 0) * em_ + 1.1 * em_ +
             line_of_legend * em_ * static_cast<double>(at_.legend.size());
  for (const LegendLine& line : at_.legend) legend_line(line, y -= line_of_legend * em_);
}

// Entries one after the other with even gaps, centred over the panels, or on the sheet where they are longer.
void Writer::legend_line(const LegendLine& line, double y) {
  const double length = length_of(line) * em_, wide = at_.panels_wide;
  double x =
      length <= wide ? at_.left + 0.5 * (wide - length) : 0.5 * (static_cast<double>(at_.pixels.nx) - length);
  for (const LegendEntry& e : line) {
    script.line("set label {} at screen {},{} left noenhanced", gnuplot_string(e.name),
                screen_x(x + key_length * em_), screen_y(y));
    legend_key(e, x, y);
    x += (length_of(e) + legend_gap) * em_;
  }
}

void Writer::legend_key(const LegendEntry& entry, double x, double y) {
  if (entry.key == LegendEntry::Key::box) {
    const double left = x + 0.6 * em_, half = 0.45 * em_;
    script.line(
        "set object rectangle from screen {},{} to screen {},{} front fillcolor rgb '{}' fillstyle solid "
        "border linecolor rgb 'black' linewidth 0.6",
        screen_x(left), screen_y(y - half), screen_x(left + 2 * half), screen_y(y + half), entry.colour);
  } else {
    script.line(
        "set arrow from screen {},{} to screen {},{} nohead linewidth 1.6 dashtype {} linecolor rgb '{}'",
        screen_x(x), screen_y(y), screen_x(x + 1.6 * em_), screen_y(y),
        entry.key == LegendEntry::Key::dashes ? "(9,6)" : "solid", entry.colour);
  }
}

}  // namespace

// M. Okabe, K. Ito, Color universal design (2008).
const char* line_colour(std::size_t k) {
  constexpr const char* colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"};
  return colours[k % std::size(colours)];
}

Figure side_by_side(const Request& request, const Cases& cases) {
  const std::size_t columns = request.columns > 0 ? static_cast<std::size_t>(request.columns) : cases.size();
  Figure out;
  for (const Case& c : cases) out.panels.push_back({.label = c.label});
  out.columns = std::min(columns, cases.size());
  out.comparison = cases.size() > 1;
  return out;
}

Script script_of(const Figure& figure, const Request& request) {
  const Layout layout = layout_of(figure, request);
  Writer writer(figure, layout);
  writer.begin(request.format);
  const std::size_t last = figure.panels.size() - 1, legend = figure.comparison ? last : 0;
  for (std::size_t k = 0; k <= last; ++k) {
    const Panel& panel = figure.panels[k];
    writer.frame(k);
    if (panel.x) writer.x_axis(k, *panel.x);
    if (panel.y) writer.y_axis(k, *panel.y);
    if (figure.colours) writer.colours(*figure.colours, k == last);
    if (k == legend) writer.legend();
    writer.script.add(panel.commands);
    writer.script.draw(figure.in_space ? "splot" : "plot", panel.layers);
  }
  return writer.script;
}

}  // namespace asperity::plot
