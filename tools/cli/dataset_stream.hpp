/// A dataset that is written while its last variables are still being computed.
///
///     DatasetStream out("-");
///     out.head(data, 1);                   // all but the values of the last variable
///     out.values(rows);                    // until all are there
///     if (out.rewritable()) out.head(data, 1);   // with attributes that are known only now
///     out.close();
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <utility>

#include "dataset/netcdf.hpp"
#include "tools/cli/ordered_work.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {

class DatasetStream {
 public:
  /// Throws ParameterError("output", …) for a name of another format.
  explicit DatasetStream(const std::string& name)
      : file_(std::make_shared<OutputFile>((check_dataset_name(name), name))) {}

  /// Whether head() may be called again: the output is a regular file, no pipe.
  bool rewritable() const { return file_->rewritable(); }
  /// The head of this dataset may come to take `room` bytes more, in file and pipe alike.
  void reserve(const Dataset& dataset, std::size_t room) {
    head_bytes_ = encode_netcdf(dataset, dataset.variables.size()).size() + room;
  }
  /// The last `deferred` variables are of doubles and hold none yet. Another call replaces the head;
  /// attributes may differ in value, and in size as far as reserve() made room.
  void head(const Dataset& dataset, std::size_t deferred) {
    if (values_from_ > 0) return replace_head(dataset);
    write_netcdf(
        dataset,
        [&](std::string_view piece) {
          if (values_from_ == 0) head_bytes_ = piece.size();
          values_from_ += piece.size();
          file_->write(piece);
        },
        deferred, head_bytes_);
  }
  /// The next values of the deferred variables.
  void values(const Eigen::Ref<const Field>& rows) {
    for (Index i = 0; i < rows.rows(); ++i)
      file_->write(encode_values({rows.row(i).data(), static_cast<std::size_t>(rows.cols())}));
  }
  /// The same from the value numbered `first` on, in any order and from several threads, where the output is
  /// rewritable. What continues other values waits for more, until flush().
  void values_at(std::int64_t first, std::span<const double> values) {
    constexpr std::size_t long_enough = 1 << 16;
    std::string run = run_to(first);
    const std::int64_t begin = first - static_cast<std::int64_t>(run.size() / sizeof(double));
    run += encode_values(values);
    if (run.size() >= long_enough) return write_run(begin, run);
    const std::scoped_lock lock(mutex_);
    waiting_[first + static_cast<std::int64_t>(values.size())] = std::move(run);
  }
  void flush() {
    for (const auto& [end, run] : std::exchange(waiting_, {}))
      write_run(end - static_cast<std::int64_t>(run.size() / sizeof(double)), run);
  }
  /// The file gets its name in order (cli/ordered_work.hpp).
  void close() {
    flush();
    in_order([file = file_] { file->close(); });
  }

 private:
  // The bytes that wait for the value numbered `end`.
  std::string run_to(std::int64_t end) {
    const std::scoped_lock lock(mutex_);
    auto found = waiting_.extract(end);
    return found ? std::move(found.mapped()) : std::string();
  }
  void write_run(std::int64_t first, const std::string& run) {
    const auto before = first * static_cast<std::int64_t>(sizeof(double));
    file_->write_at(run, static_cast<std::int64_t>(values_from_) + before);
  }

  // All that is there of a dataset without any values, which stay as they are.
  void replace_head(const Dataset& dataset) {
    const std::string bytes = encode_netcdf(dataset, dataset.variables.size(), head_bytes_);
    if (bytes.size() != head_bytes_)
      throw std::logic_error("a head of another length cannot replace the first one");
    file_->rewrite(bytes);
  }

  std::shared_ptr<OutputFile> file_;
  std::size_t head_bytes_ = 0, values_from_ = 0;
  std::map<std::int64_t, std::string> waiting_;  ///< by the number of the value that continues them
  std::mutex mutex_;                             ///< of those
};

}  // namespace asperity::cli
