#include "stats/filter/resampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/words.hpp"
#include "transform/refinement.hpp"

namespace asperity {
namespace {

void resample_axis(Index& points, double& step, bool periodic, double target) {
  if (points == 1) return;
  const double length = static_cast<double>(points) * step, cells = length / target;
  constexpr double most = std::numeric_limits<int>::max() / 2;
  check_parameter(target > 0 && cells >= 2 * (1 - 1e-12) && cells <= most, "spacing",
                  "'" + in_digits(target, 12) + " m' is not from " + number(length / most) +
                      " m to half the axis, " + in_digits(length / 2, 12) + " m");
  points = static_cast<Index>(periodic ? std::round(cells) : std::floor(cells * (1 + 1e-12)));
  step = periodic ? length / static_cast<double>(points) : target;
}

}  // namespace

Grid resampled_grid(const Grid& grid, double dx, double dy) {
  Grid out = grid;
  resample_axis(out.shape.nx, out.dx, grid.periodic.x, dx);
  resample_axis(out.shape.ny, out.dy, grid.periodic.y, dy);
  return out;
}

Field resampled(const Field& z, const Grid& grid, double dx, double dy, int threads) {
  return resampled_onto(z, grid, resampled_grid(grid, dx, dy), threads);
}

// ---- maps turned and mirrored ----

namespace {

constexpr Index most_points = 6;  // of (1) along an axis

// Lagrange's weights at u, in points, of those around it along one axis.
class Stencil {
 public:
  Stencil(Index n, bool periodic) : n_(n), count_(std::min(most_points, n)), periodic_(periodic) {}

  // False outside the outer points.
  bool place(double u) {
    if (!periodic_ && !(u >= 0 && u <= static_cast<double>(n_ - 1))) return false;
    if (periodic_ && !(u >= -0.5 && u <= static_cast<double>(n_) - 0.5)) return false;
    first_ = static_cast<Index>(std::floor(u)) - (count_ - 1) / 2;
    if (!periodic_) first_ = std::clamp<Index>(first_, 0, n_ - count_);
    const double s = u - static_cast<double>(first_);
    for (Index a = 0; a < count_; ++a) {
      weights_[size(a)] = 1;
      for (Index b = 0; b < count_; ++b)
        if (b != a) weights_[size(a)] *= (s - static_cast<double>(b)) / static_cast<double>(a - b);
    }
    return true;
  }
  Index count() const { return count_; }
  Index at(Index a) const { return (first_ + a + n_) % n_; }
  double weight(Index a) const { return weights_[size(a)]; }

 private:
  Index n_, count_, first_ = 0;
  bool periodic_;
  std::array<double, most_points> weights_{};
};

// On grid lines to round-off, where one weight is 1.
double near_integer(double u) {
  const double whole = std::round(u);
  return std::abs(u - whole) <= 1e-9 ? whole : u;
}

// The quarters of a turn that is a multiple of one.
std::optional<int> quarters_of(double angle) {
  check_parameter(std::isfinite(angle), "rotate", "'" + shortest(angle) + "' is not finite");
  const double quarters = angle / (std::numbers::pi / 2), whole = std::round(quarters);
  if (std::abs(quarters - whole) > 1e-12 * std::max(1.0, std::abs(whole))) return std::nullopt;
  return static_cast<int>(std::fmod(whole, 4));
}

}  // namespace

// z'(p) = z(R(-90°) p): x' = -y, y' = x.
Field turned_quarters(const Field& z, int quarters) {
  switch ((quarters % 4 + 4) % 4) {
    case 1:
      return z.transpose().colwise().reverse();
    case 2:
      return z.reverse();
    case 3:
      return z.transpose().rowwise().reverse();
    default:
      return z;
  }
}

Grid turned_quarters(const Grid& grid, int quarters) {
  Grid out = grid;
  if (quarters % 2 == 0) return out;
  std::swap(out.shape.nx, out.shape.ny);
  std::swap(out.dx, out.dy);
  std::swap(out.periodic.x, out.periodic.y);
  return out;
}

// The box around the turned corners of the outer cells, in whole cells.
Grid rotated_grid(const Grid& grid, double angle) {
  if (const auto quarters = quarters_of(angle)) return turned_quarters(grid, *quarters);
  const double c = std::abs(std::cos(angle)), s = std::abs(std::sin(angle));
  auto cells = [](double length, double step) { return static_cast<Index>(std::ceil(length / step - 1e-9)); };
  Grid out = grid;
  out.shape = {cells(c * grid.size_x() + s * grid.size_y(), grid.dx),
               cells(s * grid.size_x() + c * grid.size_y(), grid.dy)};
  out.periodic = {};
  return out;
}

Field rotated(const Field& z, const Grid& grid, double angle, int threads) {
  if (const auto quarters = quarters_of(angle)) return turned_quarters(z, *quarters);
  const Grid turned = rotated_grid(grid, angle);
  const double c = std::cos(angle), s = std::sin(angle),
               middle_x = static_cast<double>(grid.shape.nx - 1) / 2,
               middle_y = static_cast<double>(grid.shape.ny - 1) / 2;
  Field out = Field::Constant(turned.shape.nx, turned.shape.ny, NAN);
  parallel_ranges(turned.shape.nx, threads, [&](Index begin, Index end, int) {
    Stencil along_x(grid.shape.nx, grid.periodic.x), along_y(grid.shape.ny, grid.periodic.y);
    for (Index i = begin; i < end; ++i)
      for (Index j = 0; j < turned.shape.ny; ++j) {
        const double x = turned.x(i), y = turned.y(j);
        if (!along_x.place(near_integer((c * x + s * y) / grid.dx + middle_x))) continue;
        if (!along_y.place(near_integer((c * y - s * x) / grid.dy + middle_y))) continue;
        out(i, j) = 0;
        for (Index a = 0; a < along_x.count(); ++a) {
          double row = 0;
          for (Index b = 0; b < along_y.count(); ++b)
            row += along_y.weight(b) * z(along_x.at(a), along_y.at(b));
          out(i, j) += along_x.weight(a) * row;
        }
      }
  });
  return out;
}

Field mirrored(const Field& z, Axis1D axis) {
  return axis == Axis1D::x ? Field(z.colwise().reverse()) : Field(z.rowwise().reverse());
}

}  // namespace asperity
