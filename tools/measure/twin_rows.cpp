#include "tools/measure/twin_rows.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/stopwatch.hpp"
#include "core/words.hpp"
#include "tools/cli/progress.hpp"

namespace asperity::cli {

void errors_by_twins(const Tool& tool, const Sample& sample, const MeasureOptions& asked, TwinUse use,
                     Parameters& parameters) {
  const Stopwatch watch;
  Progress progress(tool);
  TwinOptions options{.threads = tool.thread_count()};
  options.each = [&](Index done) {
    progress.count(static_cast<double>(done), static_cast<double>(options.twins), "twins");
  };
  if (!asperity::errors_by_twins(sample, asked, use, options, parameters))
    tool.note("what lacks a standard error has one by asperity-stats --errors twins");
  const auto count = std::ranges::count_if(parameters, [](const Parameter& p) { return !p.source.empty(); });
  if (count > 0)
    tool.detail(fmt::format("errors of {} from {} twins in {:.2g} s", counted(count, "parameter"),
                            options.twins, watch.seconds()));
}

}  // namespace asperity::cli
