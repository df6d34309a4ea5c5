// Surfaces whose heights are not Gaussian, from the command line: what their tests share.
#pragma once

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"

namespace asperity::test {

inline const std::string measured = ASPERITY_TEST_DATA "/afm-64x64.nc";
inline const std::string common = " --rq 0.4um --length 6px,4px", shaped = " --skewness -1.3 --kurtosis 6";
inline const std::string grid = " --shape 300x200 --size 3mm,2mm --no-history";

inline Field heights(const std::string& name) { return field_of(read_dataset(name), "heights"); }

inline double attribute(const std::string& file, const std::string& name) {
  return read_dataset(file).attributes.number(name, NAN);
}

// One line on standard error that names all of these, this exit code, and no file.
inline void refused(const std::string& line, int exit, std::initializer_list<std::string> words) {
  const Outcome run = shell(line + " -o absent.nc");
  CAPTURE(line, run.error);
  CHECK(run.exit == exit);
  CHECK(lines(run.error) == 1);
  for (const std::string& word : words) CHECK_THAT(run.error, ContainsSubstring(word));
  CHECK(shell("ls absent.nc").exit != 0);
}

}  // namespace asperity::test
