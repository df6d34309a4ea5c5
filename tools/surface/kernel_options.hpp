/// The options that say which autocorrelation a surface shall have, for the tools that solve for its kernel.
///
/// Their groups in --help, "Autocorrelation" and "Solution", are also how asperity-generate knows them. The heights'
/// distribution is one of them, for it changes the autocorrelation that the kernel is solved for.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "acf/kernel.hpp"
#include "acf/wording.hpp"
#include "tools/cli/tool.hpp"
#include "tools/surface/marginal_options.hpp"

namespace asperity::cli {

/// Spacing of the samples in x and y [m], where it is known.
using Spacing = std::optional<std::array<double, 2>>;

struct KernelOptions {
  std::string target = "exponential", acf, angle = "0deg", wavelength;
  std::array<SampledLength, 2> length;
  double level = 0.1;
  double smoothness = 1, exponent = 1, hurst = 0.8;
  double rms = NAN;
  MarginalOptions heights;

  Shape lags;  ///< 0x0: chosen
  double acf_tolerance = 1e-3, tolerance = 1e-10;
  std::string formulation, method = "newton-krylov", infeasible = "auto";

  /// A tool that draws may filter noise that is not Gaussian itself.
  void declare(Tool& tool, bool draws = false) {
    declare_target(tool, "Autocorrelation");
    heights.declare(tool);
    declare_solution(tool, "Solution", draws);
  }
  bool filters() const { return method == "filter"; }

  /// The model of --target, its lengths in metres, or in samples where no spacing is known. Throws UsageError for
  /// options that it does not use.
  EllipticTarget model(const Tool& tool, const Spacing& spacing) const {
    refuse_unused(tool);
    EllipticTarget out;
    out.model = model_named(target);
    out.spacing_x = spacing ? (*spacing)[0] : 1;
    out.spacing_y = spacing ? (*spacing)[1] : 1;
    out.length_x = metres("length", length[0], spacing, 0);
    out.length_y = metres("length", length[1], spacing, 1);
    out.level = level;
    out.angle = parse_angle("angle", angle);
    out.smoothness = smoothness;
    out.exponent = exponent;
    out.hurst = hurst;
    if (!wavelength.empty())
      out.wavelength = metres("wavelength", parse_length("wavelength", wavelength), spacing, 0);
    out.check();
    refuse_aliased(out);
    return out;
  }

  /// Throws UsageError for an option that a table has no use for.
  void refuse_model(const Tool& tool) const {
    for (const char* option :
         {"target", "length", "level", "angle", "smoothness", "exponent", "hurst", "wavelength"})
      if (tool.given(std::string("--") + option))
        throw UsageError(option, "does not go together with --acf, which is the whole autocorrelation");
  }

 private:
  void declare_target(Tool& tool, const std::string& group) {
    tool.choice(
        "--target", target,
        {"exponential", "gaussian", "matern", "stretched-exponential", "self-affine", "exponential-cosine"},
        "Its form, made elliptic by two lengths", group);
    tool.lengths("--length", length,
                 "Lengths at which it, or its envelope, has fallen to --level, along its two axes: 17px,4px "
                 "or 0.4mm; px of x and of y",
                 group);
    tool.number("--level", level, "What is left of it at --length; 0.3678794 makes them 1/e lengths", group);
    tool.text("--angle", angle, "ANGLE",
              "From x towards y to the axis of the first length: 30, 30deg, 0.5rad", group);
    tool.number(
        "--smoothness", smoothness,
        "Of matern: 0.5 is the exponential, large ones the Gaussian; the Hurst exponent where it is below 1",
        group);
    tool.number("--exponent", exponent, "Of stretched-exponential, exp(-r^EXPONENT), up to 2", group);
    tool.number("--hurst", hurst, "Of self-affine, whose spectrum is flat below its roll-off, up to 1",
                group);
    tool.text("--wavelength", wavelength, "LENGTH",
              "Of exponential-cosine along its first axis: 12px or 0.1mm", group);
    tool.text("--acf", acf, "FILE",
              "A table in place of all these: a dataset from asperity-acf, or one with acf_target; or text, "
              "columns under the header '# lag_x [um] lag_y [um] acf' or a plain matrix R(p,q); - is "
              "standard input",
              group);
  }

  void declare_solution(Tool& tool, const std::string& group, bool draws) {
    tool.counts("--lags", lags, 1,
                "Lags prescribed in x and y; absent: as many as --acf-tolerance takes, or all of a table",
                group);
    tool.number(
        "--acf-tolerance", acf_tolerance,
        "Largest error over all lags, relative to the variance; of --lags that no kernel has, largest "
        "change. Beyond it exit 3",
        group);
    tool.choice("--formulation", formulation, {"symmetric", "oriented", "patir"},
                "Even kernel, or one even under point reflection alone, each right at all lags, or Patir's "
                "quadrant, wrong at the mirrored lags; absent: by the target",
                group);
    std::vector<std::string> methods{"newton-krylov", "fixed-point", "conjugate-gradient", "spectral"};
    std::string filter;
    if (draws) {
      methods.push_back("filter");
      filter =
          "; filter solves by newton-krylov for Gaussian heights and draws noise that is skewed enough for "
          "its "
          "average to have --skewness and --kurtosis, where there is such noise";
    }
    tool.choice(
        "--method", method, methods,
        "How the equations are solved; spectral takes the root of the spectrum and solves nothing" + filter,
        group);
    tool.choice("--infeasible", infeasible, {"auto", "error", "nearest", "least-squares"},
                "Where no kernel of --lags has this autocorrelation, or no heights this kurtosis: a wider "
                "kernel or the nearest that "
                "there is, if it changes the target by 1e-2 at most (auto) or however much (nearest); the "
                "kernel of least squares; or an error",
                group);
    tool.number("--tolerance", tolerance, "Largest residual of the equations, relative to the variance",
                group);
  }

  void refuse_unused(const Tool& tool) const {
    static constexpr struct {
      const char *option, *target;
    } shapes[] = {{"smoothness", "matern"},
                  {"exponent", "stretched-exponential"},
                  {"hurst", "self-affine"},
                  {"wavelength", "exponential-cosine"}};
    if (!tool.given("--length")) throw UsageError("length", "is required");
    for (const auto& shape : shapes)
      if (tool.given(std::string("--") + shape.option) && target != shape.target)
        throw UsageError(shape.option,
                         "belongs to --target " + std::string(shape.target) + ", not to " + target);
    if (target == "exponential-cosine" && wavelength.empty())
      throw UsageError("wavelength", "is required by --target exponential-cosine");
  }

  // A wave of less than two samples along an axis looks like a longer one.
  void refuse_aliased(const EllipticTarget& t) const {
    if (t.model != Model::exponential_cosine) return;
    const double samples = t.wavelength / std::max(std::abs(std::cos(t.angle)) * t.spacing_x,
                                                   std::abs(std::sin(t.angle)) * t.spacing_y);
    if (samples < 2 * (1 - 1e-12))
      throw UsageError("wavelength", wavelength + ": " + number(samples) +
                                         " samples, at least 2 are needed to tell it from a longer one");
  }

  static double metres(const char* option, const SampledLength& given, const Spacing& spacing,
                       std::size_t axis) {
    if (!given.samples && !spacing)
      throw UsageError(option, "a length in metres needs --spacing, or --shape and --size");
    return given.metres(spacing ? (*spacing)[axis] : 1.0);
  }
};

/// The spacing of `shape` samples on `size`, which must be positive.
inline Spacing spacing_of(Shape shape, std::array<double, 2> size) {
  for (double s : size)
    if (!(s >= 1e-100 && s <= 1e100))
      throw UsageError("size", format_quantity(s, "m") + ": must lie in 1e-100 ... 1e100 m");
  return std::array{size[0] / static_cast<double>(shape.nx), size[1] / static_cast<double>(shape.ny)};
}

}  // namespace asperity::cli
