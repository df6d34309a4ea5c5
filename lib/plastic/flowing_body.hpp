/// A body that flows under a pressure: its plastic strain so far, and what an increment adds to it.
///
/// Given the strain ε_n at the beginning of an increment and its change D, the stress is σ = B p + S (ε_n +
/// D) (plastic/layered_body.hpp). The change that von Mises' condition asks for, by radial return from the
/// deviator that σ would have without D's own part (plastic/hardening.hpp), is
///     ξ = dev σ + 2μ D,   q = √(3/2) |ξ|,   D' = (3/2) (γ/q) ξ.                                        (1)
/// D' = D solves the increment; D → D' is a map that lengthens no distance, because -S/2μ lies in [0, 1].
/// Only the cells of layers that may flow are unknowns, five numbers each, times √h so that their Euclidean
/// product is the body's. Every evaluation tells which others would flow, too.
///
/// Symbols   D change of the plastic strain ε   σ stress [Pa]   μ shear modulus [Pa]   γ equivalent strain
///           of D h thickness of a layer [m]
#pragma once

#include <span>
#include <vector>

#include "plastic/box.hpp"
#include "plastic/hardening.hpp"
#include "plastic/layered_body.hpp"

namespace asperity {

struct PlasticMaterial {
  Hardening hardening;
  double young = 0, poisson = 0;  ///< [Pa]
  double shear_modulus() const { return young / (2 * (1 + poisson)); }
  bool operator==(const PlasticMaterial&) const = default;
};

class FlowingBody {
 public:
  /// `alike`: so many bodies, of one material, flow in the same way.
  FlowingBody(const Grid& grid, const PlasticBox& box, const PlasticMaterial& material, int alike,
              int threads);
  /// The same body with its strain, in a larger box than its own.
  FlowingBody(const Grid& grid, const PlasticBox& box, const FlowingBody& smaller, const PlasticBox& own);

  /// What it needs [bytes], where a quarter of the box flows at a time.
  static double memory(const PlasticBox& box);

  const PlasticMaterial& material() const { return material_; }
  int alike() const { return alike_; }
  Index layers() const { return body_.layers(); }
  double cell_area() const { return grid_.cell_area(); }
  const LayeredField& strain() const { return strain_; }          ///< ε_n
  const LayeredField& equivalent() const { return equivalent_; }  ///< ε̄_n
  double dissipated() const { return dissipated_; }               ///< ∫ σ_f dε̄ dV of all alike [J]
  /// -½ ∫ ε:Sε dV, the energy of the residual stress, of all alike [J]; no unknowns afterwards.
  double stored();

  // ---- an increment ----

  /// Unknowns: none at first, then those that may flow.
  Index unknowns() const { return static_cast<Index>(points_.size()) * deviator::components; }
  /// No unknowns.
  void begin();
  /// Those cells that the last evaluation found beyond `share` of their flow stress; how many are new. Theirs
  /// follow those that are there.
  Index add_points(double share);
  /// 2μ/σ_Y of the strain that an unknown stands for.
  void set_scale(std::span<double> scale) const;
  /// Where the last increment flowed, its change times `factor`.
  std::vector<double> former(double factor);
  /// Takes ε_n + D; then Bᵀ(ε_n + D) of all alike [m].
  Field displaced(std::span<const double> unknowns);
  /// D' under a pressure; returns the largest von Mises stress over the flow stress where no unknown is.
  double respond(const Field& pressure, std::span<const double> unknowns, std::span<double> out);
  /// Adds the D' of the last evaluation to the strain.
  void commit(std::span<const double> unknowns);
  /// What flows by the last evaluation, in cells of the box.
  FlowReach reached() const;

 private:
  void restore();
  double weight(Index point) const;
  Index place(Index point, Index component) const;
  void set_shares(Index layer);
  void flow(Index n, std::span<const double> change, std::span<double> out);

  Grid grid_;  ///< of the box
  PlasticMaterial material_;
  int alike_;
  int threads_;
  LayeredBody body_;
  LayeredField strain_, equivalent_;
  LayeredField stress_;  ///< after an evaluation its first component is von Mises stress over flow stress
  std::vector<Index> points_;     ///< layer · cells + cell
  std::vector<double> before_;    ///< ε_n of the points, while the strain is ε_n + D; or none
  std::vector<char> is_unknown_;  ///< of each cell of a layer
  std::vector<double> gamma_;     ///< of each point
  std::vector<Index> former_points_;
  std::vector<double> former_;
  double dissipated_ = 0;
};

}  // namespace asperity
