#include "tools/stress/writer.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "dataset/conventions.hpp"
#include "stress/load.hpp"

namespace asperity::cli {
namespace {

constexpr double fill = default_fill;
constexpr double infinity = std::numeric_limits<double>::infinity();

// What is no stress, such as a direction, is kept, and then needs every layer.
std::vector<double> depths_of_interest(const StressScene& s, const std::vector<StressOutput>& outputs) {
  if (!(s.least > 0) || s.residual || !std::ranges::all_of(outputs, &StressOutput::is_stress))
    return s.depths;
  std::vector<double> out;
  const double bound = stress_bound(s.body);
  std::ranges::copy_if(s.depths, std::back_inserter(out),
                       [&](double z) { return !(bound / (z * z) < s.least); });
  return out;
}

// Rows on their way to the first rank, which takes its own as they come.
class RowsToFirst {
 public:
  RowsToFirst(const StressSolver& solver, std::size_t outputs)
      : ranks_(*solver.body().ranks),
        rows_(solver.body().rows()),
        own_(solver.rows()),
        kept_(ranks_.rank() == 0 ? 0 : outputs, Field(LayerWork::rows_at_a_time, solver.shape().ny)),
        filled_(outputs) {}

  bool first() const { return ranks_.rank() == 0; }
  /// From any thread.
  void keep(std::size_t output, Index i, std::span<const double> values) {
    std::ranges::copy(values, kept_[output].row((i - own_.first) % LayerWork::rows_at_a_time).data());
    filled_[output] = true;
  }
  /// After each rank's rows from `begin` on: take(output, i, values) on the first, for those of the others.
  template <class Take>
  void send(Index begin, Index columns, Take take) {
    std::vector<std::size_t> filled;
    for (std::size_t k = 0; k < filled_.size(); ++k)
      if (filled_[k].exchange(false)) filled.push_back(k);
    filled = gathered(ranks_, filled);
    std::ranges::sort(filled);
    filled.erase(std::unique(filled.begin(), filled.end()), filled.end());
    for (const std::size_t k : filled)
      for (int r = 1; r < ranks_.count(); ++r) send(k, r, begin, columns, take);
  }

 private:
  template <class Take>
  void send(std::size_t k, int from, Index begin, Index columns, Take take) const {
    const Extent theirs = rows_.of(from);
    const Index count = std::clamp<Index>(theirs.count - begin, 0, LayerWork::rows_at_a_time);
    const auto all = static_cast<std::size_t>(ranks_.count());
    Ranks::Pieces to(all);
    Ranks::Room room(all);
    Field rows;
    if (first()) {
      rows.resize(count, columns);
      room[static_cast<std::size_t>(from)] =
          std::as_writable_bytes(std::span(rows.data(), size(rows.size())));
    } else if (ranks_.rank() == from) {
      to.front() = std::as_bytes(std::span(kept_[k].data(), size(count * columns)));
    }
    ranks_.exchange(to, room);
    for (Index i = 0; i < rows.rows(); ++i)
      take(k, theirs.first + begin + i, std::span<const double>(rows.row(i).data(), size(columns)));
  }

  const Ranks& ranks_;
  const Slabs rows_;
  const Extent own_;
  std::vector<Field> kept_;                // of each output
  std::vector<std::atomic<bool>> filled_;  // likewise
};

}  // namespace

StressWriter::StressWriter(const Tool& tool, StressScene& scene, const StressSelection& selection,
                           const StressSolver& solver)
    : tool_(tool),
      scene_(scene),
      selection_(selection),
      solver_(solver),
      outputs_(selection.outputs()),
      shape_(solver.shape()),
      depths_(depths_of_interest(scene, outputs_)),
      ranges_(outputs_.size(), {infinity, -infinity}),
      largest_(depths_.size()),
      progress_(tool),
      steps_(tool, {"layer", "depth [um]", "greatest " + outputs_[0].name + " [MPa]"}) {}

void StressWriter::write(const std::function<void()>& finish) {
  if (tool_.is_first_rank()) return write_all(finish);
  if (scene_.body.ranks->count() == 1) return;  // all ranks alike
  for (Index pass = agreed_passes(0); pass > 0; --pass) layers({});
}

Index StressWriter::agreed_passes(Index of_the_first) const {
  return gathered(*scene_.body.ranks, std::vector{of_the_first}).front();
}

void StressWriter::write_all(const std::function<void()>& finish) {
  set_depths(scene_.data, scene_.depths);
  const auto result =
      sizeof(double) * outputs_.size() * scene_.depths.size() * static_cast<std::size_t>(shape_.cells());
  DatasetStream out(tool_.output_name());
  record();
  tool_.sign(scene_.data);
  constexpr std::size_t a_warning = 1024;  // of the yield stress: in the end
  if (std::isfinite(scene_.yield_stress())) out.reserve(scene_.data, a_warning);
  auto head = [&] {
    finish();
    record();
    out.head(scene_.data, outputs_.size());
  };
  const bool once = out.rewritable() || result <= tool_.memory();
  passes_ = size(agreed_passes(once ? 1 : 1 + std::ssize(outputs_)));
  if (out.rewritable()) {
    write_file(out);
    head();
  } else if (once) {
    const std::vector<Field> kept = keep();
    head();
    for (const Field& values : kept) out.values(values);
  } else {
    layers([](std::size_t, Index, Index, Values) {});
    head();
    for (std::size_t wanted = 0; wanted < outputs_.size(); ++wanted) write_again(out, wanted);
  }
  out.close();
  tool_.write_report(scene_.data);
}

double StressWriter::largest(std::string_view output) const {
  double top = 0;
  for (std::size_t k = 0; k < outputs_.size(); ++k)
    if (outputs_[k].name == output) top = std::max(top, ranges_[k].high);
  return top;
}

void StressWriter::write_file(DatasetStream& out) {
  const auto count = static_cast<Index>(scene_.depths.size());
  out.head(scene_.data, outputs_.size());
  layers([&](std::size_t k, Index layer, Index i, Values values) {
    out.values_at((static_cast<Index>(k) * count + layer) * shape_.cells() + i * shape_.ny, values);
  });
  out.flush();
}

std::vector<Field> StressWriter::keep() {
  std::vector<Field> kept(outputs_.size(), Field(static_cast<Index>(scene_.depths.size()), shape_.cells()));
  layers([&](std::size_t k, Index layer, Index i, Values values) {
    std::ranges::copy(values, kept[k].row(layer).data() + i * shape_.ny);
  });
  return kept;
}

void StressWriter::write_again(DatasetStream& out, std::size_t wanted) {
  std::vector<Field> batch(size(solver_.threads()), Field(shape_.nx, shape_.ny));
  auto slot = [&](Index l) -> Field& { return batch[size(l) % batch.size()]; };
  layers(
      [&](std::size_t k, Index layer, Index i, Values values) {
        if (k == wanted) std::ranges::copy(values, slot(layer).row(i).data());
      },
      [&](Index layer) { out.values(slot(layer)); });
}

void StressWriter::layers(const Take& take, const std::function<void(Index layer)>& finished) {
  const bool first_pass = done_ == 0, noted = tool_.verbose() && first_pass;
  LayerRows rows(selection_, solver_);
  RowsToFirst to_first(solver_, outputs_.size());
  auto compute = [&](Index l, StressSolver::Workspace& work) {
    auto take_row = [&](std::size_t k, Index i, std::span<double> values) {
      if (noted && k == 0) note_largest(l, values);
      if (hides(k))
        for (double& v : values) v = std::abs(v) >= scene_.least ? v : fill;
      if (first_pass) survey(k, values);
      to_first.first() ? take(k, l, i, values) : to_first.keep(k, i, values);
    };
    rows.compute(l, depths_[size(l)], work, take_row, [&](Index begin) {
      to_first.send(begin, shape_.ny, [&](std::size_t k, Index i, Values values) { take(k, l, i, values); });
    });
  };
  auto after = [&](Index l) {
    if (finished && to_first.first()) finished(l);
  };
  solver_.each_layer(depths_, compute, [&](Index begin, Index end) {
    for (Index l = begin; l < end; ++l) {
      report(size(l));
      after(l);
    }
  });
  const std::vector<double> nothing(size(shape_.ny), fill);
  for (auto l = static_cast<Index>(depths_.size()); l < static_cast<Index>(scene_.depths.size()); ++l) {
    for (std::size_t k = 0; k < outputs_.size() && to_first.first(); ++k)
      for (Index i = 0; i < shape_.nx; ++i) take(k, l, i, nothing);
    after(l);
  }
  if (first_pass) agree_on_ranges();
}

void StressWriter::agree_on_ranges() {
  const Ranks& ranks = *scene_.body.ranks;
  if (ranks.count() == 1) return;
  for (Range& range : ranges_)
    range = {-asperity::largest(ranks, -range.low), asperity::largest(ranks, range.high)};
}

void StressWriter::survey(std::size_t output, Values values) {
  double low = infinity, high = -infinity, sound = 0;
  for (double v : values) {
    if (v != fill) low = std::min(low, v), high = std::max(high, v);
    sound += 0 * v;
  }
  if (!(sound == 0)) low = high = NAN;
  const std::scoped_lock lock(mutex_);
  Range& range = ranges_[output];
  range.low = std::isnan(low) ? low : std::min(range.low, low);  // NaN stays
  range.high = std::isnan(high) ? high : std::max(range.high, high);
}

void StressWriter::note_largest(Index layer, Values values) {
  double top = 0;
  for (double v : values) top = std::max(top, std::abs(v));
  const std::scoped_lock lock(mutex_);
  largest_[size(layer)] = std::max(largest_[size(layer)], top);
}

void StressWriter::report(std::size_t l) {
  ++done_;
  if (tool_.verbose()) largest_[l] = asperity::largest(*scene_.body.ranks, largest_[l]);
  progress_.count(static_cast<double>(done_), static_cast<double>(passes_ * depths_.size()),
                  passes_ == 1 ? "layers" : "layers, in several passes");
  if (tool_.verbose() && done_ <= depths_.size())
    steps_.row({std::to_string(l + 1), fmt::format("{:.6g}", depths_[l] * 1e6),
                fmt::format("{:.6g}", largest_[l] * 1e-6)});
}

// The outputs come last, with what is known of them by now.
void StressWriter::record() {
  std::vector<std::string> dimensions{"z", "x", "y"};
  std::string plane;
  if (scene_.plane) {
    dimensions.erase(dimensions.begin() + (scene_.plane->along_x ? 2 : 1));
    plane = scene_.plane->along_x ? "section_y" : "section_x";
    set_scalar(scene_.data, plane, place_of(*scene_.plane, scene_.body.grid), {"m", "place of the section"});
  }
  for (std::size_t k = 0; k < outputs_.size(); ++k) {
    const auto& [name, long_name, units] = outputs_[k];
    const Range range = ranges_[k].low > ranges_[k].high ? Range{0, 0} : ranges_[k];
    defer_values(scene_.data, name, dimensions, range, {units, long_name});
    Attributes& a = scene_.data.find(name)->attributes;
    if (hides(k)) a.set("_FillValue", fill);
    if (!plane.empty()) a.set("coordinates", plane);
  }
}

}  // namespace asperity::cli
