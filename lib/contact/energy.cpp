#include "contact/energy.hpp"

#include <cmath>

#include "contact/blocks.hpp"

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

Field plastic_flattening(const Contact& contact) {
  Field out = (-contact.gap).max(0.0);
  const std::int8_t* state = contact.state.data() + contact.slabs().own().first * out.cols();
  for (Index i = 0; i < out.size(); ++i)
    if (state[i] != Contact::plastic) out.data()[i] = 0;
  if (contact.flattening.size() > 0) out += contact.flattening;
  return out;
}

}  // namespace asperity
