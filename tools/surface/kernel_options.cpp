#include "tools/surface/kernel_options.hpp"

namespace asperity::cli {
namespace {

std::vector<std::string> words(auto enumeration) {
  const auto all = enum_words(enumeration);
  return {all.begin(), all.end()};
}

}  // namespace

void KernelOptions::declare(Tool& tool, bool draws) {
  declare_target(tool);
  heights.declare(tool);
  declare_solution(tool, draws);
}

void KernelOptions::declare_target(Tool& tool) {
  const std::string group = "Autocorrelation";
  tool.choice("--model", target, words(Model{}),
              "Model of the autocorrelation; elliptic where two lengths are given", group);
  tool.lengths(
      "--length", length,
      "Correlation lengths along the two axes: 17px,4px or 0.4mm. There the ACF, or its envelope, is at "
      "--length-level; px counts samples of x and of y",
      group);
  tool.number("--length-level", shape.level, "ACF value at --length; 0.3678794 for 1/e lengths", group);
  tool.text("--angle", angle, "ANGLE", "Direction of the first length, from +x towards +y: 30deg, 0.5rad",
            group);
  static_assert(std::size(shape_parameters) == 4, "each has an option here");
  tool.number(
      "--smoothness", shape.smoothness,
      "Smoothness of matern; 0.5 is the exponential, infinity the Gaussian. Below 1 it is the Hurst exponent",
      group);
  tool.number("--exponent", shape.exponent, "Exponent of stretched-exponential, exp(-r^EXPONENT); up to 2",
              group);
  tool.number("--hurst", shape.hurst,
              "Hurst exponent of self-affine, up to 1. Its spectrum is flat below the roll-off", group);
  tool.lengths("--rolloff", rolloff,
               "Wavelength above which the spectrum is flat: 0.25mm or 256px; two values along the axes of "
               "--angle. Of self-affine it replaces --length; of other models it needs --periodic",
               group);
  tool.text(
      "--cutoff", cutoff, "LENGTH",
      "Shortest wavelength of a --periodic surface: 16px or 15um; px counts samples of x. A profile has "
      "none: draw a surface and take a row. The autocorrelation is that of the model's spectrum without "
      "shorter waves, and --rq that of the rest",
      group);
  tool.text("--wavelength", wavelength, "LENGTH",
            "Wavelength of exponential-cosine along its first axis: 12px or 0.1mm", group);
  tool.text(
      "--acf", acf, "FILE",
      "Table of the autocorrelation in place of a model; a dataset from asperity-acf, or one with "
      "acf_target; or "
      "text: columns under the header '# lag_x [um] lag_y [um] acf', or a matrix R(p,q); - is standard input",
      group);
}

void KernelOptions::declare_solution(Tool& tool, bool draws) {
  const std::string group = "Solution";
  tool.counts(
      "--lags", request.lags, 1,
      "Number of prescribed lags in x and y. Default: as many as --acf-tolerance needs, or all of a table",
      group);
  tool.number("--acf-tolerance", request.acf_tolerance,
              "Largest error of the ACF over all lags, as a share of the variance; if no kernel has the "
              "prescribed lags, their largest change. Above it the exit status is 3, except that an error "
              "beyond the given --lags only causes a warning",
              group);
  tool.choice(
      "--formulation", formulation, words(Formulation{}),
      "Symmetry of the kernel; symmetric: even in x and y; oriented: even under point reflection only; both "
      "meet all lags. patir: a quadrant, wrong at the mirrored lags. Default: by the target",
      group);
  std::vector<std::string> methods = words(Method{});
  std::string filter;
  if (draws) {
    methods.push_back("filter");
    filter =
        ". filter: newton-krylov for Gaussian heights, and noise so skewed that its average has --skewness "
        "and "
        "--kurtosis, where such noise exists";
  }
  tool.choice("--method", method, methods,
              "Solver of the equations. spectral: the root of the spectrum, without equations" + filter,
              group);
  tool.choice("--infeasible", infeasible, words(InfeasiblePolicy{}),
              "What to do if no kernel of --lags, or no height distribution, allows the target. auto: use a "
              "wider kernel, or the nearest feasible target if it differs by at most 1e-2; nearest: the "
              "same, however large the difference; error: refuse the target",
              group);
  tool.number("--tolerance", request.tolerance,
              "Largest residual of the equations, as a share of the variance", group);
}

bool KernelOptions::rolloff_is_length(const Tool& tool) const {
  return tool.given("--rolloff") && target == "self-affine";
}

}  // namespace asperity::cli
