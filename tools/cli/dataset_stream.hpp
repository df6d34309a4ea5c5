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
#include <stdexcept>

#include "dataset/netcdf.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {

class DatasetStream {
 public:
  /// Throws ParameterError("output", …) for a name of another format.
  explicit DatasetStream(const std::string& name) : file_((check_dataset_name(name), name)) {}

  /// Whether head() may be called again: the output is a regular file, no pipe.
  bool rewritable() const { return file_.rewritable(); }
  /// The last `deferred` variables are of doubles and hold none yet. Another call replaces the head;
  /// attributes may differ in value, not in size.
  void head(const Dataset& dataset, std::size_t deferred) {
    const std::string bytes = encode_netcdf(dataset, deferred);
    if (head_bytes_ > 0 && bytes.size() != head_bytes_)
      throw std::logic_error("a head of another length cannot replace the first one");
    if (head_bytes_ > 0)
      file_.rewrite(bytes);
    else
      file_.write(bytes);
    head_bytes_ = bytes.size();
  }
  /// The next values of the deferred variables.
  void values(const Eigen::Ref<const Field>& rows) {
    for (Index i = 0; i < rows.rows(); ++i)
      file_.write(encode_values({rows.row(i).data(), static_cast<std::size_t>(rows.cols())}));
  }
  /// The same from the value numbered `first` on, in any order, where the output is rewritable.
  void values_at(std::int64_t first, std::span<const double> values) {
    const auto before = first * static_cast<std::int64_t>(sizeof(double));
    file_.write_at(encode_values(values), static_cast<std::int64_t>(head_bytes_) + before);
  }
  void close() { file_.close(); }

 private:
  OutputFile file_;
  std::size_t head_bytes_ = 0;
};

}  // namespace asperity::cli
