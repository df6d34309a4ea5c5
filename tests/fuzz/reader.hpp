/// The readers of files as fuzzing sees them: bytes of a format, by the name of its folder in tests/corpus.
///
/// NetCDF-4 is read apart, as the tools do, and a dataset is used as they use it. A reader makes something of
/// bytes or throws DataError, in time and memory of the order of their number. What a format calls a map, and
/// what a dataset is then made of, the readers of datasets understand.
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

/// Throws std::logic_error where `use` refuses what was read.
template <class Use>
auto must(const std::string& what, Use use) {
  try {
    return use();
  } catch (const DataError& error) {
    throw std::logic_error(what + " is refused: " + error.name + ": " + error.what());
  }
}

inline void require_map(const Dataset& dataset) {
  must("a dataset of a map", [&] { return map_of(dataset, dataset.has("heights") ? "heights" : "values"); });
}

/// Values that are left in a classic file are those read at once; what is written is read as it was; and what
/// the dataset calls heights is a map, or refused.
inline void use_dataset(const Dataset& data, std::string_view bytes) {
  const std::string written = encode_netcdf(data);
  if (bytes.starts_with("CDF")) {
    Bytes file;
    bytes.copy(file.room(bytes.size()), bytes.size());
    file.add(bytes.size());
    const Dataset left = must("a file left on disk", [&] { return open_netcdf(std::move(file)); });
    if (encode_netcdf(left) != written) throw std::logic_error("values left in the file are others");
  }
  const Dataset again = must("what was written", [&] { return decode_netcdf(written); });
  if (encode_netcdf(again) != written) throw std::logic_error("what was written is read as something else");
  map_of(data, "heights");
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
      const Dataset data = decode_netcdf(std::string(bytes));
      try {
        use_dataset(data, bytes);
      } catch (const DataError&) {
      }
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
