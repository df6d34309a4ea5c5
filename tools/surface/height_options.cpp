#include <algorithm>

#include "core/words.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/surface/kernel_options.hpp"

namespace asperity::cli {
namespace {

constexpr double least_fall = 1e-10;  // of R from one point to the next: less is rounding

// (1)
double mean_square_slope(const KernelTables& tables, Shape surface) {
  const Field& R = tables.acf_achieved;
  const Index middle = R.cols() / 2;
  const double variance = R(0, middle);
  double square = 0, fall = 0;
  auto add = [&](Index points, double next, double step) {
    if (points == 1) return;
    square += 2 * (variance - next) / (step * step), fall = std::max(fall, 1 - next / variance);
  };
  add(surface.nx, R.rows() > 1 ? R(1, middle) : 0, (*tables.spacing)[0]);
  add(surface.ny, middle > 0 ? R(0, middle + 1) : 0, (*tables.spacing)[1]);
  check_parameter(fall > least_fall, "rms-slope",
                  "neighbouring heights do not differ beyond rounding; give the rms height");
  return square;
}

}  // namespace

void HeightOptions::declare(Tool& tool, const std::string& rq, const std::string& group) {
  tool.quantity("--rq", rms, "m", rq, group);
  tool.number(
      "--rms-slope", slope,
      "Rms slope in place of --rq, a pure number; the rms height follows. It is the ensemble's Sdq of "
      "asperity-stats: of the differences of neighbouring heights on this grid",
      group);
}

void HeightOptions::check(const Tool& tool) const {
  if (!has_slope()) return;
  if (tool.given("--rq"))
    throw UsageError("rms-slope", "cannot be combined with --rq: the rms height follows from the slope");
  check_parameter(slope >= 1e-100 && slope <= 1e100, "rms-slope",
                  number(slope) + ": must lie in 1e-100 ... 1e100");
}

void HeightOptions::apply(const Tool& tool, KernelTables& tables, Shape surface, Attributes& a) const {
  if (tool.given("--rq")) a.erase("kernel_rms_slope");
  if (!has_slope()) return;
  if (!tables.spacing) throw UsageError("rms-slope", "needs --spacing, or --shape and --size");
  tables.scale(slope / std::sqrt(mean_square_slope(tables, surface)));
  tables.has_height = true;
  a.set("kernel_rms_slope", slope);
  tool.note("--rms-slope " + shortest(slope) + ": the rms height is " +
            format_quantity(std::stod(number(tables.rms())), "m"));
}

}  // namespace asperity::cli
