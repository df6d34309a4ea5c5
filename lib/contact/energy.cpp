#include "contact/energy.hpp"

#include <cmath>

#include "contact/blocks.hpp"
#include "contact/flattening.hpp"

namespace asperity {

double elastic_energy(const Grid& grid, const Contact& contact) {
  const double work = Blocks(contact.slabs(), grid.shape.ny, 1).sum([&](Block b) {
    return (b.of(contact.pressure) * b.of(contact.displacement)).sum();
  });
  return grid.cell_area() * work / 2;
}

double plastic_work(const Grid& grid, const Contact& contact, double limit_pressure) {
  if (std::isinf(limit_pressure)) return 0;
  const Field flattened = plastic_flattening(contact);
  const double depth =
      Blocks(contact.slabs(), grid.shape.ny, 1).sum([&](Block b) { return b.of(flattened).sum(); });
  return grid.cell_area() * limit_pressure * depth;
}

}  // namespace asperity
