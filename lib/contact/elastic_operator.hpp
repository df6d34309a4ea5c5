/// What the contact solver knows of an elastic body: pressure in, displacement out.
///
/// The solver never sees coefficients or transforms. Any symmetric operator that is positive definite on
/// pressures of zero sum will do: a half-space, a periodic one, a layer, one spread over several machines.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "core/field.hpp"
#include "core/ranks.hpp"

namespace asperity {

class ElasticOperator {
 public:
  virtual ~ElasticOperator() = default;

  virtual Shape shape() const = 0;
  /// Whether it is one of this grid's cells, as far as it knows.
  virtual bool fits(const Grid& grid) const { return grid.shape == shape(); }
  /// Its rows, as ranks share them: fields in and out hold this rank's.
  virtual Slabs slabs() const { return Slabs(shape().nx); }
  /// u = K p: displacement [m] under a pressure [Pa]. `u` is resized, and may be `p`.
  virtual void apply(const Field& p, Field& u) = 0;
  /// K p to single precision where that takes less time: within 1e-6 of the largest |u|. `u` may be `p`.
  virtual void apply_single(const Field& p, Field& u) { apply(p, u); }
  /// z = M r with M ≈ K⁻¹, linear, symmetric positive (semi)definite and cheaper than K. `z` may be `r`.
  virtual void precondition(const Field& r, Field& z) = 0;
  /// K₀₀: the displacement of a cell under its own unit pressure [m/Pa].
  virtual double self_influence() const = 0;
  /// K between two cells that are i and j apart, 0 ≤ i, j ≤ reach, but for a constant [m/Pa]. Called only for
  /// shapes with more than 2 reach cells a side.
  virtual Field near_influence(Index reach) {
    Field u = Field::Zero(shape().nx, shape().ny);
    const Index i = shape().nx / 2, j = shape().ny / 2;
    u(i, j) = 1;
    apply(u, u);
    return u.block(i, j, reach + 1, reach + 1);
  }
  /// The same body on cells `factor` times as long and wide, as many as cover its own.
  virtual std::unique_ptr<ElasticOperator> coarsened(Index factor) const = 0;
  /// The same body on a rectangle of its cells, of this shape or somewhat more: K of pressures that are 0
  /// elsewhere. Its position does not matter: bodies are uniform. Null if it would not save time.
  virtual std::shared_ptr<ElasticOperator> windowed(Shape) { return nullptr; }
  /// Forgets the windows made so far: the next solution then has the bits that a new operator gives it.
  virtual void forget_windows() {}
  /// Spent so far on coefficients, plans and spectra.
  virtual double setup_seconds() const { return 0; }
  /// Memory that the caller may use until the next application.
  virtual std::span<double> room(std::size_t doubles) {
    room_.resize(std::max(room_.size(), doubles));
    return {room_.data(), doubles};
  }

 private:
  std::vector<double> room_;
};

}  // namespace asperity
