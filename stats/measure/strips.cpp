#include "stats/measure/strips.hpp"

#include <string>
#include <utility>

#include "core/error.hpp"

namespace asperity {
namespace {

constexpr std::size_t bytes_a_point = 80;  // of a strip, with its transform and its lags
constexpr std::size_t bytes_a_point_of_columns = 32;

// The rows of a strip; all strips but the last have the same number.
Index rows_of_strip(const Grid& grid, std::size_t memory) {
  const std::size_t row = bytes_a_point * static_cast<std::size_t>(grid.shape.ny);
  const auto most = static_cast<Index>(memory / row);
  if (most < 4)
    throw ParameterError("memory", "'" + std::to_string(memory) + "' bytes do not hold 4 rows of " +
                                       std::to_string(grid.shape.ny) + " points; allow at least " +
                                       std::to_string(4 * row) + " bytes");
  const Index strips = (grid.shape.nx + most - 1) / most;
  return (grid.shape.nx + strips - 1) / strips;
}

// At least one, whatever the memory.
Index columns_of_strip(const Grid& grid, std::size_t memory) {
  const std::size_t column = bytes_a_point_of_columns * static_cast<std::size_t>(grid.shape.nx);
  return std::clamp<Index>(static_cast<Index>(memory / column), 1, grid.shape.ny);
}

}  // namespace

StripReader::StripReader(FieldParts parts, int degree, std::size_t memory)
    : parts_(std::move(parts)),
      degree_(degree),
      rows_(rows_of_strip(grid(), memory)),
      columns_(columns_of_strip(grid(), memory)) {
  MeanSum sum;
  for_each_strip(0, [&](const Field& strip, Index, Index) {
    sum.add(strip);
    steps_.add(strip);
    largest_ = std::max(largest_, strip.abs().maxCoeff<Eigen::PropagateNumbers>());
  });
  mean_ = sum.mean();
  points_ = sum.count();
  if (degree > 0) form_.emplace(grid().shape, degree);
  while (form_ && !form_->done()) {
    for_each_strip(0, [&](const Field& strip, Index, Index first) { form_->add(strip, first); });
    form_->end_pass();
  }
}

Field StripReader::strip(Index first, Index core, Index halo) const {
  const Index nx = grid().shape.nx, within = std::min(core + halo, nx - first);
  Field out = parts_.rows(first, within);
  if (grid().periodic.both() && rows_ < nx && within < core + halo) {
    const Index around = core + halo - within;
    out.conservativeResize(core + halo, Eigen::NoChange);
    out.bottomRows(around) = parts_.rows(0, around);
  }
  out = (out - mean_.base) - mean_.above;
  if (form_) {
    form_->remove(out.topRows(within), first);
    form_->remove(out.bottomRows(out.rows() - within), 0);
  }
  return out;
}

Field StripReader::columns(Index first, Index count) const {
  Field out = parts_.columns(first, count);
  out = (out - mean_.base) - mean_.above;
  if (form_) form_->remove(out, 0, first);
  return out;
}

}  // namespace asperity
