#include "tools/surface/drawing.hpp"

#include <cmath>

#include "core/stopwatch.hpp"
#include "dataset/layout.hpp"
#include "surface/running_moments.hpp"
#include "tools/cli/dataset_stream.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/surface_words.hpp"

namespace asperity::cli {
namespace {

// A field on the surface's grid: a way to go over its rows, again and again, and what is known of it.
struct Layer {
  std::string name;
  Meaning meaning;
  std::function<void(const RowSink&)> rows;
  RunningMoments moments;
};

Range range_of(const RunningMoments& moments) {
  if (!std::isfinite(moments.mean())) return {moments.mean(), moments.mean()};  // whatever the extremes are
  return moments.low() <= moments.high() ? Range{moments.low(), moments.high()} : Range{0, 0};
}

class Writer {
 public:
  Writer(const Drawing& drawing, const Tool& tool, Dataset data, const std::string& name)
      : drawing_(drawing), tool_(tool), data_(std::move(data)), out_(name) {
    layers_.push_back({"heights", {"m", "height"}, heights(), {}});
    if (drawing.with_noise)
      layers_.push_back({"noise",
                         {"1", "white noise below the kernel's middle"},
                         [&d = drawing](const RowSink& sink) { d.synthesis.noise_below(d.noise, sink); },
                         {}});
  }

  void write() {
    const bool surveyed = survey_first();
    passes_ = static_cast<double>(layers_.size() * (surveyed && kept_.size() == 0 ? 2 : 1));
    if (surveyed) survey();
    if (drawing_.exact_rq) rescale();
    record();
    tool_.sign(data_);
    out_.head(data_, layers_.size());
    Proportions proportions(grid_of(data_));
    for (Layer& layer : layers_)
      layer.rows([&](Index, Eigen::Ref<Field> rows) {
        if (!surveyed) layer.moments.add(rows);
        if (drawing_.first && &layer == &layers_.front()) proportions.add(rows);
        out_.values(rows);
        advance(rows);
      });
    if (!surveyed) {
      record();
      out_.head(data_, layers_.size());
    }
    out_.close();
    warn_of_proportions(tool_, proportions);
    tool_.write_report(data_);
  }

 private:
  // Moments that stand in front of the heights, or change them.
  bool survey_first() const { return drawing_.exact_rq || !out_.rewritable(); }

  // From memory if it fits and is needed twice, else drawn at each pass.
  std::function<void(const RowSink&)> heights() {
    const Shape shape = drawing_.synthesis.shape();
    const std::size_t working = drawing_.synthesis.working_set(),
                      whole = size(shape.cells()) * sizeof(double);
    if (!survey_first() || working > drawing_.memory || whole > drawing_.memory - working)
      return [&](const RowSink& sink) { drawing_.synthesis.surface(drawing_.noise, sink); };
    kept_ = drawing_.synthesis.surface(drawing_.noise);
    return [&](const RowSink& sink) { sink(0, kept_); };
  }

  void survey() {
    for (Layer& layer : layers_)
      layer.rows([&](Index, Eigen::Ref<Field> rows) {
        layer.moments.add(rows);
        if (kept_.size() == 0) advance(rows);
      });
  }

  void advance(const Eigen::Ref<Field>& rows) {
    done_ += static_cast<double>(rows.rows()) / static_cast<double>(drawing_.synthesis.shape().nx);
    drawing_.progress(done_ / passes_);
  }

  void rescale() {
    Layer& heights = layers_.front();
    const Rescaling rescaling = exact_rms(heights.moments, drawing_.rms);
    if (kept_.size() > 0)
      rescaling.apply(kept_);
    else
      heights.rows = [rescaling, drawn = heights.rows](const RowSink& sink) {
        drawn([&](Index first, Eigen::Ref<Field> rows) {
          rescaling.apply(rows);
          sink(first, rows);
        });
      };
    heights.moments.rescale(rescaling);
  }

  // What is known of the surface by now.
  void record() {
    for (const Layer& layer : layers_)
      defer_values(data_, layer.name, {"x", "y"}, range_of(layer.moments), layer.meaning);
    const Drawing& d = drawing_;
    Attributes& a = data_.attributes;
    a.set("generate_seed", static_cast<double>(d.noise.seed()));
    a.set("generate_stream", static_cast<double>(d.noise.stream()));
    a.set("generate_surface", static_cast<double>(d.noise.surface()));
    a.set("generate_rng", WhiteNoise::generator());
    a.set("generate_rms", d.rms);
    a.set("generate_exact_rq", d.exact_rq ? 1 : 0);
    a.set("generate_method", d.synthesis.summation() == Summation::direct ? "direct" : "transform");
    a.set("generate_seconds", on_record(watch_.seconds()));
  }

  const Drawing& drawing_;
  const Tool& tool_;
  Dataset data_;
  const Stopwatch watch_;
  DatasetStream out_;
  std::vector<Layer> layers_;
  Field kept_;
  double done_ = 0, passes_ = 1;  ///< over the rows
};

}  // namespace

void Drawing::write(const Tool& tool, Dataset data, const std::string& name) const {
  refuse_terminal(name);
  Writer(*this, tool, std::move(data), name).write();
}

}  // namespace asperity::cli
