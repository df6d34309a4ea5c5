/// Solves the autocorrelation equations for the moving-average kernel of a random surface.
#include "tools/cli/stream.hpp"
#include "tools/surface/prospect.hpp"

using namespace asperity;

int main(int argc, char** argv) {
  cli::Tool tool("asperity-kernel",
                 "The moving-average kernel of a random surface with the autocorrelation asked for: that of "
                 "a model, or a table, such as the one that asperity-acf measures");
  cli::KernelOptions options;
  Shape shape;
  std::array<double, 2> size{NAN, NAN}, spacing{NAN, NAN};
  options.declare(tool);
  tool.quantity("--rq", options.rms, "m",
                "Rms height; absent: that of the table of --acf, else a kernel of unit variance",
                "Autocorrelation");
  tool.quantities("--spacing", spacing, "m", "Between samples in x and y; or --shape and --size", "Sampling");
  tool.counts("--shape", shape, 1, "Samples in x and y on --size", "Sampling");
  tool.quantities("--size", size, "m", "Size of the surface in x and y", "Sampling");
  tool.memory(
      "Largest memory of the solution, beside the program's own 20 MB; what may take more is refused");
  tool.output();
  tool.report();
  tool.example("asperity-kernel --length 17px,4px --report kernel.json -o kernel.nc");
  tool.accuracy(
      "Residual at the prescribed lags below --tolerance; over all lags of the plane below --acf-tolerance, "
      "where --lags is absent and no table ends: see kernel_error. Patir's formulation is wrong by about 0.1 "
      "at the mirrored lags (p,-q): see kernel_mirrored_error. A change made to a target that has no kernel "
      "is kernel_change, with a warning.");

  return tool.run(argc, argv, [&] {
    const bool sized = tool.given("--shape") && tool.given("--size");
    const cli::Spacing known = tool.given("--spacing") ? cli::spacing_of({1, 1}, spacing)
                               : sized                 ? cli::spacing_of(shape, size)
                                                       : std::nullopt;
    if (options.acf == "-" && cli::stdin_is_terminal())
      throw cli::UsageError("acf", "no input: pipe a table in or name a file");
    cli::KernelProblem problem = cli::kernel_problem(tool, options, known);
    cli::foresee(tool, problem, sized ? shape : Shape{});
    cli::KernelSolution solution = cli::solve(tool, std::move(problem));
    solution.before.tell(tool, solution.data, "kernel");
    tool.write(solution.data);
    return solution.code;
  });
}
