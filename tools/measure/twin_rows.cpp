#include "tools/measure/twin_rows.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/stopwatch.hpp"
#include "stats/twins/twin_errors.hpp"
#include "tools/cli/progress.hpp"

namespace asperity::cli {
namespace {

// In seconds of one core, about, so that the answer does not depend on the machine.
double seconds_of_twins(const Sample& sample, const MeasureOptions& asked) {
  double seconds = 0;  // for 512x512 points
  for (const Group group : asked.groups)
    seconds += group == Group::gaussianity                           ? 0
               : group == Group::height || group == Group::quantiles ? 0.8
                                                                     : 2.4;
  return seconds * static_cast<double>(sample.grid().shape.cells()) / (512 * 512);
}

}  // namespace

void errors_by_twins(const Tool& tool, const Sample& sample, const MeasureOptions& asked, TwinUse use,
                     Parameters& parameters) {
  const TwinScope scope(sample, asked);
  for (Parameter& p : parameters)
    if (std::isfinite(p.value) && !scope.holds(p) && !scope.theory_holds(p))
      p.standard_error = NAN, p.interval.reset(), p.why = TwinScope::why;
  auto wanted = [&](const Parameter& p) {
    return scope.holds(p) && (use == TwinUse::everywhere || !scope.theory_holds(p));
  };
  if (!sample.size().gives_errors() || std::ranges::none_of(parameters, wanted)) return;
  if (constexpr double quick = 2.5; use == TwinUse::where_quick && seconds_of_twins(sample, asked) > quick) {
    for (Parameter& p : parameters)
      if (wanted(p) && std::isfinite(p.standard_error))
        p.why = "theory does not hold for this texture, see asperity-stats --errors twins";
    return tool.note("what lacks a standard error has one by asperity-stats --errors twins");
  }
  const Stopwatch watch;
  Progress progress(tool);
  TwinOptions options{.threads = tool.thread_count()};
  options.each = [&](Index done) {
    progress.count(static_cast<double>(done), static_cast<double>(options.twins), "twins");
  };
  TwinErrors(sample, asked, options).apply(parameters, wanted);
  const auto count = std::ranges::count_if(parameters, [](const Parameter& p) { return !p.source.empty(); });
  tool.detail(fmt::format("errors of {} parameters from {} twins in {:.2g} s", count, options.twins,
                          watch.seconds()));
}

}  // namespace asperity::cli
