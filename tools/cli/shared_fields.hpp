/// Fields of a dataset that the first of several ranks writes, each rank holding its rows.
///
///     SharedFields fields(slabs);
///     fields.set(data, "pressure", own_rows, meaning);            // on every rank
///     fields.first_writes([&] { tool.write(data); });
///
/// The first rank writes the file as if it were alone, to any place it likes; the values come from the ranks
/// that have them as they are written, piece by piece. So the file has the bytes of one rank's, and no rank
/// ever holds a whole field. Alone, a field is simply set.
///
/// Collective, as core/ranks.hpp.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/ranks.hpp"
#include "dataset/layout.hpp"

namespace asperity::cli {

class SharedFields {
 public:
  explicit SharedFields(const Slabs& slabs);

  const Slabs& slabs() const;
  /// As set_field of all rows.
  void set(Dataset& data, std::string_view name, Field own, Meaning meaning);
  /// write() on the first rank, while the others answer for their rows.
  void first_writes(const std::function<void()>& write) const;

 private:
  class Served;
  std::shared_ptr<Served> served_;
};

/// The rows of a whole field that a rank has.
inline Field own_rows(const Field& whole, const Slabs& slabs) {
  return whole.middleRows(slabs.own().first, slabs.own().count);
}

}  // namespace asperity::cli
