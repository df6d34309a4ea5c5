#include "tools/surface/generate_options.hpp"

#include "tools/cli/stream.hpp"

namespace asperity::cli {

void GenerateOptions::declare(Tool& tool) {
  const std::string surface = "Surface";
  tool.counts("--shape", shape, 1, "Points in x and y", surface);
  tool.quantities("--size", size, "m",
                  "Size in x and y; absent: --shape times the spacing of --kernel or --acf", surface);
  tool.quantity("--rq", acf.rms, "m",
                "Rms height of the ensemble; a single surface differs from it by chance (see asperity-stats)",
                surface);
  tool.flag("--exact-rq", exact_rq,
            "Subtract each surface's mean and scale it to --rq. Its heights are then no longer Gaussian "
            "draws of the target, and standard errors do not hold",
            surface);
  tool.flag("--periodic", periodic,
            "A surface that continues itself at its edges. Where the correlation reaches around it, it has "
            "the target's sum over the periods, of the same rms height, which is said; of --acf with all "
            "lags of a periodic surface of this shape, exactly these",
            surface);
  tool.flag("--noise", noise, "Add noise(x,y): the white noise below the middle of the kernel", surface);
  declare_drawing(tool);
}

void GenerateOptions::declare_drawing(Tool& tool) {
  const std::string ensemble = "Ensemble";
  acf.declare(tool, true);
  tool.text(
      "--kernel", kernel, "FILE",
      "A kernel from asperity-kernel in place of these; - is standard input, which is read when no option "
      "names a target. --shape and --size come from its grid or that of --acf, where there is one",
      "Autocorrelation");
  tool.integer("--count", count, {1, 1'000'000, "a file each: go on with --first"},
               "Surfaces to draw from one kernel; --output is then a pattern, s_%04d.nc", ensemble);
  tool.integer("--first", first, 0,
               "Number of the first: --first 17 draws the surface 17 of --seed and --stream", ensemble);
  tool.output();
  tool.report();
  tool.seed();
  tool.threads();
  tool.memory(
      "Largest memory of the drawing, and of the solution of its kernel before, beside the program's own 20 "
      "MB. A surface that does not fit is drawn in strips, each written as it is made; into a pipe or with "
      "--exact-rq it is then drawn twice, for its range stands in front of it. The surface does not depend "
      "on it, to the last bit");
  tool.example(
      "asperity-generate --shape 512x512 --size 3mm --rq 0.4um --length 17px,4px --seed 7 | asperity-stats");
  tool.accuracy(
      "The ensemble has the autocorrelation acf_achieved of the dataset, to round-off; kernel_error is its "
      "distance\n"
      "  from the target. Estimates from one surface scatter by its sampling error: see asperity-stats and "
      "asperity-acf.");
}

void GenerateOptions::check_outputs(Tool& tool) const {
  if (count == 1) return;
  for (int k = 0; k < count; ++k) tool.writes("count", output_name(tool, k));
  if (tool.given("--report"))
    throw UsageError("report", "is of one surface; each dataset of an ensemble carries its own");
}

std::string GenerateOptions::target_option(const Tool& tool) const {
  for (const std::string& key : tool.given_under({"Autocorrelation", "Solution"}))
    if (key != "kernel" && !(acf.filters() && key == "method")) return key;
  return {};
}

std::string GenerateOptions::output_name(const Tool& tool, int k) const {
  return count > 1 ? numbered("output", tool.output_name(), number(k)) : tool.output_name();
}

Synthesis GenerateOptions::synthesis(const Tool& tool, Field kernel_values, Pointwise translation,
                                     std::size_t beside) const {
  return {
      std::move(kernel_values),
      shape,
      {periodic, Summation::cheapest, tool.thread_count(), tool.memory(), std::move(translation), beside}};
}

}  // namespace asperity::cli
