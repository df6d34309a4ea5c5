/// Tables of the distribution of the heights of a field, compared with the Gaussian of the same mean and Sq,
/// or of a quantity of a contact that only a part of the cells has, without a Gaussian.
#pragma once

#include <optional>
#include <string>

#include "dataset/dataset.hpp"
#include "stats/height/distribution.hpp"
#include "stats/measure/sample.hpp"
#include "tools/cli/table.hpp"

namespace asperity::cli {

// ---- a whole field ----

/// Columns: height, count, standard_error, low_95, high_95, gaussian, misfit, density, density_error,
/// gaussian_density.
Table histogram_of(const Sample& heights, int bins, std::optional<HeightRange> range = {});
/// Columns: height, density, standard_error, low_95, high_95, gaussian_density, misfit. The bandwidth is in
/// metres.
Table density_of(const Sample& heights, double bandwidth, int rows, std::optional<HeightRange> range = {});
/// Columns: share, normal_quantile, height, standard_error, low_95, high_95, gaussian_height, misfit.
Table quantiles_of(const Sample& heights, int rows);

// ---- the pressure of the cells in contact, the gap of the open ones ----

struct CountedCells {
  std::string variable, units;
  Grid grid;
  Field values;         ///< NaN on the other cells
  double cells = 0;     ///< that are not missing
  double counted = 0;   ///< of them
  std::string which;    ///< "in contact" or "open"
  std::string without;  ///< what the others are: "open, without pressure"

  /// "pressure of the 3152 cells that are in contact; the other 95.2 % of 65536 cells …".
  std::string words() const;
  /// The same where all cells are measured, and what counts these alone.
  std::string words_for_all() const;
};

/// Of the variables pressure, and gap where a contact or a pressure shows which cells are open; of others
/// nothing. Throws DataError where no cell is counted.
std::optional<CountedCells> counted_cells(const Dataset& data, const std::string& variable);

/// A part of the cells, and the sample of their values; none where all are the same, which have no errors.
struct Part {
  const CountedCells& cells;
  std::optional<Sample> values = {};

  explicit Part(const CountedCells& of, int threads = 1) : cells(of) {
    if (height_range(of.values).width() > 0)
      values.emplace(
          Surface{.grid = of.grid, .heights = of.values, .variable = of.variable, .units = of.units},
          threads);
  }
};
/// So many bins from 0 to `largest`. Columns: the variable, count, standard_error, low_95, high_95, share of
/// all cells, density and density_error.
Table histogram_of(const Part& part, int bins, double largest);
/// Columns: share, the variable, standard_error, low_95, high_95.
Table quantiles_of(const Part& part, int rows);

}  // namespace asperity::cli
