/// Draws random rough surfaces with a prescribed autocorrelation.
#include <algorithm>
#include <utility>

#include "core/os.hpp"
#include "dataset/unread.hpp"
#include "tools/cli/ordered_work.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/progress.hpp"
#include "tools/measure/twin_options.hpp"
#include "tools/surface/drawing.hpp"

using namespace asperity;

namespace {

// Memory of the tables of the kernel while surfaces are drawn: once, and once more for each dataset.
std::size_t standing(const Dataset& base, int copies) {
  std::size_t values = 0;
  for (const Variable& v : base.variables) values += count(v);
  return static_cast<std::size_t>(1 + copies) * values * sizeof(double);
}

// How many surfaces are drawn at once, by the noise that each needs.
int drawn_at_once(const cli::Tool& tool, const cli::GenerateOptions& o, const cli::SurfaceKernel& kernel) {
  if (o.count == 1) return 1;
  for (int k = 0; k < o.count; ++k)
    if (!cli::replaces_file(o.output_name(tool, k))) return 1;
  const Field& values = kernel.tables.kernel;
  const Shape noise = kernel.root  ? kernel.root->torus
                      : o.periodic ? o.shape
                                   : Shape{o.shape.nx + values.rows(), o.shape.ny + values.cols()};
  return std::min(o.count, cli::datasets_at_once(tool, noise));
}

void draw(cli::Tool& tool, const cli::GenerateOptions& o, cli::SurfaceKernel kernel,
          const cli::HeightDistribution& distribution) {
  const double rms = kernel.tables.rms();
  Dataset data = std::move(kernel.data);
  const int at_once = drawn_at_once(tool, o, kernel);
  const Synthesis synthesis = o.synthesis(tool, std::move(kernel), distribution.heights,
                                          standing(data, o.count > 1 ? at_once : 0), at_once);
  cli::Progress progress(tool);
  const std::string unit = o.count > 1 ? "surfaces" : "";
  cli::OrderedWork surfaces(at_once);
  for (int k = 0; k < o.count; ++k) {
    const WhiteNoise noise(tool.seed_value(), static_cast<std::uint64_t>(o.number(k)), tool.stream_value(),
                           distribution.noise);
    surfaces.add([&, k, noise]() -> cli::Action {
      auto advanced = [&, k](double share) {
        if (at_once == 1) progress.count(k + share, o.count, unit);
      };
      const cli::Drawing drawing{synthesis,
                                 noise,
                                 rms,
                                 o.exact_rq,
                                 o.adds("noise"),
                                 k == 0,
                                 tool.memory() / static_cast<std::size_t>(at_once),
                                 std::move(advanced)};
      const bool last = at_once == 1 && k + 1 == o.count;
      drawing.write(tool, last ? std::exchange(data, {}) : data, o.output_name(tool, k));
      return [&, k] { progress.count(k + 1, o.count, unit); };
    });
  }
  surfaces.finish();
}

// Whether nobody chose the model, so that a first contact would have no slopes to resolve.
bool has_default_model(const cli::Tool& tool, const cli::GenerateOptions& options, const Attributes& kernel) {
  const bool solved = !options.target_option(tool).empty();
  const bool chosen = tool.given("--model") || tool.given("--cutoff");
  return solved && !chosen && kernel.text("kernel_target") == "exponential";
}

}  // namespace

int main(int argc, char** argv) {
  os::return_freed_memory();  // of a map and its autocorrelation, before twins are drawn
  cli::Tool tool(
      "asperity-generate",
      "Draws random rough surfaces with a prescribed autocorrelation and height distribution: those of "
      "a model, of a table, or of a measured surface (--like). White noise is convolved with the "
      "kernel that solves the autocorrelation equations.");
  cli::GenerateOptions options;
  cli::TwinOptions twins;
  options.declare(tool);
  twins.declare(tool);

  return tool.run(argc, argv, [&] {
    options.check_outputs(tool);
    cli::SurfaceKernel kernel = cli::surface_kernel(tool, options, twins.table(tool, options));
    const cli::HeightDistribution heights = cli::height_distribution(tool, options, kernel);
    kernel.before.tell(
        tool, kernel.data, "surface",
        options.adds("noise") ? "kernel heights generate_* noise" : "kernel heights generate_*");

    const cli::Exit code = kernel.code;
    const bool by_default = has_default_model(tool, options, kernel.data.attributes);
    draw(tool, options, std::move(kernel), heights);
    if (by_default)
      tool.note(
          "drew the exponential --model, the default, whose slopes grow with every finer grid; for a "
          "contact choose gaussian, matern with --smoothness 2, or --periodic with a --cutoff");
    return code;
  });
}
