// The padded convolution of a contact by ranks: seconds and their spread (timing.hpp), as the first rank tells.
//     mpirun -n R convolution_ranks N THREADS
#include <cstdlib>

#include <fmt/format.h>

#include "core/launch.hpp"
#include "core/stopwatch.hpp"
#include "timing.hpp"
#include "transform/convolution.hpp"

using namespace asperity;

int main(int argc, char** argv) {
  if (argc != 3) return EXIT_FAILURE;
  const Index n = std::atoi(argv[1]);
  const int threads = std::atoi(argv[2]);
  const Ranks& ranks = launched();
  const Shape shape{n, n}, torus = padded_torus(shape);
  const Field symbol = even_transfer_function(
      torus, [](Index i, Index j) { return 1 / static_cast<double>(1 + i * i + j * j); }, threads, ranks);
  EvenConvolution convolution(shape, torus, symbol, threads, {}, ranks);
  Field field = Field::Ones(Slabs(n, ranks).own().count, n);
  Runs runs;
  for (int k = 0; k < 6; ++k) {
    gathered(ranks, std::vector{k});  // all begin together
    const Stopwatch watch;
    convolution.apply(field, field);
    const double seconds = largest(ranks, watch.seconds());
    if (k > 0) runs.add(seconds);  // the first finds its pages
    field = 1;
  }
  if (ranks.rank() == 0) fmt::print("{:.2e}\n", runs.seconds());
  ranks.end(0, "");
  return EXIT_SUCCESS;
}
