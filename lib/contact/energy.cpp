#include "contact/energy.hpp"

#include <cmath>

#include "contact/flattening.hpp"

namespace asperity {

double elastic_energy(const Grid& grid, const Contact& contact) {
  return grid.cell_area() * (contact.pressure * contact.displacement).sum() / 2;
}

double plastic_work(const Grid& grid, const Contact& contact, double limit_pressure) {
  if (std::isinf(limit_pressure)) return 0;
  return grid.cell_area() * limit_pressure * plastic_flattening(contact).sum();
}

}  // namespace asperity
