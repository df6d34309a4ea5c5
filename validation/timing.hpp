/// What the validation programs share: how long a call takes, and on what.
///
/// The number of calls is doubled until a batch lasts 20 ms, so that the clock can be trusted; the fastest of
/// eight batches is what the machine can do when nobody disturbs it. After two seconds no further batch is
/// begun. The environment variable VALIDATION_BATCHES asks for fewer.
///
/// Calls are repeated in one process, which keeps what memory it has: a computation and the transforms that
/// it is compared with find their pages where they left them. A program's first solve pays for its pages,
/// about 2 us each.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <malloc.h>

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

/// How many batches are timed.
inline int batches() {
  const char* asked = std::getenv("VALIDATION_BATCHES");
  return asked ? std::max(1, std::atoi(asked)) : 8;
}

/// Seconds a call.
template <class Call>
double seconds_of(Call call) {
  int calls = 1;
  auto batch = [&] {
    const Stopwatch watch;
    for (int i = 0; i < calls; ++i) call();
    return watch.seconds();
  };
  const Stopwatch total;
  double fastest = batch();
  for (; fastest < 0.02; fastest = batch()) calls *= 2;
  for (int i = 0; i < batches() && total.seconds() < 2; ++i) fastest = std::min(fastest, batch());
  return fastest / calls;
}

/// One real-to-complex transform of this size, the measure of every other cost.
inline double real_transform_seconds(Shape shape) {
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
  fmt::print(", {}, {}; fastest of {} batches of 20 ms, or of 2 s of them, one thread unless said\n", vectors,
             transform_version(), batches());
}

}  // namespace asperity
