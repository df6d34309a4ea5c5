/// The readers of files as fuzzing sees them: bytes of a format, by the name of its folder in tests/corpus.
///
/// NetCDF-4 is read apart, as the tools do. A reader makes something of bytes or throws DataError, in time
/// and memory of the order of their number. What a format calls a map, and what a dataset is then made of,
/// the readers of datasets understand.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "dataset/netcdf.hpp"
#include "formats/format.hpp"
#include "tools/cli/sandbox.hpp"

// UDUNITS' lexer forgets a few bytes of a unit that it does not understand. The leak sanitizer asks.
extern "C" [[gnu::used]] inline const char* __lsan_default_suppressions() { return "leak:libudunits2"; }

namespace asperity::test {

/// The size that a bare matrix does not state is given to it, as by asperity-convert --size.
inline Dataset dataset_of_any_size(Map map) {
  if (map.values.size() == 0) throw std::logic_error("a map without points");
  for (double& spacing : map.spacing)
    if (std::isnan(spacing)) spacing = 1;
  return dataset_of(map);
}

inline void require_map(const Dataset& dataset) {
  try {
    map_of(dataset, dataset.has("heights") ? "heights" : "values");
  } catch (const DataError& error) {
    throw std::logic_error("a dataset whose " + error.name + " is refused: " + error.what());
  }
}

/// What a user may tell of a file, chosen by its size.
inline Reading any_reading(std::size_t size) {
  Reading out(size % 2 == 0 ? Order::yx : Order::xy);
  out.separator = static_cast<Separator>(size % 11 < 5 ? size % 11 : 0);
  out.decimal = static_cast<DecimalMark>(out.separator == Separator::comma || size % 7 > 2 ? 0 : size % 7);
  constexpr const char* columns[] = {"", "none", "1/um,2/um,3/nm", "2/mm,1/um", "x,z", "3"};
  out.columns = columns[size % 6];
  if (size % 5 == 0) out.missing = {"-9999", "x"};
  out.unit_told = size % 4 == 0;
  out.channel = size % 13 == 0 ? "1" : "";
  return out;
}

/// Returns whether the bytes could be read; throws std::logic_error, or anything else, where the reader is
/// wrong.
inline bool reads(const std::string& format, std::string_view bytes) {
  try {
    if (format.starts_with("netcdf")) {
      read_netcdf4_apart(&cli::run_in_sandbox);
      decode_netcdf(std::string(bytes));
    } else {
      const Format& read = format_named(format, "from");
      require_map(dataset_of_any_size(read.decode(bytes, any_reading(bytes.size()))));
    }
    return true;
  } catch (const DataError&) {
    return false;
  }
}

}  // namespace asperity::test
