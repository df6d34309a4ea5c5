/// A dataset that is written while its last variables are still being computed.
///
///     DatasetStream out("-");
///     out.head(data, 1);                   // all but the values of the last variable
///     out.values(rows);                    // until all are there
///     if (out.rewritable()) out.head(data, 1);   // with attributes that are known only now
///     out.close();
#pragma once

#include <cstdint>
#include <span>

#include "dataset/dataset.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {

class DatasetStream {
 public:
  /// Throws ParameterError("output", …) for a name of another format.
  explicit DatasetStream(const std::string& name);

  /// Whether head() may be called again: the output is a regular file, no pipe.
  bool rewritable() const { return file_.rewritable(); }
  /// The last `deferred` variables are of doubles and hold none yet. Called again, it replaces the first head;
  /// attributes may differ in value, not in size.
  void head(const Dataset& dataset, std::size_t deferred);
  /// The next values of the deferred variables.
  void values(const Eigen::Ref<const Field>& rows);
  /// Values of the deferred variables from the one numbered `first` on, in any order, where the output is rewritable.
  void values_at(std::int64_t first, std::span<const double> values);
  void close() { file_.close(); }

 private:
  OutputFile file_;
  std::size_t head_bytes_ = 0;
};

}  // namespace asperity::cli
