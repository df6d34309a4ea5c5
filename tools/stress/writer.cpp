#include "tools/stress/writer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "stress/bound.hpp"

namespace asperity::cli {
namespace {

constexpr double fill = 9.9692099683868690e+36;  // NetCDF's own
constexpr double infinity = std::numeric_limits<double>::infinity();

// What is no stress, such as a direction, is kept, and then needs every layer.
std::vector<double> depths_of_interest(const StressScene& s,
                                       const std::vector<StressQuantity::Output>& outputs) {
  if (!(s.least > 0) || !std::ranges::all_of(outputs, [](const auto& o) { return o.units == "Pa"; }))
    return s.depths;
  std::vector<double> out;
  const StressBound bound(s.grid, s.pressure, s.friction, s.poisson);
  std::ranges::copy_if(s.depths, std::back_inserter(out), [&](double z) { return !(bound.at(z) < s.least); });
  return out;
}

}  // namespace

StressWriter::StressWriter(const Tool& tool, StressScene& scene, const StressSelection& selection,
                           const StressOptions& options)
    : tool_(tool),
      scene_(scene),
      selection_(selection),
      outputs_(selection.outputs()),
      rows_(scene.plane ? 1 : scene.grid.shape.nx),
      columns_(scene.plane && scene.plane->along_x ? scene.grid.shape.nx : scene.grid.shape.ny),
      threads_(static_cast<std::size_t>(tool.thread_count())),
      memory_(tool.memory()),
      depths_(depths_of_interest(scene, outputs_)),
      ranges_(outputs_.size(), {infinity, -infinity}),
      progress_(tool),
      told_(tool, {"layer", "depth [um]", "greatest " + outputs_[0].name + " [MPa]"}) {
  const int threads = tool.thread_count();
  const StressScene& s = scene;
  const auto resolution = options.depth_resolution();
  if (s.plane)
    section_.emplace(s.grid, s.pressure, s.friction, s.poisson, *s.plane, threads, resolution);
  else
    volume_.emplace(s.grid, s.pressure, s.friction, s.poisson, threads, resolution);
}

void StressWriter::write(const std::function<void(Attributes&)>& finish) {
  set_depths(scene_.data, scene_.depths);
  const auto result =
      sizeof(double) * outputs_.size() * scene_.depths.size() * static_cast<std::size_t>(rows_ * columns_);
  DatasetStream out(tool_.output_name());
  record();
  tool_.sign(scene_.data);
  auto head = [&] {
    finish(scene_.data.attributes);
    record();
    out.head(scene_.data, outputs_.size());
  };
  if (out.rewritable()) {
    write_file(out);
    head();
  } else if (result <= memory_) {
    const std::vector<Field> kept = keep();
    head();
    for (const Field& values : kept) out.values(values);
  } else {
    passes_ = 1 + outputs_.size();
    layers([&](std::size_t k, Index, Values values) { survey(k, values); });
    head();
    for (std::size_t wanted = 0; wanted < outputs_.size(); ++wanted)
      layers([&](std::size_t k, Index, Values values) {
        if (k == wanted) out.values(Eigen::Map<const Field>(values.data(), rows_, columns_));
      });
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
  layers([&](std::size_t k, Index layer, Values values) {
    survey(k, values);
    out.values_at((static_cast<Index>(k) * count + layer) * rows_ * columns_, values);
  });
}

std::vector<Field> StressWriter::keep() {
  std::vector<Field> kept(outputs_.size(), Field(static_cast<Index>(scene_.depths.size()), rows_ * columns_));
  layers([&](std::size_t k, Index layer, Values values) {
    survey(k, values);
    std::ranges::copy(values, kept[k].row(layer).data());
  });
  return kept;
}

void StressWriter::layers(const Take& take) {
  const Index size = rows_ * columns_;
  std::vector<std::vector<Field>> batch(threads_,
                                        std::vector<Field>(outputs_.size(), Field(rows_, columns_)));
  auto slot = [&](Index l) -> std::vector<Field>& { return batch[static_cast<std::size_t>(l) % threads_]; };
  auto row = [&](Index l, Index i, const StressRow& values) {
    std::vector<double*> out;
    for (Field& f : slot(l)) out.push_back(f.row(i).data());
    selection_.compute(values, columns_, out.data());
  };
  auto finished = [&](Index begin, Index end) {
    for (Index l = begin; l < end; ++l) {
      tell(static_cast<std::size_t>(l), slot(l)[0]);
      for (std::size_t k = 0; k < outputs_.size(); ++k) {
        Field& f = slot(l)[k];
        if (hides(k)) f = (f.abs() >= scene_.least).select(f, fill);
        take(k, l, {f.data(), static_cast<std::size_t>(size)});
      }
    }
  };
  compute(depths_, row, finished);
  const std::vector<double> nothing(static_cast<std::size_t>(size), fill);
  for (auto l = static_cast<Index>(depths_.size()); l < static_cast<Index>(scene_.depths.size()); ++l)
    for (std::size_t k = 0; k < outputs_.size(); ++k) take(k, l, nothing);
}

void StressWriter::compute(const std::vector<double>& depths, const LayerRowSink& row,
                           const LayersFinished& finished) const {
  if (volume_) return volume_->layers(depths, selection_.needs(), row, finished);
  section_->rows(
      depths, selection_.needs(), [&](Index l, Index, const StressRow& values) { row(l, 0, values); },
      finished);
}

void StressWriter::survey(std::size_t output, Values values) {
  auto& [low, high] = ranges_[output];
  double sound = 0;
  for (double v : values) {
    if (v != fill) low = std::min(low, v), high = std::max(high, v);
    sound += 0 * v;
  }
  if (!(sound == 0)) low = high = NAN;  // and stays so
}

void StressWriter::tell(std::size_t l, const Field& values) {
  ++done_;
  progress_.count(static_cast<double>(done_), static_cast<double>(passes_ * depths_.size()),
                  passes_ == 1 ? "layers" : "layers, some of them again");
  if (tool_.verbose() && done_ <= depths_.size())
    told_.row({std::to_string(l + 1), fmt::format("{:.6g}", depths_[l] * 1e6),
               fmt::format("{:.6g}", values.abs().maxCoeff() * 1e-6)});
}

// The outputs behind everything else, with what is known of them by now.
void StressWriter::record() {
  std::vector<std::string> dimensions{"z", "x", "y"};
  std::string plane;
  if (scene_.plane) {
    dimensions.erase(dimensions.begin() + (scene_.plane->along_x ? 2 : 1));
    plane = scene_.plane->along_x ? "section_y" : "section_x";
    set_scalar(scene_.data, plane, place_of(*scene_.plane, scene_.grid), {"m", "place of the section"});
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
