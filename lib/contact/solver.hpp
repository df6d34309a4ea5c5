/// Frictionless contact of elastic, perfectly plastic rough bodies.
///
///     const Field gap = undeformed_gap(grid, bodies) - heights;
///     Contact contact = solve_contact(grid, gap, bodies.composite_modulus(), {.load = 5000});
///     Contact sunk = solve_contact(grid, gap, bodies.composite_modulus(), {.approach = 20e-6});
///
/// Find the pressure that carries the load Q,
///     0 ≤ p ≤ p_Y,   Σ p ΔxΔy = Q,   gap = h + K p - δ,
/// with gap ≥ 0 where p = 0 (open), gap = 0 where 0 < p < p_Y (elastic), gap ≤ 0 where p = p_Y (flattened
/// plastically by -gap). Or δ is given and Q results; δ counts from the datum of h, so that the bodies first
/// touch at δ = min h. On a periodic surface without limit pressure δ stays below the mean of h.
///
/// K is that of contact/influence.hpp, the residual ε that of contact/problem.hpp, the iteration that of
/// contact/bound_constrained_cg.hpp on the windows of contact/windowed.hpp. It starts from coarser grids
/// (averages of 2 × 2 cells down to 32 a side), each to ε = 1e-3, or from a given pressure.
///
/// Symbols   p pressure [Pa]   p_Y limit pressure [Pa], about 3 σ_Y   Q load [N]   δ approach [m]
///           h undeformed gap [m]   Δx, Δy cell [m]   a contact radius [m]
/// Accuracy  bounds exact, load to 1e-12, ε as requested and confirmed. What the cells leave: Hertz's
///           greatest pressure errs by 0.22 (Δx/a)², the approach by 0.05 (Δx/a)².
/// Cost      10…20 convolutions for smooth bodies at ε = 1e-8, 15…35 for rough ones, hardly more on finer
///           grids; two for a contact of a hundred cells; half as many again for the stiffness.
///           Preconditioners and passes over the cells add a half.
/// Scope     half-spaces and small strains: contact/doubts.hpp says where a result leaves them.
/// Memory    11.5 doubles a cell, gap and result included; less where contact is a part of the domain.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contact/elastic_operator.hpp"
#include "core/field.hpp"

namespace asperity {

/// How far a solution has come.
struct ContactProgress {
  Shape shape;              ///< of the present grid
  double residual = 0;      ///< ε
  double area = 0;          ///< [m²]
  double max_pressure = 0;  ///< [Pa]
  int convolutions = 0;     ///< on the present grid, by their share of its cells
  bool finest = true;       ///< no finer grid follows
};

struct ContactParameters {
  double load = 0;                                                  ///< Q [N]
  std::optional<double> approach = {};                              ///< δ [m], in place of the load
  double limit_pressure = std::numeric_limits<double>::infinity();  ///< p_Y [Pa]; infinity: elastic
  double tolerance = 1e-6;                                          ///< of ε
  int max_convolutions = 1000;                                      ///< on the finest grid
  bool stiffness = false;                                           ///< compute dQ/dδ too, by as many again
  bool nested_start = true;                                         ///< begin on coarser grids
  Field start = {};                                                 ///< or from this pressure [Pa], if any
  int threads = 1;
  std::function<void(const ContactProgress&)> progress = {};  ///< called after every round

  /// Throws ParameterError unless load > 0 or an approach is given, not both; the rest > 0, tolerance < 1.
  void check() const;
};

struct Contact {
  enum State : std::int8_t { open = 0, elastic = 1, plastic = 2 };

  Field pressure;                  ///< p [Pa]
  Field displacement;              ///< K p [m], into the bodies
  Field gap;                       ///< [m]; negative where flattened
  std::vector<std::int8_t> state;  ///< State of each cell of the grid
  Field flattening;  ///< by an earlier, larger load, already in h [m] (contact/sweep.hpp); empty if none
  double flattening_load = 0;        ///< that load [N]
  std::optional<Slabs> shared = {};  ///< among ranks: fields hold a rank's rows, figures are of all
  Slabs slabs() const { return shared.value_or(Slabs(pressure.rows())); }

  double load = 0;          ///< Σ p ΔxΔy [N]
  double approach = 0;      ///< δ [m]
  double mean_gap = 0;      ///< over the domain, 0 where flattened [m]
  double max_pressure = 0;  ///< [Pa]
  double area = 0;          ///< of all cells with p > 0 [m²]
  double plastic_area = 0;  ///< of the cells with p = p_Y [m²]
  /// dQ/dδ [N/m] by contact/stiffness.hpp, and its residual; NaN where not requested or not known.
  double stiffness = std::numeric_limits<double>::quiet_NaN();
  double stiffness_residual = std::numeric_limits<double>::quiet_NaN();

  bool converged = false;    ///< the pressure; a stiffness that has not is NaN
  std::string reason;        ///< why it ended
  double residual = 0;       ///< ε, from a fresh convolution
  double load_residual = 0;  ///< |Σ p ΔxΔy / Q - 1|; 0 where the approach is given
  double convolutions = 0;   ///< applications of K; on windows and coarser grids by their share of the cells
  double preconditionings = 0;  ///< applications of M, counted alike
  int levels = 1;               ///< grids, the finest included
  double setup_seconds = 0;     ///< influence coefficients and plans
  double seconds = 0;           ///< the solution
};

/// Solves with the half-space's operator, the periodic one where the grid is periodic. Throws
/// DataError("heights") when the gap is not finite, DataError("pressure") when the start is not or does not
/// fit, ParameterError("load") when not even p_Y on every cell carries it, ParameterError("approach") when
/// the bodies do not touch at it or no contact has it, either when it leaves the range of a double.
Contact solve_contact(const Grid& grid, Field undeformed_gap, double composite_modulus,
                      const ContactParameters& parameters);

/// With any other operator. Throws DataError("heights") too when its cells are not those of the grid.
Contact solve_contact(const Grid& grid, Field undeformed_gap, ElasticOperator& influence,
                      const ContactParameters& parameters);

}  // namespace asperity
