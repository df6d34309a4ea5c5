#include "contact/doubts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "contact/bodies.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

constexpr Index cells_to_be_trusted = 50, cells_across = 8;
constexpr double sides = 3;       // of a domain that holds a contact, in semi-axes
constexpr double widening = 1.5;  // what has them already and is too small

using CellStates =
    Eigen::Map<const Eigen::Array<std::int8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

// Whether the contact lies at ends of the domain along x and along y where it does not continue.
struct Touched {
  Touched(const CellStates& s, Periodic periodic)
      : along_x(!periodic.x && ((s.row(0) > 0).any() || (s.row(s.rows() - 1) > 0).any())),
        along_y(!periodic.y && ((s.col(0) > 0).any() || (s.col(s.cols() - 1) > 0).any())) {}
  bool along_x, along_y;
};

std::string enlarge(const Grid& grid, const Bodies& bodies, const Contact& contact, Touched touched) {
  const Hertz smooth = hertz(bodies, contact.load);
  const double filled = std::sqrt(contact.load / (std::numbers::pi * contact.max_pressure)) / smooth.radius;
  const double a = smooth.radius_x * std::max(1.0, filled), b = smooth.radius_y * std::max(1.0, filled);
  auto side = [](double semi_axis, double present, bool short_of) {
    return std::max(sides * semi_axis, short_of ? widening * present : present);
  };
  return fmt::format(": smooth bodies touch on {:.3g} x {:.3g} m; make it {:.3g} x {:.3g} m or more", 2 * a,
                     2 * b, side(a, grid.size_x(), touched.along_x), side(b, grid.size_y(), touched.along_y));
}

std::string lengthen(const Grid& grid, const Bodies& bodies, const Contact& contact, Touched touched) {
  const bool along_x = bodies.curvature_x() < bodies.curvature_y();
  const double length = along_x ? grid.size_x() : grid.size_y();
  const double curvature = along_x ? bodies.curvature_y() : bodies.curvature_x();
  const double b = hertz_line(bodies.composite_modulus(), curvature, contact.load / length).half_width;
  const bool across = along_x ? touched.along_y : touched.along_x;
  return fmt::format(
             ", where the end of a cylinder raises the pressure: make it periodic along {0}, or give a "
             "radius "
             "along {0} too",
             along_x ? "x" : "y") +
         (across
              ? fmt::format(", and a domain of {:.3g} m across for a contact of {:.3g} m", sides * b, 2 * b)
              : "");
}

// Of a line contact, across.
std::string widen(const Grid& grid, const Bodies& bodies, const Contact& contact) {
  const double b = hertz_line(grid, bodies, contact.load).half_width;
  const double present = grid.periodic.x ? grid.size_y() : grid.size_x();
  return fmt::format(": smooth bodies touch on a width of {:.3g} m; make it {:.3g} m or more along {}", 2 * b,
                     std::max(sides * b, widening * present), grid.periodic.x ? "y" : "x");
}

std::string at_the_edge(const Grid& grid, const Bodies& bodies, const Contact& contact, Touched touched) {
  return fmt::format("the contact touches the edge of the domain, {:.3g} x {:.3g} m", grid.size_x(),
                     grid.size_y()) +
         (bodies.flat() ? ", but flat bodies continue beyond it: make them periodic, or give a radius"
          : has_line_contact(grid, bodies) ? widen(grid, bodies, contact)
          : has_point_contact(bodies)      ? enlarge(grid, bodies, contact, touched)
                                           : lengthen(grid, bodies, contact, touched));
}

// A strip of `cells_across` through few cells that repeat is as well resolved as a circle of as many.
Index enough_cells(const Grid& grid) {
  const auto [nx, ny] = grid.shape;
  const Index repeated =
      std::min(grid.periodic.x ? nx : cells_to_be_trusted, grid.periodic.y ? ny : cells_to_be_trusted);
  return std::min(cells_to_be_trusted, cells_across * repeated);
}

}  // namespace

std::vector<Doubt> doubts(const Grid& grid, const Bodies& bodies) {
  const auto& [one, other] = bodies.radius;
  auto smallest = [](double first, double second) { return std::min(std::abs(first), std::abs(second)); };
  const double half_x = grid.size_x() / 2, half_y = grid.size_y() / 2;
  const double radius_x = smallest(one.x, other.x), radius_y = smallest(one.y, other.y);
  const bool in_y = half_x / radius_x < half_y / radius_y;
  const double half = in_y ? half_y : half_x, radius = in_y ? radius_y : radius_x;
  if (half / radius <= 1) return {};
  return {
      {"lies on a domain beyond the body",
       fmt::format(
           "the domain ends at {} = {:.3g} m, beyond a body's radius of {:.3g} m: the gap there is that of a "
           "paraboloid, not of the body",
           in_y ? "y" : "x", half, radius)}};
}

std::vector<Doubt> doubts(const Grid& grid, const Bodies& bodies, const Contact& contact) {
  std::vector<Doubt> out;
  const CellStates states(contact.state.data(), grid.shape.nx, grid.shape.ny);
  const Index cells = (states > 0).count(), enough = enough_cells(grid);
  if (cells < enough)
    out.push_back({"has few cells", fmt::format("the contact has {}, fewer than {}: refine the grid",
                                                counted(cells, "cell"), enough)});
  const Touched touched(states, grid.periodic);
  if (touched.along_x || touched.along_y)
    out.push_back({"touches the edge of the domain", at_the_edge(grid, bodies, contact, touched)});
  const double modulus = bodies.composite_modulus();
  if (contact.max_pressure > modulus)
    out.push_back({"presses above the composite modulus",
                   fmt::format("the maximum pressure, {:.3g} Pa, is above the composite modulus, {:.3g} Pa, "
                               "where strains are no "
                               "longer small: give a yield stress, filter the heights, or press less",
                               contact.max_pressure, modulus)});
  return out;
}

}  // namespace asperity
