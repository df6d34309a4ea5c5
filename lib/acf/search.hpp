/// The search for a kernel at given lags: the method asked for, and what follows when there is none.
///
/// Before any iteration the spectrum of the cut target is looked at. One that is negative beyond round-off
/// under Fejér's window belongs to no surface, one whose negative part is a tenth of the whole is hopeless:
/// neither is iterated on. Else Newton's iteration from the windowed root, which keeps to positive spectra,
/// decides in a few steps, and least squares find the few kernels whose spectrum changes sign. A target that
/// has no kernel then is
///     refused,                                               or met by
///     a wider kernel, of twice the lags or more: projections (acf/projections.hpp), then the least change that
///     meets the equations (acf/least_change.hpp), exactly where an autocorrelation with these lags exists,
///     or the n × m kernel of least squares (acf/least_squares.hpp),
/// as KernelRequest::infeasible says. A smooth target, whose spectrum ends in round-off, is given the wider kernel at
/// once; one whose spectrum is negative however many lags it is taken from (a predistorted smooth one, say) the root of
/// the positive part. Of several candidates the one of the least error over all lags is kept, or of a table, of which
/// nothing more is known, the one of the least change.
/// Patir's equations have no wider kernel: least squares answer for them.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "acf/equations.hpp"
#include "acf/kernel.hpp"

namespace asperity {

class Search {
 public:
  static constexpr double largest_change = 1e-2;  ///< that the automatic answer makes unasked [σ²]

  /// The request must live as long as the search. Throws ParameterError("memory") where Newton's iteration takes more
  /// than it allows, as do run() and finish() where a wider kernel does.
  Search(const KernelRequest& request, Shape lags);

  /// In place of run(), of a target whose spectrum is known to be negative whatever the lags: no kernel is sought but
  /// the root of what is positive of it, the nearest over the whole plane.
  void clip();
  /// The method asked for. Throws ParameterError("target") or DataError("acf") when the target is not finite.
  void run();
  bool solved() const { return best_ && (best_->report.residual <= request_.tolerance || spectral()); }
  const Kernel& best() const { return *best_; }
  Formulation formulation() const { return formulation_; }
  /// The best kernel and its report, after the answer to an infeasible target if it is one. Throws
  /// ParameterError("lags"), or DataError("acf") for a table, where that is the answer.
  Kernel finish();

 private:
  using Report = IterationResult;

  void newton();
  void fixed_point(std::vector<double>& u);
  IterationObserver observer(std::string_view iteration) const;
  void take_root(std::string answer);
  bool recognised() const;
  bool wide_enough();
  void answer();
  void descend(long budget);
  void widen();
  double widen(Index torus);
  std::string beyond_limits(Index torus) const;
  bool lost_more_than(double change) const;
  void trim();
  double enough() const;
  double bound() const;  ///< of the change that the automatic answer makes
  std::string closest() const;
  void consider(const std::vector<double>& u);
  void consider(const Field& values, std::string answer);
  void count(const Report& result);
  bool better(const Kernel& candidate) const;
  bool spectral() const { return request_.method == Method::spectral; }
  bool oriented() const { return formulation_ == Formulation::oriented; }
  /// Why there is no kernel, and what can be done.
  std::string excuse() const;
  [[noreturn]] void refuse(const std::string& message) const;

  const KernelRequest& request_;
  Shape lags_;
  Formulation formulation_;
  std::unique_ptr<Equations> equations_;
  ZeroPhaseEquations* zero_phase_ = nullptr;  ///< the same, or none in Patir's formulation
  Feasibility feasibility_;
  bool exceeds_variance_ = false;  ///< |R| > R(0,0) somewhere, as in no autocorrelation
  std::optional<Kernel> best_;
  std::vector<double> descent_;  ///< where least squares have come to
  KernelReport counts_;
  bool infeasible_ = false, hopeless_ = false;
  std::string reason_;
};

}  // namespace asperity
