/// What a kernel is sought for: the equations of a request at given lags, and what its spectrum says beforehand.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "acf/equations.hpp"
#include "acf/kernel.hpp"

namespace asperity {

class KernelProblem {
 public:
  /// The request must live as long as the problem. `of_no_surface`: its spectrum is known to be negative whatever the
  /// lags. Throws ParameterError("memory") where Newton's iteration takes more than the request allows, and
  /// ParameterError("lags") or DataError("acf") when the target is not finite.
  KernelProblem(const KernelRequest& request, Shape lags, bool of_no_surface);

  const KernelRequest& request() const { return request_; }
  Shape lags() const { return lags_; }
  bool of_no_surface() const { return of_no_surface_; }
  Formulation formulation() const { return formulation_; }
  bool oriented() const { return formulation_ == Formulation::oriented; }
  bool zero_phase() const { return formulation_ != Formulation::patir; }
  Equations& equations() const { return *equations_; }
  const Feasibility& feasibility() const { return feasibility_; }

  /// Whether no iteration is worth its time, and whether Newton's matrix is singular at the solution.
  bool recognised() const;
  bool smooth() const;
  /// Of the change to the lags prescribed: of a table at open lags, what is tolerated over all of it.
  double enough() const;

  /// What these coefficients achieve, their variance set right where they are no solution; none if they are not finite.
  std::optional<Kernel> evaluate(const Field& values, Answer answer) const;
  bool solved_by(const Kernel& kernel) const { return kernel.report.residual <= request_.tolerance; }
  /// By the error over all lags; of a table, or in Patir's formulation, by the residual.
  bool better(const Kernel& a, const Kernel& b) const;

  /// Passes on, with its name, what an iteration tells.
  IterationObserver observer(std::string_view iteration) const;
  /// Throws ParameterError("lags"), or DataError("acf") for a table.
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  const KernelRequest& request_;
  Shape lags_;
  bool of_no_surface_;
  Formulation formulation_;
  std::unique_ptr<Equations> equations_;
  Feasibility feasibility_;
  bool exceeds_variance_;  ///< |R| > R(0,0) somewhere, as in no autocorrelation
};

}  // namespace asperity
