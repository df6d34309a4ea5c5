#include "tools/plot/series.hpp"

namespace asperity::plot {
namespace {

// Rows with numbers alone.
Field finite_rows(const Field& all) {
  Field out(all.rows(), all.cols());
  Index n = 0;
  for (Index k = 0; k < all.rows(); ++k)
    if (all.row(k).isFinite().all()) out.row(n++) = all.row(k);
  return out.topRows(n);
}

// The runs of such rows, for lines and bands.
void add_runs(std::vector<Layer>& layers, const Field& all, const std::string& style) {
  for (Index first = 0, k = 0; k <= all.rows(); ++k)
    if (k == all.rows() || !all.row(k).isFinite().all()) {
      if (k - first > 1) layers.push_back(points(all.middleRows(first, k - first), style));
      first = k + 1;
    }
}

void add_points(std::vector<Layer>& layers, const Field& all, const std::string& style) {
  if (const Field there = finite_rows(all); there.rows() > 0) layers.push_back(points(there, style));
}

}  // namespace

Field Series::pairs(const Column& x, const Column& y) const {
  Field out(x.size(), 2);
  out << x / x_, y / y_;
  return out;
}

void Series::add(const Column& x, const Column& y, const std::string& style) {
  if (x.size() > 0) layers_.push_back(points(pairs(x, y), style));
}

void Series::line(const Column& x, const Column& y, const std::string& colour, double width,
                  const std::string& dashes) {
  add_runs(layers_, pairs(x, y),
           fmt::format("with lines linewidth {} {}linecolor rgb '{}'", width,
                       dashes.empty() ? "" : "dashtype " + dashes + ' ', colour));
}

void Series::band(const Column& x, const Column& low, const Column& high, const std::string& colour,
                  double opacity) {
  Field table(x.size(), 3);
  table << x / x_, low / y_, high / y_;
  add_runs(
      layers_, table,
      fmt::format("with filledcurves fillcolor rgb '{}' fillstyle transparent solid {}", colour, opacity));
}

void Series::dots(const Column& x, const Column& y, const std::string& colour, double size) {
  add_points(layers_, pairs(x, y),
             fmt::format("with points pointtype 7 pointsize {}*dot linecolor rgb '{}'", size, colour));
}

void Series::circles(const Column& x, const Column& y, const std::string& colour) {
  add_points(
      layers_, pairs(x, y),
      fmt::format("with points pointtype 6 pointsize 0.3*dot linewidth 0.8 linecolor rgb '{}'", colour));
}

void Series::bars(const Column& x, const Column& y, const Column& half, const std::string& colour,
                  bool across) {
  Field table(x.size(), 4);
  const Column zero = Column::Zero(x.size());
  if (across)
    table << (x - half) / x_, y / y_, 2 * half / x_, zero;
  else
    table << x / x_, (y - half) / y_, zero, 2 * half / y_;
  add_points(layers_, table, fmt::format("with vectors nohead linewidth 0.9 linecolor rgb '{}'", colour));
}

}  // namespace asperity::plot
