/// Draws random rough surfaces with a prescribed autocorrelation.
#include <algorithm>
#include <optional>
#include <utility>

#include "acf/kernel_cost.hpp"
#include "acf/table.hpp"
#include "dataset/netcdf.hpp"
#include "marginal/prescribed.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/stream.hpp"
#include "tools/surface/drawing.hpp"
#include "tools/surface/kernel_period.hpp"
#include "tools/surface/kernel_prospect.hpp"

using namespace asperity;

namespace {

struct Options {
  cli::KernelOptions acf;
  cli::HeightsWithAcf measured;  ///< that came with a table of the autocorrelation
  std::string kernel;
  Shape shape;
  std::array<double, 2> size{NAN, NAN};
  bool periodic = false, exact_rq = false, noise = false;
  int count = 1, first = 0;
};

void declare(cli::Tool& tool, Options& o) {
  const std::string surface = "Surface", ensemble = "Ensemble";
  tool.counts("--shape", o.shape, 1, "Points in x and y", surface);
  tool.quantities("--size", o.size, "m",
                  "Size in x and y; absent: --shape times the spacing of --kernel or --acf", surface);
  tool.quantity("--rq", o.acf.rms, "m",
                "Rms height of the ensemble; a single surface differs from it by chance (see asperity-stats)",
                surface);
  tool.flag("--exact-rq", o.exact_rq,
            "Subtract each surface's mean and scale it to --rq. Its heights are then no longer Gaussian "
            "draws of the "
            "target, and standard errors do not hold",
            surface);
  tool.flag(
      "--periodic", o.periodic,
      "A surface that continues itself at its edges. Where the correlation reaches around it, it has the "
      "target's sum over the periods, of the same rms height, which is said; of --acf with all lags of a "
      "periodic surface of this shape, exactly these",
      surface);
  tool.flag("--noise", o.noise, "Add noise(x,y): the white noise below the middle of the kernel", surface);
  o.acf.declare(tool, true);
  tool.text(
      "--kernel", o.kernel, "FILE",
      "A kernel from asperity-kernel in place of these; - is standard input, which is read when no option "
      "names a target. --shape and --size come from its grid or that of --acf, where there is one",
      "Autocorrelation");
  tool.integer("--count", o.count, {1, 1'000'000, "a file each: go on with --first"},
               "Surfaces to draw from one kernel; --output is then a pattern, s_%04d.nc", ensemble);
  tool.integer("--first", o.first, 0,
               "Number of the first: --first 17 draws the surface 17 of --seed and --stream", ensemble);
  tool.output();
  tool.report();
  tool.seed();
  tool.threads();
  tool.memory(
      "Largest memory of the drawing, and of the solution of its kernel before, beside the program's own 20 "
      "MB. A surface that does not fit is drawn in strips, each written as it is made; into a pipe or with "
      "--exact-rq it is then drawn twice, for its range stands in front of it. The surface does not depend "
      "on "
      "it, to the last bit");
  tool.example(
      "asperity-generate --shape 512x512 --size 3mm --rq 0.4um --length 17px,4px --seed 7 | asperity-stats");
  tool.accuracy(
      "The ensemble has the autocorrelation acf_achieved of the dataset, to round-off; kernel_error is its "
      "distance\n"
      "  from the target. Estimates from one surface scatter by its sampling error: see asperity-stats and "
      "asperity-acf.");
}

// The first option given of those that say which kernel to solve for, or nothing.
std::string target_option(const cli::Tool& tool, bool filters) {
  for (const cli::Option& option : tool.options())
    if ((option.group() == "Autocorrelation" || option.group() == "Solution") && option.given() &&
        option.key() != "kernel" && !(filters && option.key() == "method"))
      return option.key();
  return {};
}

// Shape and size of the surface that the kernel's dataset has or had, where they are not given.
void adopt_grid(const cli::Tool& tool, Options& o, const Dataset& data) {
  if (tool.given("--shape")) return;
  if (!data.has("x") || !data.has("y"))
    throw cli::UsageError("shape", "is required: the autocorrelation comes without a grid");
  const Grid grid = grid_of(data);
  o.shape = grid.shape;
  if (!tool.given("--size")) o.size = {grid.size_x(), grid.size_y()};
}

Synthesis synthesis_of(const cli::Tool& tool, const Options& o, Field kernel, Pointwise translation = {},
                       std::size_t beside = 0) {
  return {
      std::move(kernel),
      o.shape,
      {o.periodic, Summation::cheapest, tool.thread_count(), tool.memory(), std::move(translation), beside}};
}

// What the tables of the kernel take while surfaces are drawn, once and once more for each of several datasets.
std::size_t standing(const Options& o, const Dataset& base) {
  std::size_t values = 0;
  for (const Variable& v : base.variables) values += count(v.values);
  return (o.count > 1 ? 2 : 1) * values * sizeof(double);
}

// Throws ParameterError("memory") where a kernel of these lags leaves none for a strip of the surface.
void refuse_drawing(const cli::Tool& tool, const Options& o, Shape lags) {
  auto side = [&](Index n, Index period) { return o.periodic ? std::min(2 * n - 1, period) : 2 * n - 1; };
  synthesis_of(tool, o, Field::Zero(side(lags.nx, o.shape.nx), side(lags.ny, o.shape.ny)));
}

Dataset solved(cli::Tool& tool, Options& o, cli::Exit& code, cli::Inventory& before) {
  const bool model = !tool.given("--acf");
  if (model && !tool.given("--shape")) throw cli::UsageError("shape", "is required");
  if (model && !tool.given("--length")) throw cli::UsageError("length", "is required, or --acf or --kernel");
  if (model && !tool.given("--size")) throw cli::UsageError("size", "is required");
  const bool sized = tool.given("--shape") && tool.given("--size");
  cli::Wanted wanted =
      cli::wanted_kernel(tool, o.acf, sized ? cli::spacing_of(o.shape, o.size) : std::nullopt);
  if (!wanted.has_height) throw cli::UsageError("rq", "is required: the rms height of the surface");
  adopt_grid(tool, o, wanted.data);
  if (!o.periodic || wanted.period != o.shape) wanted.period.reset();
  cli::foresee(tool, wanted, o.shape);
  if (!wanted.request.target.known) refuse_drawing(tool, o, first_lags(wanted.request));
  o.measured = wanted.measured;
  cli::Solved kernel = cli::solve(tool, std::move(wanted));
  code = cli::tell(tool, kernel, true);
  before = std::move(kernel.before);
  return std::move(kernel.data);
}

Dataset read_kernel(cli::Tool& tool, Options& o, cli::Inventory& before) {
  if (!tool.given("--kernel") && cli::stdin_is_device())
    throw cli::UsageError("length", "is required, or --kernel, or a kernel on standard input");
  const std::string name = tool.given("--kernel") ? o.kernel : "-";
  tool.reads(name, true);
  const cli::Bytes bytes = cli::read_all(name, tool.memory_bound());
  const std::string heights = cli::MarginalOptions::given(tool);
  if (!heights.empty() && !o.acf.filters())
    throw cli::UsageError(heights,
                          "is for the solution of the kernel, by asperity-kernel, or for --method filter");
  Dataset data = decode_netcdf(bytes, tool.memory_bound(bytes.size()));
  tool.settle(data);
  adopt_grid(tool, o, data);
  before = cli::Inventory(data);
  cli::drop_surface(data);
  cli::foresee_extent(tool, target_of_table(known_lags(cli::kernel_of(data).acf_target)), o.shape, "shape");
  cli::tell_read(tool, data);
  return data;
}

// The kernel of the options or of the file, the exit code that follows from how it was solved, and what came with it.
Dataset kernel_dataset(cli::Tool& tool, Options& o, cli::Exit& code, cli::Inventory& before) {
  const std::string target = target_option(tool, o.acf.filters());
  if (!tool.given("--kernel") && (!target.empty() || cli::stdin_is_terminal()))
    return solved(tool, o, code, before);
  if (!target.empty()) throw cli::UsageError(target, "does not go together with --kernel");
  return read_kernel(tool, o, before);
}

// The kernel's tables with the height and the spacing of this surface.
cli::KernelTables tables_for(cli::Tool& tool, const Options& o, const Dataset& data) {
  cli::KernelTables tables = cli::kernel_of(data);
  if (tool.given("--rq")) {
    check_rms(o.acf.rms);
    tables.scale(o.acf.rms / tables.rms());
    tables.has_height = true;
  }
  if (!tables.has_height)
    throw cli::UsageError("rq", "the kernel has unit variance: an rms height is required");
  if (std::isnan(o.size[0])) {
    if (!tables.spacing) throw cli::UsageError("size", "is required: the kernel counts its lags in samples");
    return tables;
  }
  const cli::Spacing spacing = cli::spacing_of(o.shape, o.size);
  for (std::size_t axis : {0u, 1u})
    if (tables.spacing && std::abs((*spacing)[axis] / (*tables.spacing)[axis] - 1) > 1e-9)
      throw cli::UsageError("size", "gives a spacing of " + cli::format_quantity((*spacing)[axis], "m") +
                                        ", the kernel has " +
                                        cli::format_quantity((*tables.spacing)[axis], "m"));
  tables.spacing = spacing;
  return tables;
}

// What a surface is drawn from beside its kernel: the noise's distribution and what becomes of the average.
struct Distribution {
  Pointwise noise, heights;
};

void expect(Dataset& data, const char* way, const HeightMoments& moments) {
  Attributes& a = data.attributes;
  a.set("generate_heights", way);
  a.set("generate_skewness_expected", moments.skewness);
  a.set("generate_kurtosis_expected", moments.kurtosis);
  a.set("generate_acf_error_expected", a.number("kernel_error", NAN) + a.number("kernel_hermite_tail", 0));
}

Distribution translated(Dataset& data, const cli::Marginal& marginal, double rms) {
  expect(data, "translation", {0, 1, marginal.skewness, marginal.kurtosis});
  return {{}, [apply = marginal.translation.apply, rms](std::span<double> values) {
            apply(values);
            for (double& z : values) z *= rms;
          }};
}

Distribution filtered(const cli::Tool& tool, const Options& o, Dataset& data, const Field& kernel) {
  const auto prescribed = o.acf.heights.moments(tool, o.measured, infeasible_named(o.acf.infeasible));
  if (!prescribed) throw cli::UsageError("method", "filter: takes --skewness and --kurtosis");
  const Translation noise = prescribed->noise(kernel);
  const HeightMoments moments = KernelCumulants::of(kernel).heights(height_moments(noise));
  cli::tell_kurtosis(tool, *prescribed, moments.kurtosis);
  expect(data, "filter", moments);
  return {noise.family == "normal" ? Pointwise{} : noise.apply, {}};
}

Distribution distribution_of(const cli::Tool& tool, const Options& o, Dataset& data,
                             const cli::KernelTables& tables) {
  const std::optional<cli::Marginal> marginal = cli::marginal_of(data);
  if (marginal && o.acf.filters())
    throw cli::UsageError("method", "filter: the kernel is of a Gaussian field below heights that are " +
                                        marginal->translation.family + ", not of the heights");
  if (marginal) return translated(data, *marginal, tables.rms());
  return o.acf.filters() ? filtered(tool, o, data, tables.kernel) : Distribution{};
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-generate", "Random rough surfaces with a prescribed autocorrelation");
  Options options;
  declare(tool, options);

  return tool.run(argc, argv, [&] {
    for (int k = 0; options.count > 1 && k < options.count; ++k)
      tool.writes("count", cli::numbered("output", tool.output_name(), std::int64_t{options.first} + k));
    if (options.count > 1 && tool.given("--report"))
      throw cli::UsageError("report", "is of one surface; each dataset of an ensemble carries its own");
    cli::Exit code = cli::done;
    cli::Inventory before;
    Dataset base = kernel_dataset(tool, options, code, before);
    cli::KernelTables tables = tables_for(tool, options, base);
    cli::check_period(tables, options.shape, options.periodic);
    if (options.periodic)
      code = std::max(
          code, cli::wrap_kernel(tool, base, tables, options.shape, static_cast<double>(tool.memory())));
    set_kernel(base, tables);
    set_grid(base, {options.shape, (*tables.spacing)[0], (*tables.spacing)[1], options.periodic});

    const Distribution distribution = distribution_of(tool, options, base, tables);
    before.tell(tool, base, "surface", options.noise ? "heights generate_* noise" : "heights generate_*");
    const double rms = tables.rms();
    Field kernel = std::move(tables.kernel);
    tables = {};  // their memory is for the surface
    const Synthesis synthesis =
        synthesis_of(tool, options, std::move(kernel), distribution.heights, standing(options, base));
    cli::Progress progress(tool);
    for (int k = 0; k < options.count; ++k) {
      const std::int64_t number = std::int64_t{options.first} + k;
      const WhiteNoise noise(tool.seed_value(), static_cast<std::uint64_t>(number), tool.stream_value(),
                             distribution.noise);
      auto advanced = [&](double share) {
        progress.count(k + share, options.count, options.count > 1 ? "surfaces" : "");
      };
      const cli::Drawing drawing{synthesis,     noise,         rms,     options.exact_rq,
                                 options.noise, tool.memory(), advanced};
      const bool last = k + 1 == options.count;
      drawing.write(
          tool, last ? std::exchange(base, {}) : base,
          options.count > 1 ? cli::numbered("output", tool.output_name(), number) : tool.output_name());
    }
    return code;
  });
}
