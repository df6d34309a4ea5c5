#include "tools/plot/isolines.hpp"

namespace asperity::plot {

Isolines isolines(const Field& cells, const Lattice& at, double step) {
  const Range values = range_of(cells);
  if (!(drawable(values) == values)) return {};  // round-off of a constant
  std::string levels;
  for (const double v : multiples(values, step))
    if (values.low < v && v < values.high) levels += fmt::format("{}{}", levels.empty() ? "" : ",", v);
  Isolines out;
  if (levels.empty()) return out;
  out.commands.line("set contour base\nunset surface\nset cntrparam levels discrete {}\nset table $lines",
                    levels);
  Lattice in_space = at;
  in_space.in_space = true;
  out.commands.draw("splot", {raster(cells, in_space, "")});
  out.commands.line("unset table\nunset contour\nset surface");
  for (const char* style :
       {"linewidth 1.6 linecolor rgb '#b0ffffff'", "linewidth 0.7 linecolor rgb '#202020'"})
    out.layers.push_back({fmt::format("using 1:2 with lines {}", style), {}, "$lines"});
  return out;
}

}  // namespace asperity::plot
