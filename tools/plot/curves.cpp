#include "tools/plot/curves.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace asperity::plot {
namespace {

Range with(Range range, const Eigen::ArrayXd& values) {
  for (const double v : values)
    if (std::isfinite(v)) range = united(range, {v, v});
  return range;
}

Field table_of(std::initializer_list<std::reference_wrapper<const Curves::Column>> columns) {
  Field out(columns.begin()->get().size(), std::ssize(columns));
  for (Index c = 0; const Curves::Column& column : columns) out.col(c++) = column;
  return out;
}

// Rows with numbers alone.
Field finite_rows(const Field& all) {
  Field out(all.rows(), all.cols());
  Index n = 0;
  for (Index k = 0; k < all.rows(); ++k)
    if (all.row(k).isFinite().all()) out.row(n++) = all.row(k);
  return out.topRows(n);
}

// The runs of such rows, of two and more.
std::vector<Field> runs_of(const Field& all) {
  std::vector<Field> out;
  for (Index first = 0, k = 0; k <= all.rows(); ++k)
    if (k == all.rows() || !all.row(k).isFinite().all()) {
      if (k - first > 1) out.emplace_back(all.middleRows(first, k - first));
      first = k + 1;
    }
  return out;
}

}  // namespace

void Curves::put(Curve curve) {
  for (Index c = 0; const char axis : curve.axes) {
    if (axis == 'x') x = with(x, curve.columns.col(c));
    if (axis == 'y') y = with(y, curve.columns.col(c));
    ++c;
  }
  all_.push_back(std::move(curve));
}

void Curves::add(const Field& columns, const std::string& axes, const std::string& style) {
  put({columns, axes, style, Shape::points});
}

void Curves::line(const Column& along, const Column& up, const std::string& colour, double width,
                  const std::string& dashes) {
  put({table_of({along, up}), "xy",
       fmt::format("with lines linewidth {} {}linecolor rgb '{}'", width,
                   dashes.empty() ? "" : "dashtype " + dashes + ' ', colour),
       Shape::line});
}

void Curves::band(const Column& along, const Column& low, const Column& high, const std::string& colour,
                  double opacity, bool counts) {
  put({table_of({along, low, high}), counts ? "xyy" : "xYY",
       fmt::format("with filledcurves fillcolor rgb '{}' fillstyle transparent solid {}", colour, opacity),
       Shape::band});
}

void Curves::dots(const Column& along, const Column& up, const std::string& colour, double size) {
  add(table_of({along, up}), "xy",
      fmt::format("with points pointtype 7 pointsize {}*dot linecolor rgb '{}'", size, colour));
}

void Curves::circles(const Column& along, const Column& up, const std::string& colour) {
  add(table_of({along, up}), "xy",
      fmt::format("with points pointtype 6 pointsize 0.3*dot linewidth 0.8 linecolor rgb '{}'", colour));
}

void Curves::bars(const Column& along, const Column& up, const Column& half, const std::string& colour,
                  bool across) {
  const Column length = 2 * half, zero = Column::Zero(half.size()), first = (across ? along : up) - half;
  add(across ? table_of({first, up, length, zero}) : table_of({along, first, zero, length}), "xyXY",
      fmt::format("with vectors nohead linewidth 0.9 linecolor rgb '{}'", colour));
  (across ? x : y) = with(across ? x : y, first + length);
}

std::vector<Layer> Curves::layers(const Axis& of_x, const Axis& of_y) const {
  std::vector<Layer> out;
  for (const Curve& curve : all_) {
    Field t = curve.columns;
    for (Index c = 0; c < t.cols(); ++c) {
      const Axis& axis = std::tolower(curve.axes[static_cast<std::size_t>(c)]) == 'x' ? of_x : of_y;
      t.col(c) /= axis.unit;
      if (curve.shape == Shape::points) continue;
      const bool whole = curve.shape == Shape::band && c > 0;
      t.col(c) = t.col(c).unaryExpr([&](double v) {
        return whole || std::isinf(v) ? std::clamp(v, axis.range.low, axis.range.high) : v;
      });
    }
    if (curve.shape != Shape::points)
      for (const Field& run : runs_of(t)) out.push_back(points(run, curve.style));
    else if (const Field there = finite_rows(t); there.rows() > 0)
      out.push_back(points(there, curve.style));
  }
  return out;
}

void place(Panel& panel, const Curves& curves, const Axis& x, const Axis& y) {
  panel.x = x;
  panel.y = y;
  panel.layers = curves.layers(x, y);
}

Range range_of(const std::vector<Curves>& all, Range Curves::*axis) {
  Range out = nothing;
  for (const Curves& curves : all) out = united(out, curves.*axis);
  return out.low <= out.high ? out : Range{0, 0};
}

void name_cases(Figure& figure, const Cases& cases) {
  for (std::size_t c = 0; c < cases.size() && cases.size() > 1; ++c)
    figure.legend.push_back({LegendEntry::Key::line, line_colour(c), cases[c].label});
}

}  // namespace asperity::plot
