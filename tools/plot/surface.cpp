#include <algorithm>
#include <cmath>

#include "plot/kinds.hpp"
#include "plot/source.hpp"

namespace asperity::plot {
namespace {

constexpr Index most_points = 128;     // along a side: more are not legible on paper
constexpr double height_share = 0.22;  // of the longer side that the range of values should take

// The k-th points in both directions, so that at most `most_points` are left along a side.
Index stride_of(const Field& values) {
  return (std::max(values.rows(), values.cols()) + most_points - 1) / most_points;
}

Patch thinned(const Patch& patch, Index stride) {
  const Index nx = (patch.values.rows() + stride - 1) / stride,
              ny = (patch.values.cols() + stride - 1) / stride;
  const double step_x = patch.dx() * static_cast<double>(stride),
               step_y = patch.dy() * static_cast<double>(stride);
  const double x0 = patch.x_at(0) - 0.5 * step_x, y0 = patch.y_at(0) - 0.5 * step_y;
  return {Field::NullaryExpr(nx, ny, [&](Index i, Index j) { return patch.values(i * stride, j * stride); }),
          {x0, x0 + step_x * static_cast<double>(nx)},
          {y0, y0 + step_y * static_cast<double>(ny)}};
}

// A round number 1, 2 or 5 × 10ⁿ of plotted metres a unit of the quantity.
double exaggeration(const Patch& patch, Range values) {
  const double wanted =
      height_share * std::max(patch.x.width(), patch.y.width()) / std::max(values.width(), 1e-300);
  return round_step(0.7 * wanted, 1);
}

std::string tics(Range values, double step, double scale, const Unit& unit) {
  std::string out;
  for (const double v : multiples({values.low / unit.factor, values.high / unit.factor}, step))
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", quoted(brief(v)), v * unit.factor * scale);
  return out;
}

std::string default_title(const Quantity& quantity, double factor, Index stride) {
  std::string out = quantity.unit == "m" ? fmt::format("{} × {:.6g}", quantity.name, factor) : quantity.name;
  if (stride > 1) out += fmt::format(", every {}th point", stride);
  return out;
}

}  // namespace

Script surface(const Cases& cases, const Request& request) {
  const std::string variable = request.variable.empty() ? "heights" : request.variable;
  std::vector<Patch> patches;
  Range values{unlimited, -unlimited};
  Index stride = 1;
  for (const Case& c : cases) {
    Patch whole = patch_of(c.data, variable, request);
    values = united(values, range_of(whole.values));
    stride = std::max(stride, stride_of(whole.values));
    patches.push_back(std::move(whole));
  }
  for (Patch& p : patches) p = thinned(p, stride);
  const Quantity quantity = quantity_of(cases[0].data.at(variable));
  values = value_range(request, quantity.unit, values);
  const double factor = exaggeration(patches[0], values);
  const Unit length = unit_for(reach(patches[0]), "m"), value = unit_for(values.magnitude(), quantity.unit);
  const double scale = factor / length.factor;  // plotted units a unit of the quantity
  const Colours colours =
      quantity.signed_value ? about(0.5 * (values.low + values.high), values) : one_sided(values);

  Sheet sheet{.columns = static_cast<int>(cases.size()),
              .aspect = 0.72,
              .left = 4.5,
              .right = 4,
              .bottom = 3.2,
              .gap_x = 3.5};
  Figure figure(request, sheet, default_title(quantity, factor, stride));
  Script& script = figure.script;
  script.line("set view 50,30,0.98\nset view equal xyz\nset xyplane at {}", values.low * scale);
  script.line("set pm3d depthorder explicit corners2color mean");
  script.line("set pm3d lighting primary 0.45 specular 0.0");
  script.line("set border 127+256+512 linewidth 0.6\nset grid ztics linewidth 0.4 linecolor rgb '#c8c8c8'");
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Patch& p = patches[c];
    figure.panel(0, static_cast<int>(c), cases[c].label);
    figure.colours({{colours.range.low * scale, colours.range.high * scale}, colours.palette}, {}, "");
    script.line("unset colorbox");
    script.line("set xrange [{}:{}]\nset yrange [{}:{}]\nset zrange [{}:{}]", p.x.low / length.factor,
                p.x.high / length.factor, p.y.low / length.factor, p.y.high / length.factor,
                values.low * scale, values.high * scale);
    script.line("set xtics {} offset 0,-0.3\nset ytics {} offset 0.4,-0.2",
                round_step(p.x.width() / length.factor, 4), round_step(p.y.width() / length.factor, 4));
    script.line(
        "set ztics ({})",
        tics(values, round_step(values.width() / value.factor, cases.size() > 1 ? 3 : 4), scale, value));
    script.line("set xlabel {} noenhanced offset 0,-0.3", quoted(length.label("x")));
    script.line("set ylabel {} noenhanced offset 0,-0.3", quoted(length.label("y")));
    if (c > 0)
      script.line("unset zlabel");
    else
      script.line("set zlabel {} noenhanced rotate by 90 offset 1,0", quoted(value.label(quantity.name)));
    const Lattice at{p.x_at(0) / length.factor, p.y_at(0) / length.factor, p.dx() / length.factor,
                     p.dy() / length.factor, true};
    script.draw("splot", {raster(p.values * scale, at, "with pm3d")});
  }
  return script;
}

}  // namespace asperity::plot
