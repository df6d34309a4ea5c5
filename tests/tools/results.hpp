/// What tests of the table of results and of lineage share.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "dataset/catalogue.hpp"
#include "dataset/dataset.hpp"
#include "support.hpp"
#include "tools/files.hpp"

namespace asperity::test {

using Words = std::set<std::string>;

inline const std::string bodies = " --radius 50mm --young 208GPa --poisson 0.3 ";

/// Of a variable or an attribute, "" of what the tools do not know.
inline std::string owner(const std::string& name) {
  const KnownResult* result = result_of(name);
  return result ? std::string(result->name) : std::string();
}

inline bool is_coordinate(const Variable& v) { return v.dimensions == std::vector<std::string>{v.name}; }

}  // namespace asperity::test
