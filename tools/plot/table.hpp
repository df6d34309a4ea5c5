/// Tables that the tools print, as datasets: columns between tabs under "# name [unit]"
/// (tools/cli/table.hpp).
#pragma once

#include <string>
#include <string_view>

#include "core/field.hpp"
#include "dataset/dataset.hpp"

namespace asperity::plot {

/// A variable on the dimension "row" for each column of numbers; nan and inf stay. Throws DataError("table",
/// …) for a text without such a header, without a row, or with a row of another length.
Dataset dataset_of_table(std::string_view text);

/// Whether the dataset is a table.
bool is_table(const Dataset& data);
/// A column in SI, in place of which NaN stands where the table has none of this name.
Eigen::ArrayXd column(const Dataset& table, std::string_view name);
/// Half the 95 % intervals of means over the column "surfaces", with Student's t; NaN of a single one.
/// `error` names the column of standard errors. Without such a column the errors count as known exactly.
Eigen::ArrayXd half_intervals(const Dataset& table, std::string_view error);

}  // namespace asperity::plot
