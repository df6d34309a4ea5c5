/// Moving-average kernels of random surfaces with prescribed autocorrelation.
///
/// A surface drawn as z(i,j) = Σ kernel(k,l) η(i+k, j+l) from unit white noise η has the autocorrelation
///     R(p,q) = Σ_k Σ_l kernel(k,l) kernel(k+p, l+q).                                                    (1)
/// `solve_kernel` finds the kernel with R = σ² target at the lags |p| < n, |q| < m (symmetric and oriented
/// formulations), or at 0 ≤ p < n, 0 ≤ q < m only (Patir's); acf/equations.hpp has the equations. Beyond, R
/// is free and ends at 2n - 2 (n - 1 in Patir's). The target is never cut: beyond the end of R, the error is
/// the target itself. For a table, all lags are prescribed unless fewer are requested, and none beyond them.
///
/// With too few lags there may be no kernel: for an exponential that has fallen to e⁻ᶜ at the last lag, n is
/// at most about 0.3 c eᶜ. The remedy is more lags, or a kernel wider than its lags (acf/attempts.hpp).
///
/// Symbols   σ  rms height [m]   n, m  lags [samples]   errors are relative to σ²
/// Accuracy  residual ≤ tolerance (1e-10) at the prescribed lags. Over all lags an exponential target with c
///           decay lengths of lags is met within 3e-3, 8e-4, 4e-5, 3e-6 for c = 4.6, 6, 9, 11.5 from 7 × 7
///           lags on, within 2e-3, 4e-4, 2e-5, 1.3e-6 from 31 × 31 (validation/acf_error_time.cpp).
/// Cost      4–6 Newton steps, 8–40 Jacobian products, each of two transforms there and back of (3n)(3m)
///           points. From 15 × 15 lags on the whole takes 1.4–1.7 times its transforms, 1.4–2 where oriented,
///           1.15 in Patir's formulation; below, plans and tables are 0.1 ms.
/// Memory    A search begins with the lags prescribed, those of a table, or those beyond which the target
///           has fallen to 5 acf_tolerance, and may go on to more, a fifth at a time. With a tool's tables a
///           kernel of n × m lags takes
///               1500 n m bytes (160 n m of them in a dataset),                                          (2)
///           or, if it needs a wider one (exponentials of more than about 300 lags) or is the root of a
///           spectrum,
///               250 f² n m bytes (40 f² n m of them in a dataset),                                      (3)
///           f = 4, or more for tables of long waves. The peaks of asperity-kernel are 0.2 to 0.8 times these
///           at 70² to 550² lags, those of asperity-generate 0.5 to 1, and up to 15 MB that the allocator
///           keeps.
///
/// N. Patir, Wear 47 (1978) 263-277; V. Bakolas, Numerical generation of arbitrarily oriented non-Gaussian
/// three-dimensional rough surfaces, Wear 254 (2003) 546-554.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "acf/target.hpp"
#include "core/enum_words.hpp"
#include "core/field.hpp"

namespace asperity {

// ---- an iteration ----

struct IterationStep {
  long step = 0;        ///< 0: the start
  long products = 0;    ///< with the Jacobian, or transforms there and back where there is none
  double residual = 0;  ///< max |R - target| over the equations [σ²]
  double spent = 0;     ///< the share used up of the steps or products that it may take
};

using IterationObserver = std::function<void(const IterationStep&)>;

struct IterationResult {
  bool converged = false;
  std::string reason;  ///< how it ended
  long steps = 0, residuals = 0, jacobian_products = 0, preconditionings = 0;
  double equation_seconds = 0;  ///< in residuals, products and preconditionings of Newton's iteration
};

// ---- a request and its answer ----

enum class Formulation {
  symmetric,  ///< kernel even in k and l: R is even in p and q
  oriented,   ///< kernel even under point reflection: R(p,-q) may differ from R(p,q)
  patir       ///< one quadrant of coefficients: R is right at (p,q), not at (p,-q)
};
enum class Method {
  newton_krylov,  ///< KINSOL's inexact Newton iteration
  spectral        ///< the zero-phase root of the spectrum, no solve
};
/// What to do when no kernel of this size has the requested autocorrelation.
enum class InfeasiblePolicy {
  automatic,  ///< the closest that has one, if it changes the target by 1e-2 (or `acf_tolerance`) at the most
  error,      ///< a ParameterError, or a DataError where the target is a table
  nearest     ///< the closest by projections, however far
};
/// What a kernel is to its equations.
enum class Answer {
  exact,    ///< their solution
  wider,    ///< their solution, wider than the lags
  nearest,  ///< that of the closest autocorrelation found
  spectral  ///< the requested zero-phase root
};
/// Whether an autocorrelation, or a distribution of heights, may be changed by so much of the variance.
bool allows(InfeasiblePolicy policy, double change);

constexpr EnumWords<3> enum_words(Formulation) { return {"symmetric", "oriented", "patir"}; }
constexpr EnumWords<2> enum_words(Method) { return {"newton-krylov", "spectral"}; }
constexpr EnumWords<3> enum_words(InfeasiblePolicy) { return {"auto", "error", "nearest"}; }
constexpr EnumWords<4> enum_words(Answer) { return {"exact", "wider", "nearest", "spectral"}; }

/// A step of one of the iterations that the search for a kernel is made of.
struct KernelProgress : IterationStep {
  Shape lags;
  std::string_view iteration;  ///< "Newton-Krylov", "projections", …
};

struct KernelRequest {
  Target target;                           ///< R/σ² at lags in samples; target(0,0) = 1
  Shape lags = {};                         ///< n × m, both ≥ 1; 0 × 0: chosen for `acf_tolerance`
  std::optional<Formulation> formulation;  ///< none: symmetric, or oriented where the target is
  Method method = Method::newton_krylov;
  InfeasiblePolicy infeasible = InfeasiblePolicy::automatic;
  double rms = 1;            ///< σ [m], 1e-100 … 1e100
  double tolerance = 1e-10;  ///< on the residual [σ²], 1e-13 … 1e-2
  /// On the error over all lags where `lags` is left open, else on the change; 1e-8 … 0.5.
  double acf_tolerance = 1e-3;
  double memory = std::numeric_limits<double>::infinity();   ///< bound of (2) and (3) [byte]
  std::function<void(const KernelProgress&)> progress = {};  ///< called with every step

  void check() const;
};

/// With the counts of all iterations. `converged`: the errors are within `acf_tolerance`; `reason`: how the
/// search ended, and when it failed, what to do.
struct KernelReport : IterationResult {
  Answer answer = Answer::exact;
  double residual = 0;        ///< max |R - target| over the equations [σ²]
  double change = 0;          ///< … over the lags prescribed, of an answer that is not exact
  double error = 0;           ///< … over all lags of the plane, those where R has ended included
  double mirrored_error = 0;  ///< … over 0 < p < n, -m < q < 0
  double tail = 0;  ///< … over the lags that no equation prescribes; of |R| where the target is unknown
  double feasibility = 0;  ///< min/max of the spectrum of the cut target; ≥ 0 is certainly feasible
  double seconds = 0;
};

struct Kernel {
  Formulation formulation = Formulation::symmetric;
  Shape lags;
  double rms = 1;
  Field values;  ///< the whole kernel as (1) applies it [m]
  /// R over p = 0 … 2n-1 (rows), q = -(2m-1) … 2m-1 (columns), more of a wider kernel or a table [m²]: beyond
  /// the support of what is achieved. The target is not a number beyond the lags of a table.
  Field acf_target, acf_achieved;
  KernelReport report;

  /// The lag q of the first column of the tables; the first row is p = 0.
  Index first_q() const { return -(acf_target.cols() / 2); }
};

/// Throws ParameterError("rq") outside the bounds of KernelRequest::rms.
void check_rms(double rms);

/// Throws ParameterError when the request cannot be meant, and for a target that cannot be met where
/// `infeasible` asks for it.
Kernel solve_kernel(const KernelRequest& request);

/// (1) at p = 0 … rows-1 and q = -columns/2 … columns/2, columns odd.
Field autocorrelation(const Field& kernel, Index rows, Index columns);

// ---- what a kernel costs, known before it is solved for ----

/// Throws ParameterError("lags") where they are open and the target does not say how far it reaches.
Shape first_lags(const KernelRequest& request);

struct KernelCost {
  double memory, dataset;  ///< [byte]
};
KernelCost kernel_cost(Shape lags);                         ///< (2)
KernelCost wider_kernel_cost(Shape lags, Index torus = 4);  ///< (3)

/// 150 bytes per point of the torus of acf/periodic.hpp, including 8 in a dataset and 8 for its tables.
KernelCost periodic_kernel_cost(Shape torus);

/// 20 bytes per point of the torus of a root that draws surfaces without a kernel.
KernelCost root_cost(Shape torus);

/// Throws ParameterError("memory") where that is more than the request allows.
void check_memory(const KernelRequest& request, Shape lags, KernelCost cost);
/// The same for a kernel on a torus, given its number of bytes.
void check_memory(KernelCost cost, double memory, Shape torus);

/// The name and version of the library of Newton's iteration.
std::string sundials_version();

}  // namespace asperity
