/// Conjugate gradients on the cells that may change: free ones, and those that the gap drives off a bound,
///     F = {0 < p < c} ∪ {p = 0, g < δ} ∪ {p = c, g > δ}.                                        (1)
/// On F the energy is least, bounds ignored, where g is even: r = mean_F(g) - g = 0. With P_F the projection
/// that masks F and subtracts the mean over F, a step is
///     z = P_F M r,   β = z·r / (z·r)_old,   d = z + β d,                                        (2)
///     q = K d,   a = z·r / d·q,   p += a d,   g += a q,   r = P_F (r - a q).
/// Σp stays as it is, and δ is never an unknown. Under a given approach δ takes the place of mean_F(g), and
/// P_F only masks. M is linear and F stands, so that β is Fletcher's and Reeves's. In the place of M may be
/// B of contact/two_level.hpp, which varies a little: then β = max(0, z·(r - r_old) / (z·r)_old), Polak's and
/// Ribière's.
///
/// Cost: an application of K, one of M, and four passes a step, a third of the operators' time.
/// Memory: four fields and a mask; r, z and q are never wanted at once and share one, r following from g. One
/// more with B.
///
/// I. A. Polonsky, L. M. Keer, A numerical method for solving rough contact problems based on the multi-level
/// multi-summation and conjugate gradient techniques, Wear 231 (1999) 206-219; E. A. H. Vollebregt, The
/// bound-constrained conjugate gradient method for non-negative matrices, J. Optim. Theory Appl. 162 (2014)
/// 931-953.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/problem.hpp"
#include "contact/two_level.hpp"

namespace asperity {

/// (1): 1 for the cells of F, 0 for the others. A byte each: the passes are bound by what they read.
struct FreeSet {
  FreeSet(const ContactProblem& problem, const Field& p, const Field& g, double approach);

  /// Takes cells on a bound out again unless |g - δ| is above 0.3 of the largest of the free cells; all of
  /// them while the root of Σ(g - δ)² over them is below 0.01 of that over the free cells.
  void proportion(const ContactProblem& problem, const Field& p, const Field& g, double approach);

  std::vector<std::int8_t> mask;
  double cells = 0, gap_sum = 0;  ///< Σ g over F [m]

 private:
  /// Puts a cell in where in(p, g, was in).
  template <class In>
  void choose(const ContactProblem& problem, const Field& p, const Field& g, In in);
};

/// A pressure, its gap, a direction and the direction's displacement.
struct Trial {
  Field p;                         ///< [Pa]
  Field g;                         ///< h + K p [m]
  Field d;                         ///< [Pa]
  Field q;                         ///< K d [m]; r and M r between
  std::vector<float> before = {};  ///< r of the step before, of the first one's largest; empty where M serves
};

/// r of all cells or some.
struct SubspaceResidual {
  double squared = 0, largest = 0;  ///< |r|² [m²], max|r| [m]

  double norm() const { return std::sqrt(squared); }  ///< |r| [m]
  void operator+=(const SubspaceResidual& other) {
    squared += other.squared;
    largest = std::max(largest, other.largest);
  }
};

class SubspaceCG {
 public:
  /// Starts from p and g = h + K p. The iterate is p and g of `trial`, whose fields are worked in.
  /// Preconditioned by M, or by `two_level`, which has been set to F.
  SubspaceCG(const ContactProblem& problem, const FreeSet& free, const Field& p, const Field& g, Trial& trial,
             TwoLevel* two_level = nullptr);

  /// (2). False, and p and g are as before, when the curvature along d or z·r is not positive.
  bool step();

  int steps() const { return steps_; }
  /// Of K, and as many of M, coarse ones by their share: a step that is refused has taken them too.
  double applications() const {
    return applications_ + (two_level_ != nullptr ? two_level_->coarse_applications() : 0);
  }
  double level() const { return mean_gap_; }  ///< mean of g over F, or the given δ [m]
  const SubspaceResidual& residual() const { return residual_; }
  /// Whether a pressure is out of its bounds.
  bool out_of_bounds() const;
  /// Whether the gap drives a cell off the bound on which F keeps it.
  bool set_too_small() const;

 private:
  /// What P_F subtracts from a field whose sum over F this is.
  double mean(double sum) const { return problem_.approach ? 0 : sum / free_.cells; }
  /// The product with another vector, and the sum over F.
  struct Sums {
    double product = 0, sum = 0, before = 0;
    void operator+=(const Sums& other) { product += other.product, sum += other.sum, before += other.before; }
  };
  void precondition();
  Sums sums_of_z();        ///< z·r, and z·r_old, in whose place comes r
  Sums sums_of_q() const;  ///< d·q
  SubspaceResidual residual(Block b);
  void turn(double mean_z, double beta);
  void advance(double a, double mean_q);

  const ContactProblem& problem_;
  const FreeSet& free_;
  Trial& trial_;
  TwoLevel* two_level_;
  double mean_gap_, zr_old_ = 1, first_largest_;
  SubspaceResidual residual_;
  int steps_ = 0, applications_ = 0;
};

}  // namespace asperity
