/// Solves the autocorrelation equations for the moving-average kernel of a random surface.
#include "kernel_dataset.hpp"

using namespace asperity;

int main(int argc, char** argv) {
  cli::Tool tool("asperity-kernel",
                 "The moving-average kernel of a random surface with an exponential autocorrelation");
  cli::KernelOptions options;
  Shape shape;
  std::array<double, 2> size{NAN, NAN}, spacing{NAN, NAN};
  options.declare(tool);
  tool.quantity("--rq", options.rms, "m", "Rms height; absent: a kernel of unit variance", "Autocorrelation");
  const std::string sampling = "Sampling";
  tool.quantities("--spacing", spacing, "m", "Between samples in x and y; or --shape and --size", sampling);
  tool.counts("--shape", shape, 1, "Samples in x and y on --size", sampling);
  tool.quantities("--size", size, "m", "Size of the surface in x and y", sampling);
  tool.output();
  tool.report();
  tool.example("asperity-kernel --length 17px,4px --report kernel.json -o kernel.nc");
  tool.accuracy(
      "Residual at the prescribed lags below --tolerance. Over all lags the error is at most 1e-3 of the "
      "variance\n"
      "  with six 1/e lengths of lags each way (the default) and 1e-6 with 11.5: see kernel_error. Patir's "
      "formulation\n"
      "  is wrong by about 0.1 at the mirrored lags (p,-q): see kernel_mirrored_error.");

  return tool.run(argc, argv, [&] {
    if (!tool.given("--length")) throw cli::UsageError("length", "is required");
    cli::Spacing known;
    if (tool.given("--spacing")) {
      known = cli::spacing_of({1, 1}, spacing);
    } else if (tool.given("--shape") && tool.given("--size")) {
      known = cli::spacing_of(shape, size);
    }
    Dataset data = cli::solved_kernel(options, known);

    const cli::Exit code = cli::tell(tool, data);
    tool.write(data);
    return code;
  });
}
