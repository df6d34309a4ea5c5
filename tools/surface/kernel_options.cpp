#include "tools/surface/kernel_options.hpp"

#include <algorithm>

#include "core/words.hpp"

namespace asperity::cli {
namespace {

bool given(const Tool& tool, const char* option) { return tool.given(std::string("--") + option); }

std::vector<std::string> words(auto enumeration) {
  const auto all = enum_words(enumeration);
  return {all.begin(), all.end()};
}

double metres(const char* option, const SampledLength& length, const Spacing& spacing, std::size_t axis) {
  if (!length.samples && !spacing)
    throw UsageError(option, "a length in metres needs --spacing, or --shape and --size");
  return length.metres(spacing ? (*spacing)[axis] : 1.0);
}

// A wave of less than two samples along an axis looks like a longer one.
void refuse_aliased(const EllipticTarget& t, const std::string& wavelength) {
  if (t.model != Model::exponential_cosine) return;
  const double samples = t.wavelength / std::max(std::abs(std::cos(t.angle)) * t.spacing_x,
                                                 std::abs(std::sin(t.angle)) * t.spacing_y);
  if (samples < 2 * (1 - 1e-12))
    throw UsageError("wavelength", wavelength + ": " + number(samples) +
                                       " samples, at least 2 are needed to tell it from a longer one");
}

}  // namespace

void KernelOptions::declare(Tool& tool, bool draws) {
  declare_target(tool);
  heights.declare(tool);
  declare_solution(tool, draws);
}

void KernelOptions::declare_target(Tool& tool) {
  const std::string group = "Autocorrelation";
  tool.choice("--model", target, words(Model{}), "Its form, made elliptic by two lengths", group);
  tool.lengths("--length", length,
               "Lengths at which it, or its envelope, has fallen to --length-level, along its two axes: 17px,4px or "
               "0.4mm; px of x and of y",
               group);
  tool.number("--length-level", shape.level, "What is left of it at --length; 0.3678794 makes them 1/e lengths",
              group);
  tool.text("--angle", angle, "ANGLE", "From x towards y to the axis of the first length: 30, 30deg, 0.5rad",
            group);
  tool.number(
      "--smoothness", shape.smoothness,
      "Of matern: 0.5 is the exponential, large ones the Gaussian; the Hurst exponent where it is below 1",
      group);
  tool.number("--exponent", shape.exponent, "Of stretched-exponential, exp(-r^EXPONENT), up to 2", group);
  tool.number("--hurst", shape.hurst, "Of self-affine, whose spectrum is flat below its roll-off, up to 1",
              group);
  tool.text("--wavelength", wavelength, "LENGTH", "Of exponential-cosine along its first axis: 12px or 0.1mm",
            group);
  tool.text(
      "--acf", acf, "FILE",
      "A table in place of all these: a dataset from asperity-acf, or one with acf_target; or text, columns "
      "under the header '# lag_x [um] lag_y [um] acf' or a plain matrix R(p,q); - is standard input",
      group);
}

void KernelOptions::declare_solution(Tool& tool, bool draws) {
  const std::string group = "Solution";
  tool.counts("--lags", request.lags, 1,
              "Lags prescribed in x and y; absent: as many as --acf-tolerance takes, or all of a table",
              group);
  tool.number("--acf-tolerance", request.acf_tolerance,
              "Largest error over all lags, relative to the variance; of --lags that no kernel has, largest "
              "change. Beyond it exit 3",
              group);
  tool.choice("--formulation", formulation, words(Formulation{}),
              "Even kernel, or one even under point reflection alone, each right at all lags, or Patir's "
              "quadrant, wrong at the mirrored lags; absent: by the target",
              group);
  std::vector<std::string> methods = words(Method{});
  std::string filter;
  if (draws) {
    methods.push_back("filter");
    filter =
        "; filter solves by newton-krylov for Gaussian heights and draws noise that is skewed enough for its "
        "average to have --skewness and --kurtosis, where there is such noise";
  }
  tool.choice(
      "--method", method, methods,
      "How the equations are solved; spectral takes the root of the spectrum and solves nothing" + filter,
      group);
  tool.choice("--infeasible", infeasible, words(InfeasiblePolicy{}),
              "Where no kernel of --lags has this autocorrelation, or no heights this kurtosis: a wider "
              "kernel or the nearest that there is, if it changes the target by 1e-2 at most (auto) or "
              "however much (nearest); the kernel of least squares; or an error",
              group);
  tool.number("--tolerance", request.tolerance, "Largest residual of the equations, relative to the variance",
              group);
}

EllipticTarget KernelOptions::model(const Tool& tool, const Spacing& spacing) const {
  refuse_unused(tool);
  EllipticTarget out = shape;
  out.model = enum_named<Model>(target, "model");
  out.spacing_x = spacing ? (*spacing)[0] : 1;
  out.spacing_y = spacing ? (*spacing)[1] : 1;
  out.length_x = metres("length", length[0], spacing, 0);
  out.length_y = metres("length", length[1], spacing, 1);
  out.angle = parse_angle("angle", angle);
  if (!wavelength.empty())
    out.wavelength = metres("wavelength", parse_length("wavelength", wavelength), spacing, 0);
  out.check();
  refuse_aliased(out, wavelength);
  return out;
}

void KernelOptions::refuse_unused(const Tool& tool) const {
  if (!tool.given("--length")) throw UsageError("length", "is required");
  for (const ShapeParameter& parameter : shape_parameters)
    if (const std::string owner(name_of(parameter.model)); given(tool, parameter.name) && target != owner)
      throw UsageError(parameter.name, "belongs to --model " + owner + ", not to " + target);
  if (target == "exponential-cosine" && wavelength.empty())
    throw UsageError("wavelength", "is required by --model exponential-cosine");
}

void KernelOptions::refuse_model(const Tool& tool) const {
  for (const char* option :
       {"model", "length", "length-level", "angle", "smoothness", "exponent", "hurst", "wavelength"})
    if (given(tool, option))
      throw UsageError(option, "does not go together with --acf, which is the whole autocorrelation");
}

}  // namespace asperity::cli
