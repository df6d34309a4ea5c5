/// The options that say which autocorrelation a surface shall have, for the tools that solve for its kernel.
#pragma once

#include <cmath>
#include <optional>

#include "acf/kernel.hpp"
#include "cli/tool.hpp"

namespace asperity::cli {

/// Spacing of the samples in x and y [m], where it is known.
using Spacing = std::optional<std::array<double, 2>>;

struct KernelOptions {
  std::array<SampledLength, 2> length;
  double level = 0.1;
  Shape lags;  ///< 0x0: six decay lengths
  double rms = NAN;
  std::string formulation = "symmetric";
  double tolerance = 1e-10;

  void declare(Tool& tool) {
    const std::string target = "Autocorrelation", solve = "Solution";
    tool.lengths("--length", length,
                 "Lengths at which it has fallen to --level, in x and y: 17px,4px or 0.4mm", target);
    tool.number("--level", level, "What is left of it at --length; 0.3678794 makes them 1/e lengths", target);
    tool.counts("--lags", lags, 1, "Lags prescribed in x and y; absent: six 1/e lengths each way", solve);
    tool.choice("--formulation", formulation, {"symmetric", "patir"},
                "Even kernel, right at all lags, or Patir's quadrant, wrong at the mirrored lags", solve);
    tool.number("--tolerance", tolerance, "Largest residual of the equations, relative to the variance",
                solve);
  }

  ExponentialTarget target(const Spacing& spacing) const {
    const ExponentialTarget model{samples(0, spacing), samples(1, spacing), level};
    model.check();
    return model;
  }

  KernelRequest request(const Spacing& spacing) const {
    const ExponentialTarget model = target(spacing);
    KernelRequest out;
    out.target = model;
    out.lags = lags.nx > 0 ? lags : model.lags();
    out.formulation = formulation_named(formulation);
    out.rms = std::isnan(rms) ? 1 : rms;
    out.tolerance = tolerance;
    out.check();
    return out;
  }

 private:
  double samples(std::size_t axis, const Spacing& spacing) const {
    if (!length[axis].samples && !spacing)
      throw UsageError("length", "a length in metres needs --spacing, or --shape and --size");
    return length[axis].in_samples(spacing ? (*spacing)[axis] : 1.0);
  }
};

/// The spacing of `shape` samples on `size`, which must be positive.
inline Spacing spacing_of(Shape shape, std::array<double, 2> size) {
  for (double s : size)
    if (!(s > 0 && std::isfinite(s)))
      throw UsageError("size", format_quantity(s, "m") + ": must be positive");
  return std::array{size[0] / static_cast<double>(shape.nx), size[1] / static_cast<double>(shape.ny)};
}

}  // namespace asperity::cli
