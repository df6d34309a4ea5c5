/// Draws random rough surfaces with a prescribed autocorrelation.
#include <utility>

#include "dataset/unread.hpp"
#include "tools/cli/progress.hpp"
#include "tools/surface/drawing.hpp"
#include "tools/surface/surface_kernel.hpp"

using namespace asperity;

namespace {

// Memory of the tables of the kernel while surfaces are drawn: once, and once more for each of several
//        datasets.
std::size_t standing(const Dataset& base, int surfaces) {
  std::size_t values = 0;
  for (const Variable& v : base.variables) values += count(v);
  return (surfaces > 1 ? 2 : 1) * values * sizeof(double);
}

void draw(cli::Tool& tool, const cli::GenerateOptions& o, cli::SurfaceKernel kernel,
          const cli::HeightDistribution& distribution) {
  const double rms = kernel.tables.rms();
  Field values = std::move(kernel.tables.kernel);
  kernel.tables = {};  // their memory is for the surface
  const Synthesis synthesis =
      o.synthesis(tool, std::move(values), distribution.heights, standing(kernel.data, o.count));
  cli::Progress progress(tool);
  for (int k = 0; k < o.count; ++k) {
    const WhiteNoise noise(tool.seed_value(), static_cast<std::uint64_t>(o.number(k)), tool.stream_value(),
                           distribution.noise);
    auto advanced = [&](double share) { progress.count(k + share, o.count, o.count > 1 ? "surfaces" : ""); };
    const cli::Drawing drawing{synthesis, noise, rms, o.exact_rq, o.adds("noise"), tool.memory(), advanced};
    const bool last = k + 1 == o.count;
    drawing.write(tool, last ? std::exchange(kernel.data, {}) : kernel.data, o.output_name(tool, k));
  }
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-generate",
                 "Draws random rough surfaces with a prescribed autocorrelation and height distribution: "
                 "white noise convolved "
                 "with the kernel that solves the autocorrelation equations.");
  cli::GenerateOptions options;
  options.declare(tool);

  return tool.run(argc, argv, [&] {
    options.check_outputs(tool);
    cli::SurfaceKernel kernel = cli::surface_kernel(tool, options);
    const cli::HeightDistribution heights = cli::height_distribution(tool, options, kernel);
    kernel.before.tell(
        tool, kernel.data, "surface",
        options.adds("noise") ? "kernel heights generate_* noise" : "kernel heights generate_*");

    const cli::Exit code = kernel.code;
    draw(tool, options, std::move(kernel), heights);
    return code;
  });
}
