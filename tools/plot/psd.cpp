// Power spectral densities over rings of wave numbers, and of the profiles along x and y.
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "stats/measure/spectra.hpp"
#include "tools/measure/field_options.hpp"
#include "tools/plot/curves.hpp"
#include "tools/plot/measured.hpp"

namespace asperity::plot {
namespace {

constexpr double deepest = 1e-12;        // of the largest density; below it round-off is drawn
constexpr double widest_interval = 1e3;  // of the densities, to which intervals are shown
constexpr const char* unsure = "#707070";

using Spectrum = std::vector<SpectrumPoint>;

// A curve of a panel, with its colour and dashes.
struct Trace {
  Spectrum points;
  std::size_t colour;
  bool dashed = false;
};
struct Plane {
  std::vector<Trace> traces = {};
  std::string quantity, unit;  ///< SI
};

// Without the wave number and the densities of which there is no logarithm.
Spectrum positive(Spectrum points) {
  std::erase_if(points, [](const SpectrumPoint& p) { return !(p.wave_number > 0 && p.density > 0); });
  return points;
}

bool known(const SpectrumPoint& p) { return p.interval().known() && !std::isnan(p.standard_error); }

void add_rings(Plane& plane, const Sample& sample, std::size_t colour) {
  const Shape shape = sample.grid().shape;
  if (shape.nx > 1 && shape.ny > 1)
    plane.traces.push_back({positive(radial_spectrum(sample, default_windows(sample.grid()))), colour});
}

void add_profiles(Plane& plane, const Sample& sample, std::size_t c, bool several) {
  const DataWindows windows = default_windows(sample.grid());
  if (sample.grid().shape.nx > 1)
    plane.traces.push_back({positive(profile_spectrum(sample, Axis1D::x, windows.x)), c});
  if (sample.grid().shape.ny > 1)
    plane.traces.push_back(
        {positive(profile_spectrum(sample, Axis1D::y, windows.y)), several ? c : 1, several});
}

Flags known_of(const Trace& t) {
  return column_of(t.points, [](const SpectrumPoint& p) { return known(p) ? 1.0 : 0.0; }) > 0;
}
// Of which neither neighbour has an error: dots, for no line and no band joins them.
Flags alone(const Flags& known) {
  Flags out = known;
  for (Index k = 0; k + 1 < known.size(); ++k)
    if (known(k) && known(k + 1)) out(k) = out(k + 1) = false;
  return out;
}

// Of the densities and their intervals, but not the ends of hardly known ones, which would hide all others.
Range range_of(const Plane& plane) {
  Range densities = nothing, out = nothing;
  for (const Trace& t : plane.traces)
    for (const SpectrumPoint& p : t.points) {
      densities = united(densities, {p.density, p.density});
      if (known(p)) out = united(out, {p.interval().low, p.interval().high});
    }
  return united(densities, {std::max(out.low, densities.low / widest_interval),
                            std::min(out.high, densities.high * widest_interval)});
}

void add_trace(Curves& to, const Trace& t) {
  const std::string colour = line_colour(t.colour);
  const Flags with = known_of(t), single = alone(with);
  const Curves::Column x = column_of(t.points, &SpectrumPoint::wave_number),
                       y = column_of(t.points, &SpectrumPoint::density),
                       low = column_of(t.points, [](const SpectrumPoint&p) { return p.interval().low; }),
                       high = column_of(t.points, [](const SpectrumPoint&p) { return p.interval().high; });
  to.band(x, where(with, low), high, colour, 0.2, false);
  to.line(x, where(with, y), colour, 1.5, t.dashed ? "(8,5)" : "");
  to.bars(x, 0.5 * (low + high), where(single, 0.5 * (high - low)), colour);
  to.dots(x, where(single, y), colour);
  to.circles(x, where(!with, y), colour);
}

Panel panel_of(const Plane& plane) {
  Curves curves;
  for (const Trace& t : plane.traces) add_trace(curves, t);
  Range y = range_of(plane);
  if (!(y.high > 0)) throw DataError("psd", "no density is above zero: there is nothing to draw");
  y = {std::max(y.low, deepest * y.high) / 1.6, y.high * 1.6};
  const Range x{curves.x.low / 1.15, curves.x.high * 1.15};
  Axis along = axis_of(x, cli::unit_for(x.high, "rad m-1"), "wave number"),
       up = axis_of(y, cli::unit_for(y.high, plane.unit), plane.quantity);
  along.logarithmic = up.logarithmic = true;
  Panel out;
  place(out, curves, along, up);
  return out;
}

void name_traces(Figure& figure, const std::vector<Plane>& planes, bool several) {
  using enum LegendEntry::Key;
  std::vector<LegendEntry>& out = figure.legend;
  if (several) {
    if (std::ranges::any_of(planes.back().traces, &Trace::dashed))
      out.push_back({dashes, "black", "along y"});
  } else {
    auto drawn = [&](std::size_t colour) {
      return std::ranges::find(planes.back().traces, colour, &Trace::colour) != planes.back().traces.end();
    };
    const bool rings = planes.size() > 1, along_x = drawn(0);
    if (rings || along_x)
      out.push_back({line, line_colour(0),
                     !rings    ? "along x"
                     : along_x ? "rings, profiles along x"
                               : "rings"});
    if (drawn(1)) out.push_back({line, line_colour(1), "along y"});
  }
  const auto some = [&](auto of) {
    return std::ranges::any_of(planes, [&](const Plane& p) { return std::ranges::any_of(p.traces, of); });
  };
  if (some([](const Trace& t) { return alone(known_of(t)).any(); }))
    out.push_back({dot, unsure, "error known"});
  if (some([](const Trace& t) { return !known_of(t).all(); }))
    out.push_back({circle, unsure, "no error known"});
}

}  // namespace

Figure psd(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  const std::string unit = quantity_of(cases, variable).unit;
  Plane rings{.quantity = "PSD of rings", .unit = cli::density_units(unit, 2)},
      profiles{.quantity = "PSD of profiles", .unit = cli::density_units(unit, 1)};
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Sample sample = measured(cases[c], variable);
    add_rings(rings, sample, c);
    add_profiles(profiles, sample, c, cases.size() > 1);
  }
  for (Plane* plane : {&rings, &profiles})
    std::erase_if(plane->traces, [](const Trace& t) { return t.points.empty(); });
  std::vector<Plane> planes;
  if (!rings.traces.empty()) planes.push_back(std::move(rings));
  planes.push_back(std::move(profiles));
  Figure out{.title = "95 % intervals", .aspect = 0.5, .gap_y = 4.8};
  for (const Plane& plane : planes) out.panels.push_back(panel_of(plane));
  name_cases(out, cases);
  name_traces(out, planes, cases.size() > 1);
  return out;
}

}  // namespace asperity::plot
