#include "transform/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "core/parallel.hpp"

namespace asperity {
namespace {

// `count` values a step apart, in points, about the middle of the axis.
struct Axis {
  Index points, count;
  double step;
  bool periodic;

  // Whether the values fill the axis: theirs is then a transform too.
  bool whole() const { return std::abs(excess()) <= 1e-12 * static_cast<double>(points); }
  // Of the first value, in points from the first.
  double first() const { return ((whole() ? 0 : excess()) + step - 1) / 2; }
  double at(Index m) const { return first() + static_cast<double>(m) * step; }
  bool same() const { return count == points && whole(); }

 private:
  double excess() const { return static_cast<double>(points) - static_cast<double>(count) * step; }
};

std::array<Axis, 2> axes_of(const Grid& grid, const Grid& target) {
  return {Axis{grid.shape.nx, target.shape.nx, target.dx / grid.dx, grid.periodic.x},
          Axis{grid.shape.ny, target.shape.ny, target.dy / grid.dy, grid.periodic.y}};
}

// ---- the form of degree 2 ----

// The first three polynomials that are orthogonal over equidistant points; u in points from their middle.
class Polynomials {
 public:
  explicit Polynomials(Index points) : middle_(static_cast<double>(points - 1) / 2) {
    const double n = static_cast<double>(points);
    variance_ = (n * n - 1) / 12;
    for (Index i = 0; i < points; ++i)
      for (int degree = 0; degree < 3; ++degree)
        squares_[size(degree)] += std::pow(at(degree, static_cast<double>(i)), 2);
  }

  double at(int degree, double x) const {
    const double u = x - middle_;
    return degree == 0 ? 1 : degree == 1 ? u : u * u - variance_;
  }
  // Of the points' own sum of squares; of one or two points those of higher degrees vanish.
  double square(int degree) const { return squares_[size(degree)]; }

 private:
  double middle_, variance_;
  std::array<double, 3> squares_{};
};

// Σ c(a,b) P_a(x) P_b(y), a + b ≤ 2, of least squares; of degree 0 along a period.
class Form {
 public:
  Form(const Field& z, const std::array<Axis, 2>& axes) : x_(z.rows()), y_(z.cols()) {
    for (int a = 0; a <= (axes[0].periodic ? 0 : 2); ++a)
      for (int b = 0; b <= (axes[1].periodic ? 0 : 2 - a); ++b) {
        const double norm = x_.square(a) * y_.square(b);
        if (norm > 0) terms_.push_back({a, b, projection(z, a, b) / norm});
      }
  }

  // Adds it `times` to a field of so many values a point.
  void add(Field& z, const std::array<Axis, 2>& axes, double times) const {
    for (const auto& [a, b, c] : terms_) {
      const Eigen::ArrayXd along_x = values(x_, a, z.rows(), axes[0]),
                           along_y = values(y_, b, z.cols(), axes[1]);
      for (Index i = 0; i < z.rows(); ++i) z.row(i) += (times * c * along_x(i)) * along_y.transpose();
    }
  }

 private:
  struct Term {
    int a, b;
    double coefficient;
  };

  static Eigen::ArrayXd values(const Polynomials& p, int degree, Index count, const Axis& axis) {
    return Eigen::ArrayXd::NullaryExpr(count, [&](Index m) { return p.at(degree, axis.at(m)); });
  }
  double projection(const Field& z, int a, int b) const {
    const Eigen::ArrayXd along_y = values(y_, b, z.cols(), Axis{z.cols(), z.cols(), 1, false});
    double sum = 0;
    for (Index i = 0; i < z.rows(); ++i)
      sum += x_.at(a, static_cast<double>(i)) * (z.row(i).transpose() * along_y).sum();
    return sum;
  }

  Polynomials x_, y_;
  std::vector<Term> terms_;
};

// ---- the waves ----

// The waves of sequences at other points, one sequence at a time. Where these are further apart than the
// sequence's own, waves of less than two of them are left out.
class AxisWaves {
 public:
  explicit AxisWaves(const Axis& axis)
      : axis_(axis),
        period_(axis.periodic ? axis.points : 2 * axis.points),
        terms_(period_ / 2 + 1),
        coarse_({1, period_}),
        given_(size(period_)),
        spectrum_(size(coarse_.spectrum_size())) {
    const double longest = static_cast<double>(period_);
    if (axis.step > 1)
      terms_ = std::min(terms_, static_cast<Index>(std::ceil(longest / (2 * axis.step) - 1e-9)));
    if (axis.whole())
      fine_.emplace(Shape{1, period_ / axis.points * axis.count});
    else
      chirp_.emplace(terms_, axis.count, turn() * axis.step);
    found_.resize(size(axis.whole() ? fine_->shape().ny : axis.count));
    if (axis.whole()) padded_.resize(size(fine_->spectrum_size()));
  }

  double* given() { return given_.data(); }              // the sequence
  const double* found() const { return found_.data(); }  // and what apply() makes of it

  void apply() {
    if (!axis_.periodic)
      std::reverse_copy(given_.begin(), given_.begin() + axis_.points, given_.begin() + axis_.points);
    coarse_.forward(given_.data(), spectrum_.data());
    if (fine_)
      by_transform();
    else
      by_chirp();
  }

 private:
  double turn() const { return 2 * std::numbers::pi / static_cast<double>(period_); }
  // The k-th term of (1), turned to the first point.
  Complex term(Index k) const {
    return spectrum_[size(k)] *
           std::polar(1 / static_cast<double>(period_), turn() * axis_.first() * static_cast<double>(k));
  }
  void by_transform() {
    std::ranges::fill(padded_, 0);
    for (Index k = 0; k < terms_; ++k) padded_[size(k)] = term(k);
    if (2 * (terms_ - 1) == period_ && axis_.step < 1)
      padded_[size(terms_ - 1)] /= 2;  // it is there at -n/2 too
    fine_->inverse(padded_.data(), found_.data());
  }
  void by_chirp() {
    for (Index k = 0; k < terms_; ++k)
      chirp_->terms()[k] = (k == 0 || 2 * k == period_ ? 1.0 : 2.0) * term(k);
    const Complex* sums = chirp_->apply();
    for (Index m = 0; m < axis_.count; ++m) found_[size(m)] = sums[m].real();
  }

  Axis axis_;
  Index period_, terms_;
  RealTransform2D coarse_;
  std::optional<RealTransform2D> fine_;
  std::optional<ChirpTransform> chirp_;
  AlignedVector<double> given_, found_;
  AlignedVector<Complex> spectrum_, padded_;
};

Field resampled_rows(const Field& z, const Axis& axis, int threads) {
  if (axis.same()) return z;
  Field out(z.rows(), axis.count);
  parallel_ranges(z.rows(), threads, [&](Index begin, Index end, int) {
    AxisWaves waves(axis);
    for (Index i = begin; i < end; ++i) {
      std::copy_n(&z(i, 0), z.cols(), waves.given());
      waves.apply();
      std::copy_n(waves.found(), out.cols(), &out(i, 0));
    }
  });
  return out;
}

// Eight columns at a time, which share their lines of the cache.
Field resampled_columns(const Field& z, const Axis& axis, int threads) {
  if (axis.same()) return z;
  constexpr Index together = 8;
  Field out(axis.count, z.cols());
  parallel_ranges((z.cols() + together - 1) / together, threads, [&](Index begin, Index end, int) {
    AxisWaves waves(axis);
    for (Index first = begin * together; first < std::min(end * together, z.cols()); first += together) {
      const Index count = std::min(together, z.cols() - first);
      const Field columns = z.middleCols(first, count).transpose();
      Field found(count, out.rows());
      for (Index c = 0; c < count; ++c) {
        std::copy_n(&columns(c, 0), columns.cols(), waves.given());
        waves.apply();
        std::copy_n(waves.found(), found.cols(), &found(c, 0));
      }
      out.middleCols(first, count) = found.transpose();
    }
  });
  return out;
}

void check(Shape factor) {
  check_parameter(factor.nx >= 1 && factor.ny >= 1, "refine", text(factor) + ": at least 1x1");
}

}  // namespace

Grid refined_grid(const Grid& grid, Shape factor) {
  check(factor);
  Grid out = grid;
  out.shape = {grid.shape.nx * factor.nx, grid.shape.ny * factor.ny};
  out.dx /= static_cast<double>(factor.nx), out.dy /= static_cast<double>(factor.ny);
  return out;
}

double refinement_memory(const Grid& grid, Shape factor) {
  const Shape fine = refined_grid(grid, factor).shape;
  const double nx = static_cast<double>(grid.shape.nx), mx = static_cast<double>(fine.nx),
               my = static_cast<double>(fine.ny);
  return sizeof(double) *
         (mx * my + nx * my + nx * static_cast<double>(grid.shape.ny) + 8 * (mx + nx) + 12 * (mx + my));
}

Field refined(const Field& field, const Grid& grid, Shape factor, int threads) {
  return resampled_onto(field, grid, refined_grid(grid, factor), threads);
}

Field resampled_onto(const Field& field, const Grid& grid, const Grid& target, int threads) {
  if (!field.allFinite()) throw DataError("heights", "a point is missing or not finite: fill it first");
  const std::array<Axis, 2> axes = axes_of(grid, target);
  const Form form(field, axes);
  Field out = field;
  form.add(out, {Axis{field.rows(), field.rows(), 1, false}, Axis{field.cols(), field.cols(), 1, false}}, -1);
  out = resampled_columns(resampled_rows(out, axes[1], threads), axes[0], threads);
  form.add(out, axes, 1);
  return out;
}

// ---- waves at points of any spacing ----

ChirpTransform::ChirpTransform(Index terms, Index values, double theta)
    : terms_(terms),
      values_(values),
      theta_(theta),
      transform_(fast_length(terms + values - 1), 1),
      given_(size(transform_.size())),
      found_(given_.size()),
      symbol_(given_.size()),
      phase_(size(std::max(terms, values))) {
  const Index points = transform_.points();
  for (Index k = 0; k < std::ssize(phase_); ++k) phase_[size(k)] = chirp(k, 1);
  for (Index m = 0; m < values; ++m) given_[size(m)] = chirp(m, -1) / static_cast<double>(points);
  for (Index k = 1; k < terms; ++k) given_[size(points - k)] = chirp(k, -1) / static_cast<double>(points);
  transform_.forward(given_.data(), symbol_.data());
}

// exp(±iθk²/2).
Complex ChirpTransform::chirp(Index k, double sign) const {
  const double turns = theta_ / (4 * std::numbers::pi) * static_cast<double>(k * k);
  return std::polar(1.0, sign * 2 * std::numbers::pi * (turns - std::floor(turns)));
}

const Complex* ChirpTransform::apply() {
  for (Index k = 0; k < terms_; ++k) given_[size(k)] *= phase_[size(k)];
  std::fill(given_.begin() + terms_, given_.begin() + transform_.points(), Complex{});
  transform_.forward(given_.data(), found_.data());
  for (Index k = 0; k < transform_.points(); ++k) found_[size(k)] *= symbol_[size(k)];
  transform_.inverse(found_.data(), given_.data());
  for (Index m = 0; m < values_; ++m) given_[size(m)] *= phase_[size(m)];
  return given_.data();
}

}  // namespace asperity
