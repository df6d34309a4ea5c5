/// The search for a kernel at given lags: the attempts of the method asked for, and what follows when there is none.
///
/// Before any iteration the spectrum of the cut target is looked at. One that is negative beyond round-off
/// under Fejér's window belongs to no surface, one whose negative part is a tenth of the whole is hopeless:
/// neither is iterated on. Else Newton's iteration from the windowed root, which keeps to positive spectra,
/// decides in a few steps, and least squares find the few kernels whose spectrum changes sign. A target that
/// has no kernel then is refused, or met by a wider kernel, or by the n × m kernel of least squares, as
/// KernelRequest::infeasible says:
///
///     attempt (acf/attempts.hpp)      when
///     wider kernel                    the target is smooth: its spectrum ends in round-off
///     Newton                          always
///     wider kernel                    Newton's iteration has no start, or the spectrum is barely negative
///     least squares, a second         there is no kernel yet, as in all that follows
///     wider kernel or least squares   as the policy says: the wider one meets the equations exactly where an
///                                     autocorrelation with these lags exists
///
/// The first attempt that solves the equations ends the search; else the candidate of the least error over all lags is
/// kept, or of a table, of which nothing more is known, the one of the least change. A target whose spectrum is negative
/// however many lags it is taken from (a predistorted smooth one, say) gets the root of the positive part. Patir's
/// equations have no wider kernel: least squares answer for them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "acf/attempts.hpp"

namespace asperity {

class KernelSolver {
 public:
  /// As KernelProblem's.
  explicit KernelSolver(const KernelRequest& request, Shape lags, bool of_no_surface = false)
      : problem_(request, lags, of_no_surface) {}

  /// The attempts of the method asked for. Throws ParameterError("memory") where a wider kernel takes more than is
  /// allowed, as does finish().
  void run();
  bool solved() const { return best_ && (problem_.solved_by(*best_) || method() == Method::spectral); }
  const Kernel& best() const { return *best_; }
  /// The best kernel and its report, after the answer to an infeasible target if it is one. Throws
  /// ParameterError("lags"), or DataError("acf") for a table, where that is the answer.
  Kernel finish();

 private:
  void try_in_turn(const std::vector<std::function<Attempt()>>& attempts);
  void choose(Attempt attempt);
  Attempt wider();
  Attempt answer();
  std::string excuse() const;
  std::string closest() const;
  void complete(KernelReport& report) const;
  Method method() const { return problem_.request.method; }
  double bound() const;

  KernelProblem problem_;
  std::optional<Kernel> best_;
  IterationResult effort_;              ///< of all attempts; the reason is that of the last which had one
  std::vector<double> unknowns_;        ///< where least squares have come to
  std::optional<std::string> widened_;  ///< once there was a wider kernel: why none is wider still
};

}  // namespace asperity
