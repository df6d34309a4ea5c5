/// What the contact solver knows of an elastic body: pressure in, displacement out.
///
/// The solver never sees coefficients or transforms. Any symmetric operator that is positive definite on
/// pressures of zero sum will do: a half-space, a periodic one, a layer, one spread over several machines.
#pragma once

#include <memory>

#include "grid/field.hpp"

namespace asperity {

class ElasticOperator {
 public:
  virtual ~ElasticOperator() = default;

  virtual Shape shape() const = 0;
  /// u = K p: displacement [m] under a pressure [Pa]. `u` is resized.
  virtual void apply(const Field& p, Field& u) = 0;
  /// z = M r with M ≈ K⁻¹, symmetric positive (semi)definite and cheaper than K.
  virtual void precondition(const Field& r, Field& z) = 0;
  /// K₀₀: the displacement of a cell under its own unit pressure [m/Pa].
  virtual double self_influence() const = 0;
  /// The same body on cells twice as long and wide; asked only of even shapes.
  virtual std::unique_ptr<ElasticOperator> coarsened() const = 0;
};

}  // namespace asperity
