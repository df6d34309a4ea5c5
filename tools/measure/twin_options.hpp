/// --like of asperity-generate: the map that twins are drawn of, and how it is read.
#pragma once

#include <optional>
#include <string>

#include "tools/measure/field_options.hpp"
#include "tools/surface/acf_table.hpp"
#include "tools/surface/generate_options.hpp"

namespace asperity::cli {

struct TwinOptions {
  std::string like;
  FieldOptions map;

  void declare(Tool& tool);
  /// As asperity-acf --taper adds it to the dataset of the map, if there is one. Twins of a periodic map are
  /// periodic: that is set in `generate`. Throws UsageError for options that do not go together.
  std::optional<AcfTable> table(const Tool& tool, GenerateOptions& generate) const;
};

}  // namespace asperity::cli
