/// The stress that flow has left in a body, at any depth, to be added to the elastic stress of a load.
///
/// Between the middles of layers the means of plastic/layered_body.hpp are interpolated linearly, above the
/// first they go on as between the first two. Layers without strain, each twice as thick as the one above,
/// follow the given ones to five times their depth; further down there is nothing.
///
/// Accuracy  order 2 in the layers' thickness: where the body flows, von Mises' stress of the sum is within
///           2 % of the flow stress between the middles of 24 layers, at the middles as
///           plastic/plastic_contact.hpp.
/// Cost      once that of plastic/layered_body.hpp on the whole grid.
#pragma once

#include <array>
#include <vector>

#include "plastic/deviator.hpp"
#include "stress/layers.hpp"

namespace asperity {

class ResidualStress : public AddedStress {
 public:
  /// Of a strain, its deviators, in layers between these edges [m] below all cells of a grid.
  ResidualStress(const Grid& grid, const std::vector<double>& edges, const LayeredField& strain, double young,
                 double poisson, int threads = 1);
  /// What it needs to be made, with the strain that it is made of [bytes].
  static double memory(Shape cells, const std::vector<double>& edges);

  Field layer(double z, stress::Component c) const override;
  /// At any place, linear between the cells' centres, beyond which the outermost ones count.
  stress::Tensor at(double x, double y, double z) const;
  /// The middles of the given layers [m].
  const std::vector<double>& depths() const { return depths_; }

 private:
  /// Of two layers, the first of which is this one.
  struct Weights {
    Index layer;
    double upper, lower;
  };
  Weights weights(double z) const;

  Grid grid_;
  std::vector<double> depths_;   ///< of the given layers
  std::vector<double> middles_;  ///< of all
  double end_;                   ///< of the last layer
  LayeredField stress_;          ///< [layer][component of the tensor]
};

}  // namespace asperity
