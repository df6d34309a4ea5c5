/// Datasets in the scratch folder of the shell, and what one counts in its answers.
#pragma once

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "dataset/netcdf.hpp"
#include "support.hpp"
#include "tools/shell.hpp"

namespace asperity::test {

inline Dataset read_dataset(const std::string& name) {
  std::ifstream in(scratch(name), std::ios::binary);
  return decode_netcdf(std::string(std::istreambuf_iterator<char>(in), {}));
}

inline void write_dataset(const Dataset& data, const std::string& name) {
  std::ofstream(scratch(name), std::ios::binary) << encode_netcdf(data);
}

/// The outcome of a line that must succeed.
inline Outcome require(const std::string& line) {
  Outcome run = shell(line);
  CAPTURE(line, run.error);
  REQUIRE(run.exit == 0);
  return run;
}

/// Whether the line of shell has said "SKIPPED: " and why, which is passed on to ctest.
inline bool skipped(const Outcome& run) {
  if (!run.out.starts_with("SKIPPED: ")) return false;
  std::cout << run.out;
  return true;
}

inline auto lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

}  // namespace asperity::test
