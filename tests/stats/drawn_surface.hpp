/// A surface drawn with a correlation that is known, and the statistics tools on it.
#pragma once

#include <nlohmann/json.hpp>

#include "dataset/layout.hpp"
#include "fields.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

namespace asperity::test {

using Json = nlohmann::json;

inline const Shape window{8, 5};

/// 0.4 µm of moving average over 8 × 5 points of 20 µm × 30 µm, with the target that belongs to it.
inline Dataset drawn_surface() {
  Dataset data;
  const Grid grid{{96, 80}, 20e-6, 30e-6, false};
  set_grid(data, grid);
  set_field(data, "heights", 0.4e-6 * moving_average(grid.shape, window, 31), {"m", "heights"});
  const LagField rho = triangular_correlation(window);
  const Field target =
      Field::NullaryExpr(11, 15, [&](Index p, Index column) { return 0.16e-12 * rho(p, column - 7); });
  set_table(data, "acf_target", target, {"p", 0, 20e-6, "m"}, {"q", -7, 30e-6, "m"},
            {"m2", "autocorrelation asked for"});
  return data;
}

/// A command line, with it in drawn.nc.
inline Outcome run_on_surface(const std::string& command) {
  write_dataset(drawn_surface(), "drawn.nc");
  return shell(command);
}

inline Json json_of(const std::string& command) {
  const Outcome run = run_on_surface(command);
  INFO(run.error);
  REQUIRE(run.exit == 0);
  return Json::parse(run.out);
}

}  // namespace asperity::test
