/// What the validation programs share: how long a call takes, and on what.
///
/// The number of calls is doubled until a batch lasts 20 ms, so that the clock can be trusted. Of at least
/// five batches, eight if they take less than two seconds, the shortest is what the machine can do when nobody
/// disturbs it; by what share the median one takes longer tells how much it was disturbed. VALIDATION_BATCHES
/// in the environment asks for fewer.
///
/// Calls are repeated in one process, which keeps what memory it has: a computation and the transforms that
/// it is compared with find their pages where they left them. A program's first solve pays for its pages,
/// about 2 us each.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <malloc.h>
#include <vector>

#include <fmt/format.h>

#include "core/stopwatch.hpp"
#include "reference/peak_memory.hpp"
#include "transform/plan.hpp"

namespace asperity {

/// Keeps freed memory in the process instead of giving it back to the system and asking for it anew.
inline void keep_memory() {
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
}

/// Of several runs. A sum is that of the shortest and of the median runs.
struct Seconds {
  double shortest = 0, median = 0;

  operator double() const { return shortest; }
  double spread() const { return shortest > 0 ? median / shortest - 1 : 0; }
  Seconds operator+(const Seconds& other) const { return {shortest + other.shortest, median + other.median}; }
};

class Runs {
 public:
  void add(double seconds) { all_.push_back(seconds); }

  /// Zero of none.
  Seconds seconds() const {
    if (all_.empty()) return {};
    std::vector<double> sorted = all_;
    std::ranges::sort(sorted);
    return {sorted.front(), 0.5 * (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2])};
  }

 private:
  std::vector<double> all_;
};

/// How many batches are timed at most.
inline int batches() {
  const char* asked = std::getenv("VALIDATION_BATCHES");
  return asked ? std::max(1, std::atoi(asked)) : 8;
}

/// Calls `once` so many times.
template <class Once>
void repeat(Once once) {
  constexpr int least = 5;
  const Stopwatch total;
  for (int k = 0; k < batches() && (k < least || total.seconds() < 2); ++k) once();
}

/// A call's.
template <class Call>
Seconds seconds_of(Call call) {
  int calls = 1;
  auto batch = [&] {
    const Stopwatch watch;
    for (int i = 0; i < calls; ++i) call();
    return watch.seconds();
  };
  while (batch() < 0.02) calls *= 2;
  Runs runs;
  repeat([&] { runs.add(batch() / calls); });
  return runs.seconds();
}

/// One real-to-complex transform of this size, the measure of every other cost.
inline Seconds real_transform_seconds(Shape shape) {
  const RealTransform2D transform(shape);
  AlignedVector<double> field(static_cast<std::size_t>(shape.cells()), 1.0);
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  return seconds_of([&] { transform.forward(field.data(), spectrum.data()); });
}

/// The head of a report: what the seconds below it are measured with. To be called first.
inline void print_conditions() {
  keep_memory();
#if defined(__clang__)
  fmt::print("# clang {}", __clang_version__);
#else
  fmt::print("# gcc {}", __VERSION__);
#endif
#ifdef __AVX512F__
  const char* vectors = "AVX-512";
#elif defined(__AVX2__)
  const char* vectors = "AVX2";
#else
  const char* vectors = "SSE2";
#endif
  fmt::print(", {}, {}; one thread unless said\n", vectors, transform_version());
}

}  // namespace asperity

/// Two columns, `seconds` and `seconds_spread` say.
template <>
struct fmt::formatter<asperity::Seconds> : fmt::formatter<double> {
  template <class Context>
  auto format(const asperity::Seconds& s, Context& context) const {
    context.advance_to(fmt::formatter<double>::format(s.shortest, context));
    return fmt::format_to(context.out(), "\t{:.2f}", s.spread());
  }
};
