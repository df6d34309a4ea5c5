#include "tools/surface/generate_options.hpp"

#include <algorithm>

#include "acf/kernel.hpp"
#include "acf/table.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "marginal/prescribed.hpp"
#include "stats/measure/surface.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/stream.hpp"
#include "tools/surface/kernel_solution.hpp"
#include "tools/surface/periodic_kernel.hpp"

namespace asperity::cli {

void GenerateOptions::declare(Tool& tool) {
  const std::string surface = "Surface";
  tool.counts("--shape", shape, 1, "Samples in x and y", surface);
  tool.quantities("--size", size, "m",
                  "Side lengths in x and y. Default: --shape times the spacing of --like, --kernel or --acf",
                  surface);
  acf.height.declare(
      tool, "Rms height of the ensemble; one surface differs from it by sampling error (see asperity-stats)",
      surface);
  tool.flag("--exact-rq", exact_rq,
            "Give each surface exactly zero mean and --rq, or the height of --rms-slope. Its heights are "
            "then no longer independent draws of the "
            "target, and standard errors do not hold",
            surface);
  tool.flag(
      "--periodic", periodic,
      "Draw a surface that continues at its opposite edge. If the correlation is longer than half the "
      "period, the surface has the sum over the periods at the same rms height, and a note says so; --acf "
      "with all lags of a periodic surface of this shape is met exactly",
      surface);
  tool.words("--add", add, {"noise", "kernel"},
             "Further variables to write; noise: the white noise under the centre of the kernel; kernel: the "
             "kernel and all lags of its autocorrelation, from which the dataset can be drawn again",
             surface);
  declare_drawing(tool);
}

void GenerateOptions::declare_drawing(Tool& tool) {
  const std::string ensemble = "Ensemble";
  acf.declare(tool, true);
  tool.text(
      "--kernel", kernel, "FILE",
      "Kernel from asperity-kernel in place of a target; - is standard input, which is read when no option "
      "names a target. Its grid, or that of --acf, gives --shape and --size",
      "Autocorrelation");
  tool.integer("--count", count, {1, 1'000'000, "one file each; continue with --first"},
               "Number of surfaces; --output is then a pattern, s_%04d.nc", ensemble);
  tool.integer("--first", first, 0,
               "Number of the first surface; --first 17 draws surface 17 of --seed and --stream", ensemble);
  tool.output();
  tool.report();
  tool.seed();
  tool.threads();
  tool.memory(
      "Memory limit for the kernel and the drawing, besides 20 MB of the program. A larger surface is drawn "
      "and written in strips; into a pipe, or with --exact-rq, it is then drawn twice, because its range "
      "precedes it. The limit does not change the surface, to the last bit");
  tool.essential({"--shape", "--size", "--rq", "--length", "--model", "--like", "--acf", "--periodic",
                  "--cutoff", "--skewness", "--kurtosis", "--count", "--seed", "--output"});
  tool.example(
      "asperity-generate --shape 512x512 --size 3mm --rq 0.4um --length 17px,4px --seed 7 | asperity-stats");
}

void GenerateOptions::check_outputs(Tool& tool) const {
  if (count == 1) return;
  for (int k = 0; k < count; ++k) tool.writes("count", output_name(tool, k));
  if (tool.given("--report"))
    throw UsageError("report", "belongs to one surface; each dataset of an ensemble has its own attributes");
}

std::string GenerateOptions::target_option(const Tool& tool) const {
  for (const std::string& key : tool.given_under({"Autocorrelation", "Solution"}))
    if (key != "kernel" && !(acf.filters() && key == "method")) return key;
  return {};
}

std::string GenerateOptions::output_name(const Tool& tool, int k) const {
  const std::string name = tool.output_name();
  return count > 1 || has_place_for_number(name) ? numbered("output", name, number(k)) : name;
}

Synthesis GenerateOptions::synthesis(const Tool& tool, SurfaceKernel source, Pointwise translation,
                                     std::size_t held, int at_once) const {
  const auto share = static_cast<std::size_t>(at_once);
  Synthesis::Options options{periodic,
                             Summation::cheapest,
                             at_once > 1 ? 1 : tool.thread_count(),
                             tool.memory() / share,
                             std::move(translation),
                             held / share};
  if (source.root) {
    const double rms = source.tables.translated ? 1 : source.tables.rms();
    return {std::move(*source.root), rms, shape, std::move(options)};
  }
  return {std::move(source.tables.kernel), shape, std::move(options)};
}

namespace {

// Shape and size of the surface that the kernel's dataset has or had, or its period, unless given.
void adopt_grid(const Tool& tool, GenerateOptions& o, const Dataset& data) {
  if (tool.given("--shape")) return;
  if (!data.has("x") || !data.has("y")) {
    const std::optional<Shape> period = kernel_period(data);
    if (!period) throw UsageError("shape", "is required: the autocorrelation has no grid");
    o.shape = *period;
    return;
  }
  const Grid grid = grid_of(data);
  o.shape = grid.shape;
  if (!tool.given("--size")) o.size = {grid.size_x(), grid.size_y()};
}

// Throws ParameterError("memory") where a kernel of these lags leaves none for a strip of the surface.
void refuse_drawing(const Tool& tool, const GenerateOptions& o, Shape lags) {
  auto side = [&](Index n, Index period) { return o.periodic ? std::min(2 * n - 1, period) : 2 * n - 1; };
  SurfaceKernel kernel;
  kernel.tables.kernel = Field::Zero(side(lags.nx, o.shape.nx), side(lags.ny, o.shape.ny));
  o.synthesis(tool, std::move(kernel), {}, 0, 1);
}

void require_model(const Tool& tool) {
  if (!tool.given("--shape")) throw UsageError("shape", "is required");
  if (!tool.given("--length") && !tool.given("--rolloff") && !tool.given("--psd"))
    throw UsageError("length", "is required, or --acf, --psd or --kernel");
  if (!tool.given("--size")) throw UsageError("size", "is required");
}

SurfaceKernel solved(const Tool& tool, GenerateOptions& o, std::optional<AcfTable> table) {
  if (!table && !tool.given("--acf")) require_model(tool);
  const bool sized = tool.given("--shape") && tool.given("--size");
  const Spacing spacing = sized ? spacing_of(o.shape, o.size) : std::nullopt;
  if (!table) table = wanted_table(tool, o.acf, spacing, o.shape, o.periodic);
  KernelProblem problem =
      kernel_problem(tool, o.acf, std::move(table), spacing, o.periodic ? o.shape : Shape{});
  if (!problem.has_height && !o.acf.height.has_slope())
    throw UsageError("rq", "is required: the rms height of the surface; or --rms-slope");
  adopt_grid(tool, o, problem.data);
  if (!o.periodic && !problem.corner) problem.period.reset();
  problem.keeps_kernel = o.adds("kernel") || o.acf.filters();
  problem.lay_out(tool, o.shape, o.periodic);
  foresee(tool, problem, o.shape, o.adds("kernel"));
  if (!problem.torus && !problem.request.target.known) refuse_drawing(tool, o, first_lags(problem.request));
  if (o.periodic) problem.wrap(tool, o.shape);
  HeightsWithAcf measured = problem.measured;
  SolvedKernel kernel = solve(tool, problem, true);
  return {record(tool, std::move(problem), std::move(kernel), true), {}, std::move(measured)};
}

// A surface that was drawn without --add kernel.
void refuse_surface(const Dataset& data) {
  if (!data.has("kernel") && data.attributes.find("generate_seed"))
    throw DataError("kernel",
                    "it was not kept with this surface: name the file of asperity-kernel, draw from its "
                    "autocorrelation by --acf, or draw the surface with --add kernel");
}

SurfaceKernel read(const Tool& tool, GenerateOptions& o) {
  if (!tool.given("--kernel") && stdin_is_device())
    throw UsageError("length", "is required, or --kernel, or a kernel on standard input");
  const std::string name = tool.given("--kernel") ? o.kernel : "-";
  tool.reads(name, true);
  const Bytes bytes = read_all(name, tool.memory_bound());
  const std::string heights = MarginalOptions::given(tool);
  if (!heights.empty() && !o.acf.filters())
    throw UsageError(heights, "applies when the kernel is solved (asperity-kernel), or with --method filter");
  SurfaceKernel out;
  out.data = decode_netcdf(bytes, tool.memory_bound(bytes.size()));
  refuse_surface(out.data);
  out.data.at("kernel");
  tool.settle(out.data);
  adopt_grid(tool, o, out.data);
  out.before = Inventory(out.data);
  drop_surface(out.data);
  foresee_extent(tool, target_of_table(known_lags(kernel_of(out.data).acf_target)), o.shape,
                 tool.given("--shape") ? "shape" : "kernel");
  report_read(tool, out.data);
  return out;
}

SurfaceKernel solved_or_read(const Tool& tool, GenerateOptions& o, std::optional<AcfTable> table) {
  const std::string target = o.target_option(tool);
  if (!tool.given("--kernel") && (!target.empty() || stdin_is_terminal()))
    return solved(tool, o, std::move(table));
  if (!target.empty()) throw UsageError(target, "cannot be combined with --kernel");
  return read(tool, o);
}

// The kernel's tables with the height and the spacing of this surface.
KernelTables tables_for(const Tool& tool, const GenerateOptions& o, const Dataset& data) {
  KernelTables tables = kernel_of(data);
  if (tool.given("--rq")) {
    check_rms(o.acf.height.rms);
    tables.scale(o.acf.height.rms / tables.rms());
    tables.has_height = true;
  }
  if (!tables.has_height && !o.acf.height.has_slope())
    throw UsageError("rq", "is required, or --rms-slope: the kernel has unit variance");
  if (std::isnan(o.size[0])) {
    if (!tables.spacing) throw UsageError("size", "is required: the kernel counts its lags in samples");
    return tables;
  }
  const Spacing spacing = spacing_of(o.shape, o.size);
  if (tables.spacing && tables.acf_target.rows() == 1) (*tables.spacing)[0] = (*spacing)[0];  // a single lag
  if (tables.spacing && tables.acf_target.cols() == 1) (*tables.spacing)[1] = (*spacing)[1];
  require_spacing("size", "gives a spacing", spacing, "the kernel has", tables.spacing, 1e-9);
  tables.spacing = spacing;
  return tables;
}

// What errors of the surface ask for of the autocorrelation, in place of the kernel. A corner's has as many
// lags as the surface has points, and is not carried: cut off, it would be that of another surface.
void carry_correlation(Dataset& data, const KernelTables& tables, const Grid& grid) {
  if (tables.corner) {
    for (const char* table : {"kernel", "acf_target", "acf_achieved"}) drop_variable(data, table);
    return;
  }
  const Shape lags = lags_of_errors(grid);
  auto asked = [lags](const Field& table) -> Field {
    const Index rows = std::min(table.rows(), lags.nx + 1), columns = std::min(table.cols(), 2 * lags.ny + 1);
    return table.block(0, (table.cols() - columns) / 2, rows, columns);
  };
  drop_variable(data, "kernel");
  set_correlation(data, {.kernel = {},
                         .acf_target = asked(tables.acf_target),
                         .acf_achieved = asked(tables.acf_achieved),
                         .has_height = tables.has_height,
                         .spacing = tables.spacing,
                         .period = tables.period,
                         .corner = tables.corner});
}

// ---- the heights ----

void expect(Attributes& a, const char* way, double skewness, double kurtosis) {
  a.set("generate_heights", way);
  a.set("generate_skewness_expected", skewness);
  a.set("generate_kurtosis_expected", kurtosis);
  a.set("generate_acf_error_expected", a.number("kernel_error", NAN) + a.number("kernel_hermite_tail", 0));
}

Pointwise translated(const Translation& translation, double rms) {
  return [apply = translation.apply, rms](std::span<double> values) {
    apply(values);
    for (double& z : values) z *= rms;
  };
}

Pointwise filtered(const Tool& tool, const GenerateOptions& o, SurfaceKernel& kernel) {
  const auto prescribed = o.acf.heights.moments(tool, kernel.measured,
                                                enum_named<InfeasiblePolicy>(o.acf.infeasible, "infeasible"));
  if (!prescribed) throw UsageError("method", "filter: needs --skewness and --kurtosis");
  const Translation noise = prescribed->noise(kernel.tables.kernel);
  const HeightMoments moments = KernelCumulants::of(kernel.tables.kernel).heights(height_moments(noise));
  warn_of_kurtosis(tool, *prescribed, moments.kurtosis);
  expect(kernel.data.attributes, "filter", moments.skewness, moments.kurtosis);
  return noise.family == "normal" ? Pointwise{} : noise.apply;
}

}  // namespace

SurfaceKernel surface_kernel(const Tool& tool, GenerateOptions& options, std::optional<AcfTable> table) {
  options.acf.height.check(tool);
  SurfaceKernel out = solved_or_read(tool, options, std::move(table));
  const Shape shape = options.shape;
  out.tables = tables_for(tool, options, out.data);
  check_period(out.tables, shape, options.periodic);
  if (options.periodic) wrap_kernel(tool, out, out.tables, shape);
  // That of the kernel itself where there is one: the surface is then drawn again from its dataset.
  if (out.tables.period == shape_of(out.tables.kernel)) out.root = root_of_kernel(out.tables.kernel);
  if (!out.change.empty()) tool.warn(out.change);
  tool.record_warnings(out.data.attributes, "kernel_");
  options.acf.height.apply(tool, out.tables, shape, out.data.attributes);
  const auto [dx, dy] = *out.tables.spacing;
  const Grid grid{shape, dx, dy, options.periodic};
  if (options.adds("kernel"))
    set_kernel(out.data, out.tables);
  else
    carry_correlation(out.data, out.tables, grid);
  set_grid(out.data, grid);
  return out;
}

HeightDistribution height_distribution(const Tool& tool, const GenerateOptions& o, SurfaceKernel& kernel) {
  const std::optional<Marginal> marginal = marginal_of(kernel.data);
  if (!marginal) return {o.acf.filters() ? filtered(tool, o, kernel) : Pointwise{}, {}};
  if (o.acf.filters())
    throw UsageError("method", "filter: this kernel was solved for a Gaussian field that is translated to " +
                                   marginal->translation.family + " heights, not for the heights themselves");
  expect(kernel.data.attributes, "translation", marginal->skewness, marginal->kurtosis);
  return {{}, translated(marginal->translation, kernel.tables.rms())};
}

}  // namespace asperity::cli
