/// Kernels that are solved for or refused, of asperity-kernel as it is typed.
#pragma once

#include "acf/table.hpp"
#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"

namespace asperity::test {

inline Attributes solved(const std::string& options) {
  const Outcome run = shell("asperity-kernel -q " + options + " -o solved.nc");
  CAPTURE(options, run.error);
  REQUIRE(run.exit == 0);
  CHECK(run.error.empty());
  return read_dataset("solved.nc").attributes;
}

inline Field target_of(const std::string& options) {
  solved(options);
  return known_lags(table_of(read_dataset("solved.nc"), "acf_target", "", Missing::not_a_number));
}

inline void refused(const std::string& line, int code, const std::string& words) {
  const Outcome run = shell(line + " -o absent.nc");
  CAPTURE(line, run.error);
  CHECK(run.exit == code);
  CHECK(lines(run.error) == 1);
  CHECK_THAT(run.error, ContainsSubstring(words));
}

inline void write_text(const std::string& name, const std::string& text) {
  std::ofstream(scratch(name), std::ios::binary) << text;
}

}  // namespace asperity::test
