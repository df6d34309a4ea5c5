#include "tools/plot/figure.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace asperity::plot {
namespace {

constexpr double em_of_single = 37.5, em_of_many = 30;                  // pixels, unless the size is given
constexpr double em_in_cm = 0.25, em_in_points = em_in_cm / 2.54 * 72;  // on paper
constexpr double pdf_line = 0.5;                                        // of linewidth 1 of pdfcairo [pt]
constexpr double em_of_cairo = 0.75;  // its points are 4/3 of a pixel or of a point
constexpr double free_aspect = 0.62, free_aspect_of_rows = 0.45;
constexpr double title_height = 2.0, label_height = 1.5, line_of_legend = 2.0;
constexpr int x_label_tag = 100;
constexpr int y_label_tag = 101;  // beyond the tags of labels that have none
constexpr double key_length = 2.0, letter_width = 0.6, legend_gap = 1.6;
constexpr double bar_distance = 0.8, bar_width = 0.9;

// The width of a sheet [em]: of one column 32, of three 60.
double em_across(std::size_t columns) { return 18.0 + 14.0 * static_cast<double>(columns); }

// Of UTF-8, where every byte but the continuing ones begins a character.
double characters(const std::string& text) {
  return static_cast<double>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

using LegendLine = std::vector<LegendEntry>;

double length_of(const LegendEntry& e) { return key_length + letter_width * characters(e.name); }
double length_of(const LegendLine& line) {
  double out = -legend_gap;
  for (const LegendEntry& e : line) out += length_of(e) + legend_gap;
  return out;
}

// A line is broken before the entry that would not fit in.
std::vector<LegendLine> lines_of(const std::vector<LegendEntry>& entries, double longest) {
  std::vector<LegendLine> out;
  for (const LegendEntry& e : entries) {
    if (out.empty() || length_of(out.back()) + legend_gap + length_of(e) > longest) out.emplace_back();
    out.back().push_back(e);
  }
  return out;
}

// The length of the longest number on a colour bar, in characters.
std::size_t longest_tic(Range range, double step) {
  std::size_t longest = 1;
  for (const double v : multiples(range, step)) longest = std::max(longest, fmt::format("{:.6g}", v).size());
  return longest;
}

}  // namespace

// M. Okabe, K. Ito, Color universal design (2008).
const char* line_colour(std::size_t k) {
  constexpr const char* colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"};
  return colours[k % std::size(colours)];
}

std::string title_or(const Request& request, const std::string& otherwise) {
  return request.titled ? request.title : otherwise;
}

Sheet side_by_side(const Request& request, std::size_t cases) {
  const std::size_t columns = request.columns > 0 ? static_cast<std::size_t>(request.columns) : cases;
  return {.panels = cases, .columns = std::min(columns, cases), .comparison = cases > 1};
}

Figure::Figure(const Request& request, Sheet sheet, const std::string& title)
    : sheet_(std::move(sheet)),
      rows_((sheet_.panels + sheet_.columns - 1) / sheet_.columns),
      legend_lines_(lines_of(sheet_.legend, em_across(sheet_.columns) - sheet_.left)),
      title_(title_or(request, title)) {
  if (!title_.empty()) sheet_.top += title_height;
  sheet_.top += line_of_legend * static_cast<double>(legend_lines_.size());
  if (sheet_.comparison) sheet_.top += label_height, sheet_.gap_y += label_height;
  fit(request);
  begin(request.format);
}

// Panels as large as the sheet allows; where they are too high for it, narrower and centred.
void Figure::fit(const Request& request) {
  const double n = columns(), m = rows();
  const bool given = request.pixels.nx > 0;
  em_ = given ? static_cast<double>(request.pixels.nx) / em_across(sheet_.columns)
              : (sheet_.columns == 1 ? em_of_single : em_of_many);
  const double width = em_across(sheet_.columns) * em_, gaps_x = (n - 1) * sheet_.gap_x * em_,
               gaps_y = (m - 1) * sheet_.gap_y * em_, frame_x = (sheet_.left + sheet_.right) * em_ + gaps_x,
               frame_y = (sheet_.bottom + sheet_.top) * em_ + gaps_y;
  const double aspect = sheet_.aspect > 0 ? sheet_.aspect : rows_ > 1 ? free_aspect_of_rows : free_aspect;
  panel_width_ = (width - frame_x) / n;
  panel_height_ = panel_width_ * aspect;
  if (given) {
    const double room = (static_cast<double>(request.pixels.ny) - frame_y) / m;
    if (!(room >= 2 * em_))
      throw ParameterError(
          "pixels", fmt::format("{}x{} is too flat for this figure", request.pixels.nx, request.pixels.ny));
    if (sheet_.aspect <= 0) panel_height_ = room;
    panel_width_ = std::min(panel_width_, room / (panel_height_ / panel_width_));
    panel_height_ = std::min(panel_height_, room);
    pixels_ = request.pixels;
  } else {
    pixels_ = {static_cast<Index>(std::lround(width)),
               static_cast<Index>(std::lround(frame_y + m * panel_height_))};
  }
  const double spare_x = static_cast<double>(pixels_.nx) - frame_x - n * panel_width_,
               spare_y = static_cast<double>(pixels_.ny) - frame_y - m * panel_height_;
  left_ = sheet_.left * em_ + 0.5 * spare_x;
  bottom_ = sheet_.bottom * em_ + 0.5 * spare_y;
}

// An em is so many pixels of a PNG or an SVG, and 0.25 cm of a PDF.
std::string Figure::terminal(const std::string& format) const {
  if (format == "pdf")
    return fmt::format(
        "pdfcairo noenhanced size {:.4f}cm,{:.4f}cm font 'DejaVu Sans,{:.3f}' fontscale 1 linewidth {:.3f}",
        static_cast<double>(pixels_.nx) * em_in_cm / em_, static_cast<double>(pixels_.ny) * em_in_cm / em_,
        em_of_cairo * em_in_points, em_in_points / 16 / pdf_line);
  if (format == "png")
    return fmt::format("pngcairo noenhanced size {},{} font 'DejaVu Sans,{:.2f}' linewidth {:.2f}",
                       pixels_.nx, pixels_.ny, em_of_cairo * em_, em_ / 16);
  return fmt::format("svg noenhanced name 'asperity' size {},{} font 'sans-serif,{:.2f}' linewidth {:.2f}",
                     pixels_.nx, pixels_.ny, em_, em_ / 16);
}

void Figure::begin(const std::string& format) {
  script.line("set encoding utf8");
  script.line("set terminal {} background rgb 'white'", terminal(format));
  script.line("set minussign");
  script.line("set border linewidth 0.8");
  script.line("set tics out nomirror scale 0.5 front");
  script.line("unset key");
  script.line("set multiplot");
}

void Figure::panel(std::size_t number, const std::string& label) {
  panel_ = number;
  const std::size_t row = number / sheet_.columns;
  const auto column = static_cast<double>(number % sheet_.columns),
             below = static_cast<double>(rows_ - 1 - row);
  const double x0 = left_ + column * (panel_width_ + sheet_.gap_x * em_),
               y0 = bottom_ + below * (panel_height_ + sheet_.gap_y * em_);
  panel_x_ = x0;
  panel_y_ = y0;
  script.line("unset label\nunset object\nunset arrow\nunset colorbox");
  script.line("set lmargin at screen {}\nset rmargin at screen {}", screen_x(x0),
              screen_x(x0 + panel_width_));
  script.line("set bmargin at screen {}\nset tmargin at screen {}", screen_y(y0),
              screen_y(y0 + panel_height_));
  if (sheet_.comparison)
    script.line("set label {} at screen {},{} center noenhanced", gnuplot_string(label),
                screen_x(x0 + 0.5 * panel_width_), screen_y(y0 + panel_height_ + 0.8 * em_));
  if (is_last() && !title_.empty())
    script.line("set label {} at screen {},{} center noenhanced", gnuplot_string(title_),
                screen_x(left_ + 0.5 * panels_wide()), screen_y(static_cast<double>(pixels_.ny) - 1.3 * em_));
}

void Figure::x_axis(Range given, const std::string& label) {
  const Range range = drawable(given);
  const double most = std::max(2.0, em_wide() / 3.2);
  script.line("set xrange [{}:{}]", range.low, range.high);
  script.line("set xtics {} format '%g'", round_step(range.width(), most));
  script.line("set label {} {} at screen {},{} center noenhanced", x_label_tag, gnuplot_string(label),
              screen_x(panel_x_ + 0.5 * panel_width_), screen_y(panel_y_ - (sheet_.bottom - 0.8) * em_));
  if (sheet_.comparison && panel_ + sheet_.columns < sheet_.panels)
    script.line("set xtics format ''\nunset label {}", x_label_tag);
}

void Figure::y_axis(Range given, const std::string& label, bool downwards) {
  const Range range = drawable(given);
  const double most = std::max(2.0, em_high() / 1.8);
  script.line("set yrange [{}:{}]", downwards ? range.high : range.low, downwards ? range.low : range.high);
  script.line("set ytics {} format '%g'", round_step(range.width(), std::min(most, 8.0)));
  script.line("set label {} {} at screen {},{} rotate by 90 center noenhanced", y_label_tag, gnuplot_string(label),
              screen_x(panel_x_ - (sheet_.left - 0.9) * em_), screen_y(panel_y_ + 0.5 * panel_height_));
  if (sheet_.comparison && panel_ % sheet_.columns > 0)
    script.line("set ytics format ''\nunset label {}", y_label_tag);
}

void Figure::colours(const Colours& colours, const Unit& unit, const std::string& quantity) {
  std::string stops;
  const auto& list = control_colours(colours.palette);
  for (std::size_t i = 0; i < list.size(); ++i)
    stops += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, list[i]);
  script.line("set palette maxcolors 0 defined ({})", stops);
  const Range shown = drawable({colours.range.low / unit.factor, colours.range.high / unit.factor});
  script.line("set cbrange [{}:{}]", shown.low, shown.high);
  if (is_last() && !quantity.empty()) colour_bar(shown, unit, quantity);
}

// As high as the panels but not lower than is legible; its label stands right of its longest number.
void Figure::colour_bar(Range shown, const Unit& unit, const std::string& quantity) {
  const double panels = panels_high(), high = std::max(panels, 5 * em_), middle = bottom_ + 0.5 * panels,
               x = left_ + panels_wide() + bar_distance * em_;
  const double step = round_step(shown.width(), std::min(6.0, high / em_ / 1.6));
  const double label_x = x + (bar_width + 1.9 + 0.62 * static_cast<double>(longest_tic(shown, step))) * em_;
  script.line("set colorbox vertical user origin screen {},{} size screen {},{} front", screen_x(x),
              screen_y(middle - 0.5 * high), screen_x(bar_width * em_), screen_y(high));
  script.line("set cbtics {} format '%g' scale 0.5", step);
  script.line("set label {} at screen {},{} rotate by 90 center noenhanced", gnuplot_string(unit.label(quantity)),
              screen_x(label_x), screen_y(middle));
}

double Figure::legend_height() const {
  return bottom_ + panels_high() + (sheet_.comparison ? label_height : 0) * em_ + 1.1 * em_;
}

void Figure::legend() {
  double y = legend_height() + line_of_legend * em_ * static_cast<double>(legend_lines_.size());
  for (const LegendLine& line : legend_lines_) legend_line(line, y -= line_of_legend * em_);
}

// Entries one after the other with even gaps, centred over the panels, or on the sheet where they are longer.
void Figure::legend_line(const LegendLine& line, double y) {
  const double length = length_of(line) * em_, wide = panels_wide();
  double x =
      length <= wide ? left_ + 0.5 * (wide - length) : 0.5 * (static_cast<double>(pixels_.nx) - length);
  for (const LegendEntry& e : line) {
    script.line("set label {} at screen {},{} left noenhanced", gnuplot_string(e.name),
                screen_x(x + key_length * em_), screen_y(y));
    legend_key(e, x, y);
    x += (length_of(e) + legend_gap) * em_;
  }
}

void Figure::legend_key(const LegendEntry& entry, double x, double y) {
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

}  // namespace asperity::plot
