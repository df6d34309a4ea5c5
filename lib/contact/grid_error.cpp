#include "contact/grid_error.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "contact/energy.hpp"
#include "contact/outline.hpp"
#include "core/error.hpp"
#include "core/halved.hpp"
#include "core/stopwatch.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

// validation/contact_grid_error. m is (1): the first difference alone is near zero by accident in a few per
// cent of scenes.
constexpr double coarse_residual = 1e-6;  // ε of the coarser contacts; 1e-3 is too loose
constexpr Index least_coarse_side = 12;   // cells of the coarsest grid
constexpr Index least_cells = 8;          // in contact: of fewer, one pressure in three is off by more
constexpr double pressure_share = 1.0 / 3, plastic_share = 1.0 / 3, stiffness_share = 1.0 / 3;  // of m
constexpr double peak_share = 1.5;      // of the rise of a parabola above the largest pressure
constexpr double approach_share = 0.4;  // of the larger m, of approach and mean gap
constexpr double load_share = 0.8;      // of m, under a prescribed approach, and of the work of flattening
constexpr double energy_share = 0.4;    // of m, under a load
constexpr double work_share = 0.1;      // of the load times the m of the approach
constexpr double ragged_share = 0.3;    // of the stiffness, times Outline::scatter over its cells
constexpr double missed_cells = 0.10;   // of a cell a side of the area at the limit pressure

// By how much the mean of the paraboloid over 2 × 2 cells exceeds its value in their middle.
double datum_of_mean(const Grid& fine, const Bodies& bodies) {
  return (fine.dx * fine.dx * bodies.curvature_x() + fine.dy * fine.dy * bodies.curvature_y()) / 8;
}

// Of a parabola through three neighbours above the middle one, the largest.
double rise(double left, double top, double right) {
  const double bend = 2 * top - left - right;
  return bend > 0 ? (right - left) * (right - left) / (8 * bend) : 0;
}

double rise_of_peak(const Field& p, Periodic periodic) {
  Index i, j;
  const double top = p.maxCoeff(&i, &j);
  auto at = [&](Index a, Index b) {
    const bool inside_x = periodic.x || (a >= 0 && a < p.rows()),
               inside_y = periodic.y || (b >= 0 && b < p.cols());
    return inside_x && inside_y ? p((a + p.rows()) % p.rows(), (b + p.cols()) % p.cols()) : top;
  };
  return rise(at(i - 1, j), top, at(i + 1, j)) + rise(at(i, j - 1), top, at(i, j + 1));
}

double plastic_area_error(const Grid& grid, const Contact& contact, double m) {
  if (contact.plastic_area == 0 && m == 0) return 0;
  const Outline around = outline(grid, contact, Contact::plastic);
  const double missed = missed_cells * around.sides() * grid.cell_area();
  return missed + std::max(area_scatter(grid, around), plastic_share * m);
}

// (2)
double stiffness_error(const Grid& grid, const Contact& contact, double m) {
  const double free = contact.area - contact.plastic_area;
  if (!(free > 0)) return stiffness_share * m;
  const Outline around = outline(grid, contact, Contact::elastic, Contact::elastic);
  const double ragged = ragged_share * around.scatter() * grid.cell_area() / free;
  return std::max(stiffness_share * m, ragged * contact.stiffness);
}

// What the approach would be off by, times the stiffness: gap and load seldom are near zero together.
double load_error(const CoarserContacts& coarser, double m, double gaps) {
  const double stiffness = coarser.contact[0].stiffness;
  return std::max(load_share * m, std::isfinite(stiffness) ? approach_share * gaps * stiffness : 0);
}

// Energies go with load times approach, and what the one lacks, the other may have. Where a greater load did
// a part of the work of flattening before, none is known.
void set_energies(GridErrors& out, const Grid& grid, const Contact& contact, const CoarserContacts& coarser,
                  double apart) {
  auto m = [&](auto energy) {
    return grid_change(energy(grid, contact), energy(coarser.grid[0], coarser.contact[0]),
                       energy(coarser.grid[1], coarser.contact[1]));
  };
  out.elastic_energy = std::max((coarser.under_approach ? load_share : energy_share) * m(&elastic_energy),
                                work_share * contact.load * apart);
  if (contact.flattening.size() > 0) return;
  const double moved =
      m([&](const Grid& g, const Contact& c) { return plastic_work(g, c, coarser.limit_pressure); });
  out.plastic_work =
      std::isinf(coarser.limit_pressure) ? 0 : std::max(load_share * moved, out.elastic_energy);
}

}  // namespace

std::string too_few_cells(const Grid& grid, const Contact& contact) {
  const Index touching = std::lround(contact.area / (grid.dx * grid.dy));
  if (touching >= least_cells) return "";
  return fmt::format("{} in contact, and errors need {}: refine the grid", counted(touching, "cell"),
                     least_cells);
}

bool has_coarser_contacts(Shape shape) {
  return shape.nx % 4 == 0 && shape.ny % 4 == 0 && std::min(shape.nx, shape.ny) >= 4 * least_coarse_side;
}

CoarserContacts coarser_contacts(const Grid& grid, const Field& undeformed_gap, ElasticOperator& influence,
                                 const Contact& contact, const ContactParameters& parameters,
                                 const Bodies& bodies) {
  CoarserContacts out;
  out.under_approach = parameters.approach.has_value();
  out.limit_pressure = parameters.limit_pressure;
  if (!has_coarser_contacts(grid.shape)) {
    out.unknown = fmt::format("{} cells: both sides must be multiples of 4, of {} cells at least",
                              text(grid.shape), 4 * least_coarse_side);
    return out;
  }
  out.unknown = too_few_cells(grid, contact);
  if (!out.unknown.empty()) return out;
  const Stopwatch watch;
  ContactParameters coarse = parameters;
  coarse.tolerance = coarse_residual;
  coarse.progress = {};
  if (!coarse.approach) coarse.load = contact.load;
  coarse.stiffness = coarse.stiffness || coarse.approach;
  std::unique_ptr<ElasticOperator> body;
  Field gap = undeformed_gap;
  if (contact.flattening.size() > 0) gap += contact.flattening;
  coarse.start = contact.pressure;
  Grid cells = grid;
  for (std::size_t level = 0; level < 2; ++level) {
    const double datum = datum_of_mean(cells, bodies);
    body = (body ? *body : influence).coarsened(2);
    gap = halved(gap, parameters.threads) - datum;
    coarse.start = halved(coarse.start, parameters.threads);
    cells = halved(cells);
    Contact& found = out.contact[level];
    try {
      found = solve_contact(cells, gap, *body, coarse);
    } catch (const ParameterError& error) {
      out.unknown = fmt::format("on {} cells, {}", text(cells.shape), error.what());
      return out;
    }
    if (!found.converged) out.unknown = fmt::format("on {} cells, {}", text(cells.shape), found.reason);
    out.grid[level] = cells;
    coarse.start = found.pressure;
  }
  out.seconds = watch.seconds();
  return out;
}

GridErrors grid_errors(const Grid& grid, const Contact& contact, const CoarserContacts& coarser) {
  if (!coarser.unknown.empty()) return {};
  auto m = [&](double Contact::*figure) {
    return grid_change(contact.*figure, coarser.contact[0].*figure, coarser.contact[1].*figure);
  };
  const Outline around = outline(grid, contact);
  const double gaps = m(&Contact::mean_gap), apart = std::max(m(&Contact::approach), gaps);
  GridErrors out;
  out.max_pressure =
      std::max(pressure_share * m(&Contact::max_pressure),
               contact.plastic_area > 0 ? 0 : peak_share * rise_of_peak(contact.pressure, grid.periodic));
  out.area = area_excess(grid, around);
  out.area_corrected = corrected_area_error(grid, contact, around);
  out.plastic_area = plastic_area_error(grid, contact, m(&Contact::plastic_area));
  out.stiffness = stiffness_error(grid, contact, m(&Contact::stiffness));
  if (!coarser.under_approach) {
    out.approach = out.mean_gap = approach_share * apart;
  } else {
    out.load = load_error(coarser, m(&Contact::load), gaps);
    out.mean_gap = approach_share * gaps;
  }
  set_energies(out, grid, contact, coarser, apart);
  return out;
}

}  // namespace asperity
