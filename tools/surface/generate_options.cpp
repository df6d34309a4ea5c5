#include "tools/surface/generate_options.hpp"

#include "tools/cli/stream.hpp"

namespace asperity::cli {

void GenerateOptions::declare(Tool& tool) {
  const std::string surface = "Surface";
  tool.counts("--shape", shape, 1, "Samples in x and y", surface);
  tool.quantities("--size", size, "m",
                  "Side lengths in x and y. Default: --shape times the spacing of --kernel or --acf",
                  surface);
  tool.quantity(
      "--rq", acf.rms, "m",
      "Rms height of the ensemble; one surface differs from it by sampling error (see asperity-stats)",
      surface);
  tool.flag(
      "--exact-rq", exact_rq,
      "Give each surface exactly zero mean and --rq. Its heights are then no longer independent draws of the "
      "target, and standard errors do not hold",
      surface);
  tool.flag(
      "--periodic", periodic,
      "Draw a surface that continues at its opposite edge. If the correlation is longer than half the "
      "period, the "
      "surface has the sum over the periods at the same rms height, and a note says so; --acf with all lags "
      "of a periodic surface of this shape is met exactly",
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
      "and "
      "written in strips; into a pipe, or with --exact-rq, it is then drawn twice, because its range "
      "precedes it. "
      "The limit does not change the surface, to the last bit");
  tool.essential({"--shape", "--size", "--rq", "--length", "--model", "--acf", "--periodic", "--cutoff",
                  "--skewness", "--kurtosis", "--count", "--seed", "--output"});
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

Synthesis GenerateOptions::synthesis(const Tool& tool, Field kernel_values, Pointwise translation,
                                     std::size_t beside, int at_once) const {
  const auto share = static_cast<std::size_t>(at_once);
  return {std::move(kernel_values),
          shape,
          {periodic, Summation::cheapest, at_once > 1 ? 1 : tool.thread_count(), tool.memory() / share,
           std::move(translation), beside / share}};
}

}  // namespace asperity::cli
