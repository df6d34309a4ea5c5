/// Contact of bodies that flow below their surface, step by step along a path of loads.
///
///     PlasticContact contact(grid, gap, bodies, *influence, contact_parameters, plastic_parameters);
///     contact.go_to({.load = 5000}, 8);
///     contact.go_to({.load = 0}, 4);            // unloaded
///     const Field dent = contact.displacement(0);
///
/// Flow below a contact leaves a displacement u of the surface, which the contact meets as a part of its gap:
///     gap = h + u + K p - δ,    u = Bᵀ ε of both bodies,    σ = B p + S ε,    σ_vM ≤ σ_f               (1)
/// (contact/problem.hpp without a limit pressure; plastic/layered_body.hpp; plastic/hardening.hpp). An
/// increment of the load is a fixed point D = F(D) of the strain's change: u of ε_n + D, the contact solved
/// for that gap, the stress, the change that von Mises' condition asks for (plastic/flowing_body.hpp). The
/// contact belongs inside F: flow and contact solved in turn, each with the other frozen, diverges. F
/// lengthens no distance, so that it always converges; KINSOL's Anderson acceleration (math/fixed_point.hpp)
/// takes 5 to 15 evaluations.
///
/// The load rises elastically to where something yields and on in equal increments; their error is of order
/// 1. A smaller load springs back, most often elastically. It ends at
///     2μ max |F(D) - D| / σ_Y ≤ the tolerance.                                                         (2)
///
/// Symbols   h undeformed gap [m]   p pressure [Pa]   δ approach [m]   u displacement into the bodies [m]
///           ε plastic strain   σ stress [Pa]   σ_f flow stress, σ_Y at first [Pa]   μ shear modulus [Pa]
/// Accuracy  von Mises ≤ (1 + 2e-4) σ_f at a tolerance of 1e-4. Of a sphere at six times the approach at
///           which it yields, N increments take 0.024/N off the load and 0.137/N off the dent; n layers leave
///           0.2/n² and 2/n² at most, cells of an nth of the contact's radius 0.08 n⁻¹·⁵ and 0.1 n⁻¹·⁵; the
///           fits of finite elements [1, 2] differ by 3 %.
/// Cost      an evaluation: plastic/layered_body.hpp, and a contact of 5 to 20 convolutions.
/// Scope     small strains, normal load, half-spaces; what flows may not reach the domain's free side.
///
/// D. Nélias, E. Antaluca, V. Boucly, S. Creţu, A three-dimensional semianalytical model for elastic-plastic
/// sliding contacts, J. Tribology 129 (2007) 761-771, alternates between flow and contact.
/// [1] L. Kogut, I. Etsion, Elastic-plastic contact analysis of a sphere and a rigid flat, J. Appl. Mech. 69
///     (2002) 657-662.
/// [2] R. L. Jackson, I. Green, A finite element study of elasto-plastic hemispherical contact against a
///     rigid flat, J. Tribology 127 (2005) 343-354.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "contact/bodies.hpp"
#include "contact/solver.hpp"
#include "plastic/box.hpp"
#include "plastic/flowing_body.hpp"

namespace asperity {

struct PlasticParameters {
  std::array<Hardening, 2> hardening;                       ///< of each body
  std::vector<double> edges = {};                           ///< of layers [m]; empty: chosen
  Index layers = 24;                                        ///< where they are chosen
  double tolerance = 1e-4;                                  ///< of (2)
  int depth = 5;                                            ///< of Anderson's acceleration
  int max_evaluations = 200;                                ///< an increment
  double memory = std::numeric_limits<double>::infinity();  ///< [bytes]
  /// Called after each increment: how many of how many are done.
  std::function<void(int done, int of)> progress = {};

  /// Throws ParameterError("memory") where a box of so many cells needs more than that.
  void check(const PlasticBox& box, Index bodies) const;
  /// Throws ParameterError as Hardening::check does, ("yield") unless a body flows, ("depths") unless edges
  /// rise from 0.
  void check() const;
};

/// Where a path leads: a load, 0 too, or an approach.
struct PlasticTarget {
  double load = 0;                      ///< [N]
  std::optional<double> approach = {};  ///< [m]
};

class PlasticContact {
 public:
  /// As solve_contact throws, and PlasticParameters::check.
  PlasticContact(const Grid& grid, Field undeformed_gap, const Bodies& bodies, ElasticOperator& influence,
                 ContactParameters contact, PlasticParameters parameters);

  /// From the present load to this one; the box of the bodies that flows is chosen at the first call, for the
  /// load that comes next, and grown later.
  void go_to(const PlasticTarget& target, int increments);

  const Contact& contact() const { return contact_; }  ///< under the present load
  const PlasticBox& box() const { return box_; }       ///< without layers while nothing has flown
  /// Which of body() body 0 or 1 is: bodies of one material are one. None: it is elastic.
  std::optional<Index> flowing(std::size_t body) const;
  FlowingBody& body(Index flowing) { return *flowing_[size(flowing)]; }
  /// u of body 0 or 1, on the whole grid [m]; computed once for each load.
  Field displacement(std::size_t body);
  /// The largest von Mises stress over the flow stress under the present load.
  double yield_share();
  int evaluations() const { return evaluations_; }       ///< of F so far
  double convolutions() const { return convolutions_; }  ///< of the contact so far
  double residual() const { return residual_; }          ///< the largest of (2) so far
  bool converged() const { return reason_.empty(); }     ///< every increment
  const std::string& reason() const { return reason_; }  ///< why the first has not
  bool reaches_side() const { return reaches_side_; }    ///< what flows has reached a free side

 private:
  bool flows(std::size_t body) const { return materials_[body].hardening.flows(); }
  bool alike() const { return materials_[0] == materials_[1]; }
  void choose_box(const PlasticTarget& target);
  void check_borne(const PlasticTarget& target, double yield) const;
  FlowReach flow_reached() const;
  ContactParameters parameters_of(const PlasticTarget& target) const;
  Contact untouched(const Field& gap, std::optional<double> approach = {}) const;
  void solve(const PlasticTarget& target, const Field& displaced);
  PlasticTarget between(const PlasticTarget& target, double begin, double part) const;
  void load_elastically(const PlasticTarget& target);
  void increment(const PlasticTarget& target, bool goes_on);
  void commit(bool solved);
  bool flow(const PlasticTarget& target, bool goes_on);
  void extend(std::vector<double>& unknowns);
  void evaluate(const PlasticTarget& target, std::span<const double> unknowns, std::span<double> out);
  std::vector<double> scale();
  /// use(body, the first of its unknowns, their number), in order.
  template <class Use>
  void each_share(Use use) {
    std::size_t first = 0, count = 0;
    for (auto& body : flowing_) {
      use(*body, first, count = size(body->unknowns()));
      first += count;
    }
  }

  const Grid grid_;
  const Field gap_;
  ElasticOperator& influence_;
  ContactParameters contact_parameters_;
  PlasticParameters parameters_;
  std::array<PlasticMaterial, 2> materials_;

  Contact contact_;
  PlasticBox box_;
  std::vector<std::unique_ptr<FlowingBody>> flowing_;
  std::vector<double> changed_;  ///< D' of the last evaluation
  double largest_ = 0;           ///< von Mises over flow stress where it is no unknown, likewise
  double last_residual_ = 1;
  bool flowed_ = false;
  std::array<Field, 2> displaced_;  ///< of the flowing bodies, on the whole grid, or empty
  int evaluations_ = 0;
  double convolutions_ = 0, residual_ = 0;
  bool reaches_side_ = false;
  std::string reason_;
};

}  // namespace asperity
