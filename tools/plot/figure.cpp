#include "tools/plot/figure.hpp"

#include <algorithm>
#include <cmath>

#include "tools/plot/layout.hpp"
#include "tools/plot/tics.hpp"

namespace asperity::plot {
namespace {

constexpr double em_in_cm = 0.25, em_in_points = em_in_cm / 2.54 * 72;  // on paper
constexpr double pdf_line = 0.5;                                        // of linewidth 1 of pdfcairo [pt]
constexpr double em_of_cairo = 0.75;  // its points are 4/3 of a pixel or of a point
constexpr const char* missing_colour = "#d4d4d4";
constexpr const char* missing_hatch = "fillcolor rgb '#8f8f8f' fillstyle transparent pattern 4";
constexpr double bar_distance = 0.8, bar_width = 0.9;

// In the terminal's points.
double letter_size(const Layout& at, const std::string& format) {
  return format == "svg" ? at.em : em_of_cairo * (format == "pdf" ? em_in_points : at.em);
}

// The em is `at.em` pixels in PNG and SVG, and 0.25 cm in PDF.
std::string terminal(const Layout& at, const std::string& format) {
  const double em = at.em, letters = letter_size(at, format);
  if (format == "pdf")
    return fmt::format(
        "pdfcairo noenhanced size {:.4f}cm,{:.4f}cm font 'DejaVu Sans,{:.3f}' fontscale 1 linewidth {:.3f}",
        static_cast<double>(at.pixels.nx) * em_in_cm / em, static_cast<double>(at.pixels.ny) * em_in_cm / em,
        letters, em_in_points / 16 / pdf_line);
  if (format == "png")
    return fmt::format("pngcairo noenhanced size {},{} font 'DejaVu Sans,{:.2f}' linewidth {:.2f}",
                       at.pixels.nx, at.pixels.ny, letters, em / 16);
  return fmt::format("svg noenhanced name 'asperity' size {},{} font 'sans-serif,{:.2f}' linewidth {:.2f}",
                     at.pixels.nx, at.pixels.ny, letters, em / 16);
}

// The point size of a symbol one em wide: gnuplot's unit is 6 px in PNG, 6 pt in PDF and 0.75 em in SVG.
double dot_size(const Layout& at, const std::string& format) {
  if (format == "svg") return 1 / 0.75;
  return (format == "pdf" ? em_in_points : at.em) / 6;
}

// The commands of a figure, part by part.
class Writer {
 public:
  Writer(const Figure& figure, const Layout& layout, const std::string& format)
      : figure_(figure), at_(layout), em_(layout.em), letters_(letter_size(layout, format)) {}

  void begin(const std::string& format) {
    script.line("set encoding utf8\nset terminal {} background rgb 'white'", terminal(at_, format));
    script.line("dot = {:.5g}", dot_size(at_, format));
    script.line("set minussign\nset border linewidth 0.8\nset tics out nomirror scale 0.5 front");
    script.line("unset key\nset multiplot");
    script.add(figure_.commands);
  }

  void frame(std::size_t panel) {
    const double x = at_.x_of(panel), y = at_.y_of(panel), wide = at_.panel_width, high = at_.panel_height;
    script.line("unset label\nunset object\nunset arrow\nunset colorbox");
    script.line("set lmargin at screen {}\nset rmargin at screen {}", screen_x(x), screen_x(x + wide));
    script.line("set bmargin at screen {}\nset tmargin at screen {}", screen_y(y), screen_y(y + high));
    if (figure_.comparison) {
      const auto [text, at] = within(figure_.panels[panel].label, x + 0.5 * wide, beside(), sheet_x());
      label(text, at, y + high + 0.8 * em_, "center");
    }
    if (is_last(panel)) title();
  }

  void title() {
    double y = static_cast<double>(at_.pixels.ny) - 1.3 * em_;
    for (const std::string& line : at_.title) {
      label(line, title_centre(), y, "center");
      y -= line_of_title * em_;
    }
  }

  void x_axis(std::size_t panel, const Axis& x) {
    const bool hidden = !labels_x(figure_, panel);
    axis("x", x, tics_along(x, at_.panel_width / em_), hidden);
    if (hidden) return;
    const double centre = at_.x_of(panel) + 0.5 * at_.panel_width,
                 y = at_.y_of(panel) - (x.bar.empty() ? below_axis : below_bar) * em_;
    const auto [text, at] = within(x.label, centre, beside(), sheet_x());
    if (x.bar.empty())
      label(text, at, y, "center");
    else
      scale_bar(x, at_.x_of(panel), y);
    if (!x.note.empty())
      label(within(x.note, centre, beside() / small, sheet_x()).text, centre, y - line_of_note * em_,
            fmt::format("center font ',{:.3f}' textcolor rgb '#505050'", small * letters_));
  }

  void scale_bar(const Axis& axis, double x, double y) {
    const double length = round_step(axis.range.width(), 5),
                 end = x + length / axis.range.width() * at_.panel_width;
    script.line("set arrow from screen {},{} to screen {},{} nohead linewidth 4", screen_x(x), screen_y(y),
                screen_x(end), screen_y(y));
    label(fmt::format("{:.6g} {}", length, axis.bar), end + 0.6 * em_, y, "left");
  }

  void y_axis(std::size_t panel, const Axis& y) {
    const bool hidden = !labels_y(figure_, panel);
    axis("y", y, tics_across(y, at_.panel_height / em_), hidden);
    if (hidden || !y.bar.empty()) return;
    const double x = at_.x_of(panel) - (at_.margin - 0.9) * em_, top = beside_panels(x);
    const auto [text, at] =
        within(y.label, at_.y_of(panel) + 0.5 * at_.panel_height, at_.rows > 1 ? at_.step_y : top, top);
    label(text, x, at, "rotate by 90 center");
  }

  void colours(const ColourBar& bar, bool with_bar) {
    std::string stops;
    int number = 0;
    for (const std::string& colour : control_colours(bar.colours.palette))
      stops += fmt::format("{}{} '{}'", stops.empty() ? "" : ", ", number++, colour);
    script.line("set palette maxcolors 0 defined ({})", stops);
    const Range shown = drawable(bar.colours.range / bar.unit.factor);
    script.line("set cbrange [{}:{}]", shown.low, shown.high);
    if (with_bar && !bar.name.empty()) colour_bar(shown, bar);
  }

  // Entries with even gaps, centred over the panels, or on the sheet if they are wider than the panels.
  void legend() {
    double y = at_.bottom + at_.panels_high + (figure_.comparison ? label_height : 0) * em_ + 1.1 * em_ +
               line_of_legend * em_ * static_cast<double>(at_.legend.size());
    for (const LegendLine& line : at_.legend) {
      y -= line_of_legend * em_;
      const double length = length_of(line) * em_, wide = at_.panels_wide;
      double x = length <= wide ? at_.left + 0.5 * (wide - length)
                                : 0.5 * (static_cast<double>(at_.pixels.nx) - length);
      for (const LegendEntry& e : line) {
        label(e.name, x + key_length * em_, y, "left");
        legend_key(e, x, y);
        x += (length_of(e) + legend_gap) * em_;
      }
    }
  }

  bool is_last(std::size_t panel) const { return panel + 1 == figure_.panels.size(); }

  Script script;

 private:
  // A text of at most this length, centred here or so far off that it ends before the ends of the sheet.
  struct Placed {
    std::string text;
    double at;
  };
  Placed within(const std::string& text, double centre, double most, double end) const {
    const double room = 0.3 * em_;
    Placed out{shortened(text, (std::min(most, end) - 2 * room) / em_), centre};
    const double half = 0.5 * length_of(out.text) * em_ + room;
    out.at = std::clamp(centre, half, std::max(half, end - half));
    return out;
  }
  double sheet_x() const { return static_cast<double>(at_.pixels.nx); }
  // Where a text beside the panels ends: below a title that reaches so far.
  double below_title(double x) const {
    double lines = 0;
    for (const std::string& line : at_.title)
      if (std::abs(x - title_centre()) < 0.5 * length_of(line) * em_ + 0.3 * em_)
        lines = static_cast<double>(at_.title.size());
    return static_cast<double>(at_.pixels.ny) - line_of_title * em_ * lines;
  }
  // Over the panels, or amid the sheet where it is wider.
  double title_centre() const {
    const bool wide = std::ranges::any_of(
        at_.title, [&](const std::string& line) { return length_of(line) * em_ > at_.panels_wide; });
    return wide ? 0.5 * sheet_x() : at_.left + 0.5 * at_.panels_wide;
  }
  // Nor beside a legend that does.
  double beside_panels(double x) const {
    const bool wide = std::ranges::any_of(
        at_.legend, [&](const LegendLine& line) { return length_of(line) * em_ > at_.panels_wide; });
    return wide ? at_.bottom + at_.panels_high + 0.8 * em_ : below_title(x);
  }
  // What a text below or above a panel may take.
  double beside() const { return at_.columns > 1 ? at_.step_x : sheet_x(); }

  void label(const std::string& text, double x, double y, std::string_view style) {
    script.line("set label {} at screen {},{} {} noenhanced", gnuplot_string(text), screen_x(x), screen_y(y),
                style);
  }

  void axis(const char* name, const Axis& axis, Tics tics, bool hidden) {
    const Range range = drawn(axis);
    script.line("{} logscale {}", axis.logarithmic ? "set" : "unset", name);
    script.line("set {}range [{}:{}]", name, axis.downwards ? range.high : range.low,
                axis.downwards ? range.low : range.high);
    if (!axis.bar.empty()) tics.clear();
    for (Tic& tic : tics)
      if (hidden) tic.text.clear();
    script.line("{}", command(name, tics));
  }

  // Its label is to the right of the longest number.
  void colour_bar(Range shown, const ColourBar& bar) {
    const double high = bar_height(at_), x = at_.left + at_.panels_wide + bar_distance * em_;
    const Tics tics = tics_at(shown, bar_step(at_, shown));
    script.line("set colorbox vertical user origin screen {},{} size screen {},{} front", screen_x(x),
                screen_y(at_.bottom), screen_x(bar_width * em_), screen_y(high));
    script.line("{}\nset cbtics scale 0.5", command("cb", tics));
    const double at_x = x + (bar_width + 1.9 + longest(tics)) * em_, top = below_title(at_x);
    const auto [text, at_y] = within(bar.unit.label(bar.name), at_.bottom + 0.5 * high, top, top);
    label(text, at_x, at_y, "rotate by 90 center");
  }

  void legend_key(const LegendEntry& entry, double x, double y) {
    using enum LegendEntry::Key;
    if (entry.key == box || entry.key == hatch) {
      const double left = x + 0.6 * em_, half = 0.45 * em_;
      const std::string place =
          fmt::format("rectangle from screen {},{} to screen {},{} front", screen_x(left), screen_y(y - half),
                      screen_x(left + 2 * half), screen_y(y + half));
      const char* border = "border linecolor rgb 'black' linewidth 0.6";
      script.line("set object {} fillcolor rgb '{}' fillstyle solid {}", place, entry.colour, border);
      if (entry.key == hatch) script.line("set object {} {} {}", place, missing_hatch, border);
    } else if (entry.key == circle || entry.key == dot) {
      script.line(
          "set label \"\" at screen {},{} point pointtype {} pointsize 0.5*dot linewidth 1 linecolor rgb "
          "'{}'",
          screen_x(x + 0.8 * em_), screen_y(y), entry.key == dot ? 7 : 6, entry.colour);
    } else {
      script.line(
          "set arrow from screen {},{} to screen {},{} nohead linewidth 1.6 dashtype {} linecolor rgb '{}'",
          screen_x(x), screen_y(y), screen_x(x + 1.6 * em_), screen_y(y),
          entry.key == dashes ? "(9,6)" : "solid", entry.colour);
    }
  }

  double screen_x(double px) const { return px / static_cast<double>(at_.pixels.nx); }
  double screen_y(double px) const { return px / static_cast<double>(at_.pixels.ny); }

  const Figure& figure_;
  const Layout& at_;
  double em_, letters_;
};

}  // namespace

void show_missing(Figure& figure) {
  figure.legend.push_back({LegendEntry::Key::hatch, missing_colour, "missing"});
  const char* all = "set object rectangle from graph 0,0 to graph 1,1 behind";
  for (Panel& p : figure.panels)
    p.commands.line("{0} fillcolor rgb '{1}' fillstyle solid noborder\n{0} {2} noborder", all, missing_colour,
                    missing_hatch);
}

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
  Writer writer(figure, layout, request.format);
  writer.begin(request.format);
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    const Panel& panel = figure.panels[k];
    writer.frame(k);
    if (panel.x) writer.x_axis(k, *panel.x);
    if (panel.y) writer.y_axis(k, *panel.y);
    if (figure.colours) writer.colours(*figure.colours, writer.is_last(k));
    if (figure.comparison ? writer.is_last(k) : k == 0) writer.legend();
    writer.script.add(panel.commands);
    writer.script.draw(figure.in_space ? "splot" : "plot", panel.layers);
  }
  return writer.script;
}

}  // namespace asperity::plot
