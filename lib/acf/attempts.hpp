/// The search for a kernel at given lags: several attempts, each of which may find a candidate.
///
/// Before any iteration the spectrum of the cut target is checked. If it is negative beyond round-off under
/// Fejér's window, no surface has it; if its negative part is a tenth of the whole, it is hopeless. Neither
/// is iterated on. Otherwise Newton's iteration, which keeps to positive spectra, decides in a few steps. A
/// target without a kernel is then refused or met by a wider one, as KernelRequest::infeasible says:
///
///     attempt        when
///     wider kernel   the target is smooth: its spectrum ends in round-off
///     Newton         always
///     wider kernel   Newton's iteration has no start, or the spectrum is barely negative; in any other case
///                    once no more lags are tried
///
/// The wider kernel meets the equations exactly where an autocorrelation with these lags exists.
///
/// The first attempt that solves the equations ends the search. Otherwise the candidate with the least error
/// over all lags is kept or, for a table, the one with the least change. A target whose spectrum stays
/// negative for any number of lags (such as a predistorted smooth one) gets the root of the positive part.
/// Patir's equations have no wider kernel: without a solution they are refused.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "acf/equations.hpp"
#include "acf/kernel.hpp"

namespace asperity {

/// The equations of a request at given lags, and what their spectrum says beforehand.
struct KernelProblem {
  /// `of_no_surface`: its spectrum is known to be negative whatever the lags. Throws
  /// ParameterError("memory"), and as refuse() does when the target is not finite.
  KernelProblem(const KernelRequest& request, Shape lags, bool of_no_surface);

  const KernelRequest& request;  ///< lives as long as the problem
  const Shape lags;
  const bool of_no_surface;
  const Formulation formulation;
  const bool oriented, zero_phase;  ///< its formulation
  std::unique_ptr<Equations> equations;
  Feasibility feasibility;
  bool recognised;  ///< no iteration is worth its time
  bool smooth;      ///< Newton's matrix is singular at the solution
  double enough;    ///< change of the lags prescribed; of a table at open lags, over all of it

  bool solved_by(const Kernel& kernel) const { return kernel.report.residual <= request.tolerance; }
  /// By the error over all lags; of a table, or in Patir's formulation, by the residual.
  bool better(const Kernel& a, const Kernel& b) const;
  /// What these coefficients achieve, their variance set right where they are no solution; none if not
  /// finite.
  std::optional<Kernel> evaluate(const Field& values, Answer answer) const;
  /// Passes on the steps of an iteration, with its name.
  IterationObserver observer(std::string_view iteration) const;
  /// Throws ParameterError("lags"), or DataError("acf") for a table.
  [[noreturn]] void refuse(const std::string& message) const;
};

struct Attempt {
  std::optional<Kernel> candidate = {};
  IterationResult effort = {};  ///< its reason, if any, says what kept the attempt from the solution
};

/// The root of the positive part of the spectrum, on a torus of four times the lags.
Attempt spectral_root(const KernelProblem& problem);
/// Newton's iteration from the windowed root, where it is worth its time: a candidate where it converges.
Attempt newton(const KernelProblem& problem);
/// A kernel of twice the lags by projections, and where equations are to be met exactly the least change that
/// meets them (acf/wider_kernel.hpp). For a table met within the tolerance, lags are added until the ends of
/// the kernel do no harm, or until the `best` so far is good enough.
Attempt wider_kernel(const KernelProblem& problem, const std::optional<Kernel>& best);

}  // namespace asperity
