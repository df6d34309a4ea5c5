/// The contact problem on cells, and one number that says how well it is solved.
///
/// Wanted is a pressure p on n cells with
///     0 ≤ p ≤ c,   Σp = S,                                                                   (1)
///     g - δ ≥ 0 where p = 0,   = 0 where 0 < p < c,   ≤ 0 where p = c,   g = h + K p.        (2)
/// These are the conditions of the least energy ½ p·Kp + h·p under (1); the approach δ is the multiplier of
/// the load. Where p = c the bodies overlap by δ - g, the plastic flattening. c = ∞ is elastic contact.
///
/// Or δ is given in place of S: then Σp is free, and (2) are the conditions of the least
///     ½ p·Kp + (h - δ)·p   under 0 ≤ p ≤ c.                                                  (1')
/// δ ≤ min h leaves p = 0. On periodic surfaces with c = ∞ (1') has a minimum for δ < mean h alone: in full
/// contact the mean gap is 0 whatever the load.
///
/// Given any p within (1), δ is the mean of g where 0 < p < c; if no cell is free, the midpoint of max g over
/// p = c and min g over p = 0, or the one that exists. p is unique, K being definite; δ is where a cell is
/// free, and else any value between those two. With k = K₀₀,
///     w = k p - clip(k p - (g - δ), 0, k c)                                                  (3)
/// is g - δ where p is free, min(g - δ, 0) where p = 0, max(g - δ, 0) where p = c, as far as a cell's own
/// pressure can mend it, and 0 everywhere in the solution alone. The residual is
///     ε = max|w| / max(max u - min u, k Σp/n),   u = K p.                                    (4)
/// k Σp/n, a cell's displacement under the mean pressure, counts only where contact is so full and so flat
/// that u hardly varies. ε depends neither on units nor on the datum of h. ε = 1e-6 leaves the greatest
/// pressure an error of 1e-9…3e-5 and the contact area one of three cells or less; ε = 1e-8 leaves 1e-10…2e-7
/// and none. Round-off sets a floor of 5e-14…5e-12, with h counted from about δ.
///
/// Symbols   p pressure [Pa]   c limit pressure [Pa]   S load over cell area [Pa]   h undeformed gap [m]
///           g gap but for the approach [m]   δ approach [m]   K elastic operator [m/Pa]
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "contact/blocks.hpp"
#include "contact/elastic_operator.hpp"
#include "core/field.hpp"

namespace asperity {

struct ContactProblem {
  ElasticOperator* influence = nullptr;                  ///< K
  Field h;                                               ///< undeformed gap [m]
  double sum = 0;                                        ///< S [Pa]
  double cap = std::numeric_limits<double>::infinity();  ///< c [Pa]
  double self_influence = 0;                             ///< K₀₀ [m/Pa]
  std::optional<double> approach = {};                   ///< δ [m], given in place of S
  int threads = 1;
  double datum = 0;  ///< what h, g and δ count from [m]

  /// Counts from `by` further up. Round-off of g is ε of its largest in contact: none where δ is about 0.
  void shift(double by);
  /// The same on other cells of the body.
  ContactProblem on(ElasticOperator& cells, Field gap) const {
    return {&cells, std::move(gap), sum, cap, self_influence, approach, threads, datum};
  }
  Shape shape() const { return influence->shape(); }
  Slabs slabs() const { return influence->slabs(); }
  /// Over the rows of this rank; sums over all.
  Blocks blocks() const { return {slabs(), shape().ny, threads}; }
  bool capped() const { return cap < std::numeric_limits<double>::infinity(); }
  bool is_free(double p) const { return p > 0 && p < cap; }
};

struct ContactResidual {
  double epsilon = 0;       ///< ε of (4)
  double approach = 0;      ///< δ [m]
  double scale = 0;         ///< the denominator of (4) [m]
  double sum = 0;           ///< Σp [Pa]
  double max_pressure = 0;  ///< [Pa]
  Index free = 0;           ///< cells with 0 < p < c
  Index plastic = 0;        ///< cells with p = c

  Index contact() const { return free + plastic; }
};

/// Throws ParameterError(name) for a load [N] that c on every cell does not carry.
void check_carried(const char* name, double load, const Grid& grid, double cap);

/// (4), δ and what comes with them, for g = h + K p.
ContactResidual contact_residual(const ContactProblem& problem, const Field& p, const Field& g);

/// Pressures onto 0 ≤ p ≤ c and Σp = S. Both functions keep the bounds exactly and the load to round-off; S ≤
/// n c is presupposed. Where the approach is given in place of the load, both only clip. Cost: a few passes
/// over the cells. The first gives the nearest pressure in the Euclidean norm: p = clip(x + s, 0, c), s by
/// safeguarded Newton steps.
void project(const ContactProblem& problem, Field& p);

/// Clips, then multiplies the free cells by the factor that restores the load, again while some of them reach
/// c. Cells at 0 or at c stay there. False if no positive factor does it; then p is only clipped.
bool clip_and_rescale(const ContactProblem& problem, Field& p);

/// The problem on coarser cells, for a start that is nearly the solution, and the body there. The gap is
/// averaged over 2 × 2 cells.
struct CoarseLevel {
  std::unique_ptr<ElasticOperator> body;
  ContactProblem problem;
};

/// Under the same load or approach, from the second finest grid on: sides are even, no half below 32.
std::vector<CoarseLevel> coarser_levels(const ContactProblem& problem);
/// Pressures on the grid twice as fine, shared among ranks as `to`: with the weights 9-3-3-1 of the four
/// nearest coarse cells where the coarse cell that holds the fine one is in contact, 0 elsewhere.
Field prolonged(const Field& coarse, const Slabs& from, const Slabs& to, Periodic periodic, int threads);

}  // namespace asperity
