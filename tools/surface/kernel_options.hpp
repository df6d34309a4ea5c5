/// The options that say which autocorrelation a surface shall have, for the tools that solve for its kernel.
///
/// asperity-generate knows them by their groups in --help, "Autocorrelation" and "Solution".
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "acf/band_limited.hpp"
#include "acf/kernel.hpp"
#include "tools/cli/tool.hpp"
#include "tools/surface/kernel_dataset.hpp"
#include "tools/surface/marginal_options.hpp"

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

  /// The model of --model, its lengths in metres, or in samples where no spacing is known. Throws UsageError
  /// for options that it does not use.
  EllipticTarget model(const Tool& tool, const Spacing& spacing) const;
  /// The option that gives its lengths: "length", or "rolloff" of self-affine.
  const char* length_option(const Tool& tool) const { return rolloff_is_length(tool) ? "rolloff" : "length"; }
  /// The surfaces of a period with the spectrum of this model, but for --cutoff and --rolloff; nothing
  /// without either, or where --rolloff is the length of the model. `period` is 0x0 of surfaces that are not
  /// periodic, which are refused; so are options without use.
  std::optional<BandLimited> band(const Tool& tool, const EllipticTarget& model, Shape period) const;
  /// Throws UsageError for an option that a table has no use for.
  void refuse_model(const Tool& tool) const;

 private:
  void declare_target(Tool& tool);
  void declare_solution(Tool& tool, bool draws);
  void refuse_unused(const Tool& tool) const;
  bool rolloff_is_length(const Tool& tool) const;
  Band band_of(const Tool& tool, const EllipticTarget& model, Shape period) const;
  void refuse_beside(const Tool& tool, const std::string& limit) const;
};

}  // namespace asperity::cli
