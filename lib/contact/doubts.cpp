#include "contact/doubts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "contact/hertz.hpp"

namespace asperity {
namespace {

constexpr Index cells_to_be_trusted = 50;
constexpr double sides = 3;       // of a domain that holds a contact, in semi-axes
constexpr double enlarged = 1.5;  // what has them already and is too small

// Whether the contact lies at the domain's ends along x and along y.
struct Touched {
  explicit Touched(const Field& p)
      : along_x((p.row(0) > 0).any() || (p.row(p.rows() - 1) > 0).any()),
        along_y((p.col(0) > 0).any() || (p.col(p.cols() - 1) > 0).any()) {}
  bool along_x, along_y;
};

std::string enlarge(const Grid& grid, const Bodies& bodies, const Contact& contact, Touched touched) {
  const Hertz smooth = hertz(bodies, contact.load);
  const double filled = std::sqrt(contact.load / (std::numbers::pi * contact.max_pressure)) / smooth.radius;
  const double a = smooth.radius_x * std::max(1.0, filled), b = smooth.radius_y * std::max(1.0, filled);
  auto side = [](double semi_axis, double present, bool short_of) {
    return std::max(sides * semi_axis, short_of ? enlarged * present : present);
  };
  return fmt::format(": smooth bodies touch on {:.3g} x {:.3g} m; make it {:.3g} x {:.3g} m or more", 2 * a,
                     2 * b, side(a, grid.size_x(), touched.along_x), side(b, grid.size_y(), touched.along_y));
}

std::string lengthen(const Grid& grid, const Bodies& bodies, const Contact& contact) {
  const bool along_x = bodies.curvature_x() < bodies.curvature_y();
  const double length = along_x ? grid.size_x() : grid.size_y();
  const double width =
      2 * hertz_line(bodies.composite_modulus(), std::max(bodies.curvature_x(), bodies.curvature_y()),
                     contact.load / length)
              .half_width;
  return fmt::format(
      ", where a cylinder ends and presses harder than one without ends, whose contact is {:.3g} m wide: "
      "give a radius along {} too, or a domain wider than that",
      width, along_x ? "x" : "y");
}

std::string at_the_edge(const Grid& grid, const Bodies& bodies, const Contact& contact, Touched touched) {
  return fmt::format("the contact touches the edge of the domain, {:.3g} x {:.3g} m", grid.size_x(),
                     grid.size_y()) +
         (bodies.flat() ? ", and flat bodies go on beyond it: make them periodic, or give a radius"
          : has_point_contact(bodies) ? enlarge(grid, bodies, contact, touched)
                                      : lengthen(grid, bodies, contact));
}

// The smallest radius of a body, either sign.
double smallest(double first, double second) { return std::min(std::abs(first), std::abs(second)); }

}  // namespace

std::vector<std::string> doubts(const Grid& grid, const Bodies& bodies) {
  const auto& [one, other] = bodies.radius;
  std::vector<std::string> out;
  auto look = [&out](const char* axis, double half, double radius) {
    if (half > radius)
      out.push_back(fmt::format(
          "the domain ends at {} = {:.3g} m, beyond a body's radius of {:.3g} m: the gap there is that of a "
          "paraboloid, not of the body",
          axis, half, radius));
  };
  look("x", grid.size_x() / 2, smallest(one.x, other.x));
  look("y", grid.size_y() / 2, smallest(one.y, other.y));
  return out;
}

std::vector<std::string> doubts(const Grid& grid, const Bodies& bodies, const Contact& contact) {
  std::vector<std::string> out;
  const Index cells = (contact.pressure > 0).count();
  if (cells < cells_to_be_trusted)
    out.push_back(
        fmt::format("the contact has {} cells, fewer than {}: refine the grid", cells, cells_to_be_trusted));
  const Touched touched(contact.pressure);
  if (!grid.periodic && (touched.along_x || touched.along_y))
    out.push_back(at_the_edge(grid, bodies, contact, touched));
  const double modulus = bodies.composite_modulus();
  if (contact.max_pressure > modulus)
    out.push_back(fmt::format(
        "the greatest pressure, {:.3g} Pa, is above the composite modulus, {:.3g} Pa, where strains are no "
        "longer small: give a yield stress, filter the heights, or press less",
        contact.max_pressure, modulus));
  return out;
}

}  // namespace asperity
