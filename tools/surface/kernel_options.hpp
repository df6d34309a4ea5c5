/// The options that say which autocorrelation a surface shall have, for the tools that solve for its kernel.
///
/// asperity-generate knows them by their groups in --help, "Autocorrelation" and "Solution".
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "acf/kernel.hpp"
#include "tools/cli/tool.hpp"
#include "tools/surface/kernel_dataset.hpp"
#include "tools/surface/marginal.hpp"

namespace asperity::cli {

struct KernelOptions {
  std::string target = "exponential", acf, angle = "0deg", wavelength, cutoff;
  std::array<SampledLength, 2> length, rolloff;
  EllipticTarget shape;  ///< its level and the parameters of its shape
  double rms = NAN;
  MarginalOptions heights;

  KernelRequest request;  ///< its lags and tolerances
  std::string formulation, method = "newton-krylov", infeasible = "auto";

  /// A tool that draws may filter noise that is not Gaussian itself.
  void declare(Tool& tool, bool draws = false);
  bool filters() const { return method == "filter"; }

  /// The option that gives its lengths: "length", or "rolloff" of self-affine.
  const char* length_option(const Tool& tool) const { return rolloff_is_length(tool) ? "rolloff" : "length"; }
  bool rolloff_is_length(const Tool& tool) const;  ///< of self-affine

 private:
  void declare_target(Tool& tool);
  void declare_solution(Tool& tool, bool draws);
};

}  // namespace asperity::cli
