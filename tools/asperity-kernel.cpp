/// Solves the autocorrelation equations for the moving-average kernel of a random surface.
#include "dataset/layout.hpp"
#include "tools/cli/stream.hpp"
#include "tools/surface/kernel_solution.hpp"
#include "tools/surface/periodic_kernel.hpp"

using namespace asperity;

namespace {

struct Options {
  cli::KernelOptions kernel;
  Shape shape;
  std::array<double, 2> size{NAN, NAN}, spacing{NAN, NAN};
  bool periodic = false;
};

void declare(cli::Tool& tool, Options& o) {
  o.kernel.declare(tool);
  o.kernel.height.declare(tool, "Rms height. Default: that of --acf or --psd, else 1", "Autocorrelation");
  tool.quantities("--spacing", o.spacing, "m", "Sample spacing in x and y; or give --shape and --size",
                  "Sampling");
  tool.counts("--shape", o.shape, 1, "Samples in x and y", "Sampling");
  tool.quantities("--size", o.size, "m", "Side lengths in x and y", "Sampling");
  tool.flag("--periodic", o.periodic,
            "Solve for surfaces that continue at their opposite edge, of --shape points (asperity-generate "
            "--periodic). If the correlation is longer than half the period, it is the sum over the periods",
            "Sampling");
  tool.memory(
      "Memory limit for the solution, besides 20 MB of the program. A problem that may need more is refused");
  tool.output();
  tool.report();
  tool.essential({"--length", "--model", "--length-level", "--angle", "--acf", "--rq", "--spacing", "--lags",
                  "--acf-tolerance", "--method", "--report", "--output"});
  tool.example("asperity-kernel --length 17px,4px --report kernel.json -o kernel.nc");
}

// Without --shape that of the table's own period; a table of another is one as of any surface.
void adopt_period(Options& o, cli::KernelProblem& problem) {
  if (o.shape == Shape{} && !problem.period)
    throw cli::UsageError("shape", "is required by --periodic: the table does not tell a whole period");
  if (o.shape == Shape{}) o.shape = *problem.period;
}

// Of a table that needs no equations: that of the table, unless given.
Shape surface_of(const Options& o, const cli::KernelProblem& problem) {
  if (o.periodic || o.shape != Shape{}) return o.shape;
  const Dataset& data = problem.data;
  return data.has("x") && data.has("y") ? grid_of(data).shape : Shape{};
}

void wrap(const cli::Tool& tool, cli::KernelSolution& solution, Shape period) {
  cli::KernelTables tables = cli::kernel_of(solution.data);
  cli::wrap_kernel(tool, solution, tables, period);
  if (std::min(period.nx, period.ny) == 1) tables.period = period;  // it has no correlation across
  cli::set_kernel(solution.data, tables);
}

void slope(const cli::Tool& tool, const Options& o, Dataset& data) {
  cli::KernelTables tables = cli::kernel_of(data);
  o.kernel.height.apply(tool, tables, o.shape, data.attributes);
  cli::set_kernel(data, tables);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-kernel",
      "Solves the autocorrelation equations: the moving-average kernel that gives random surfaces the "
      "autocorrelation of a model, or of a table such as that of asperity-acf. asperity-generate "
      "--kernel draws from it.");
  Options o;
  declare(tool, o);

  return tool.run(argc, argv, [&] {
    const bool sized = tool.given("--shape") && tool.given("--size");
    const cli::Spacing known = tool.given("--spacing") ? cli::spacing_of({1, 1}, o.spacing)
                               : sized                 ? cli::spacing_of(o.shape, o.size)
                                                       : std::nullopt;
    if (o.kernel.acf == "-" && cli::stdin_is_terminal())
      throw cli::UsageError("acf", "no input: pipe a table in or name a file");
    if (o.periodic && !tool.given("--shape") && !tool.given("--acf"))
      throw cli::UsageError("shape", "is required by --periodic");
    cli::KernelProblem problem =
        cli::kernel_problem(tool, o.kernel, cli::wanted_table(tool, o.kernel, known, o.shape, o.periodic),
                            known, o.periodic ? o.shape : Shape{});
    if (o.periodic) adopt_period(o, problem);
    problem.lay_out(tool, problem.positive_definite || o.periodic ? surface_of(o, problem) : Shape{},
                    o.periodic);
    cli::foresee(tool, problem, sized || o.periodic ? o.shape : Shape{}, true);
    if (o.periodic) problem.wrap(tool, o.shape);
    const cli::SolvedKernel kernel = cli::solve(tool, problem);
    cli::KernelSolution solution = cli::record(tool, std::move(problem), kernel);
    if (o.periodic) wrap(tool, solution, o.shape);
    if (o.kernel.height.has_slope()) slope(tool, o, solution.data);
    if (!solution.change.empty()) tool.warn(solution.change);
    solution.before.tell(tool, solution.data, "kernel");
    tool.write(solution.data);
    return solution.code;
  });
}
