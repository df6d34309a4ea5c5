/// The readers of files as fuzzing sees them: bytes of a format, by the name of its folder in tests/corpus.
///
/// A reader makes something of bytes or throws DataError, in time and memory of the order of their number. What a format
/// calls a map, and what a dataset is then made of, the readers of datasets understand.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "dataset/netcdf.hpp"
#include "formats/format.hpp"
#include "grid/error.hpp"

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

/// Returns whether the bytes could be read; throws std::logic_error, or anything else, where the reader is wrong.
inline bool reads(const std::string& format, std::string_view bytes) {
  try {
    if (format.starts_with("netcdf")) {
      decode_netcdf(std::string(bytes));
    } else {
      const Order order = bytes.size() % 2 == 0 ? Order::yx : Order::xy;
      require_map(dataset_of_any_size(format_named(format, "format").decode(bytes, order)));
    }
    return true;
  } catch (const DataError&) {
    return false;
  }
}

}  // namespace asperity::test
