// The hills of a surface on its map.
#include "stats/feature/features.hpp"

#include <cmath>

#include "core/words.hpp"
#include "tools/plot/measured.hpp"

namespace asperity::plot {
namespace {

constexpr std::size_t most_outlined = 2000;  // hills; of more the outlines would hide the map

// Sides of cells between two hills: where each begins, and its length.
Field outlines_of(const Hills& hills, const Grid& grid, double unit) {
  std::vector<double> sides;
  const auto add = [&](double x, double y, double along_x, double along_y) {
    for (const double v : {x, y, along_x, along_y}) sides.push_back(v / unit);
  };
  const auto& of = hills.of_point;
  for (Index i = 0; i < of.rows(); ++i)
    for (Index j = 0; j < of.cols(); ++j) {
      const double x = grid.x(i) + 0.5 * grid.dx, y = grid.y(j) + 0.5 * grid.dy;
      if (i + 1 < of.rows() && of(i, j) != of(i + 1, j)) add(x, y - grid.dy, 0, grid.dy);
      if (j + 1 < of.cols() && of(i, j) != of(i, j + 1)) add(x - grid.dx, y, grid.dx, 0);
    }
  return Eigen::Map<const Field>(sides.data(), std::ssize(sides) / 4, 4);
}

Field peaks_of(const Features::Kind& kind, const Grid& grid, double unit) {
  Field out(std::ssize(kind.all), 2);
  for (Index k = 0; const Feature& f : kind.all) out.row(k++) << grid.x(f.i) / unit, grid.y(f.j) / unit;
  return out;
}

}  // namespace

Figure features(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  Figure out = map(cases, request);
  out.legend.push_back({LegendEntry::Key::dot, "black", "peaks"});
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Sample sample = measured_whole(cases[c], variable);
    const Grid& grid = sample.grid();
    const Features found(sample.surface().heights, grid, request.pruning, sample.round_off());
    const double unit = out.panels[c].x->unit;
    std::vector<Layer>& layers = out.panels[c].layers;
    const std::size_t hills = found.hills().all.size();
    if (hills <= most_outlined)
      layers.push_back(points(outlines_of(found.hills().hills, grid, unit),
                              "with vectors nohead linewidth 0.8 linecolor rgb 'white'"));
    else
      out.notes.push_back(fmt::format("{} hills have no outlines: show a part, or prune more", hills));
    for (const char* style : {"0.62*dot linecolor rgb 'white'", "0.4*dot linecolor rgb 'black'"})
      layers.push_back(points(peaks_of(found.hills(), grid, unit),
                              std::string("with points pointtype 7 pointsize ") + style));
    if (out.comparison) continue;
    MeasureOptions asked;
    asked.pruning = request.pruning;
    out.title = counted(static_cast<Index>(hills), "hill") + ", " +
                in_words(measure(sample, Group::feature, asked), {"Spd", "Spc"});
  }
  return out;
}

}  // namespace asperity::plot
