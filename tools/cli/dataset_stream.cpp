#include "tools/cli/dataset_stream.hpp"

#include <stdexcept>

#include "dataset/netcdf.hpp"
#include "tools/cli/output_name.hpp"

namespace asperity::cli {

namespace {

const std::string& checked(const std::string& name) {
  check_dataset_name(name);
  return name;
}

}  // namespace

DatasetStream::DatasetStream(const std::string& name) : file_(checked(name)) {}

void DatasetStream::head(const Dataset& dataset, std::size_t deferred) {
  const std::string bytes = encode_netcdf(dataset, deferred);
  if (head_bytes_ == 0)
    file_.write(bytes);
  else if (bytes.size() == head_bytes_)
    file_.rewrite(bytes);
  else
    throw std::logic_error("a head of another length cannot replace the first one");
  head_bytes_ = bytes.size();
}

void DatasetStream::values_at(std::int64_t first, std::span<const double> values) {
  file_.write_at(encode_values(values),
                 static_cast<std::int64_t>(head_bytes_) + first * static_cast<std::int64_t>(sizeof(double)));
}

void DatasetStream::values(const Eigen::Ref<const Field>& rows) {
  for (Index i = 0; i < rows.rows(); ++i)
    file_.write(encode_values({rows.row(i).data(), static_cast<std::size_t>(rows.cols())}));
}

}  // namespace asperity::cli
