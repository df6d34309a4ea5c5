#include "stats/height/kernel_density.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gsl/gsl_randist.h>

#include "core/error.hpp"
#include "math/hermite.hpp"
#include "stats/height/distribution.hpp"

namespace asperity {
namespace {

constexpr int terms = 14;
constexpr double cell_width = 0.5, reach = 9;  // in bandwidths; φ(9) is 1e-18

// (5): the moments of cells from `lowest` on.
class Cells {
 public:
  Cells(const Field& z, double lowest, double highest, double bandwidth)
      : lowest_(lowest),
        bandwidth_(bandwidth),
        moments_(static_cast<std::size_t>((highest - lowest) / (cell_width * bandwidth)) + 1) {
    for (const double height : z.reshaped<Eigen::RowMajor>())
      if (!std::isnan(height)) add(height);
    for (auto& m : moments_) {
      double root = 1;  // √k!
      for (int k = 0; k < terms; m[static_cast<std::size_t>(k)] /= root, root *= std::sqrt(++k)) {
      }
    }
  }

  double count() const { return count_; }
  /// Σ φ((t - z_i)/h).
  double sum(double t) const {
    const double place = (t - lowest_) / (cell_width * bandwidth_);
    const auto first = std::max(0.0, std::floor(place - reach / cell_width));
    double sum = 0;
    for (auto c = static_cast<std::size_t>(first);
         c < moments_.size() && static_cast<double>(c) <= place + reach / cell_width; ++c) {
      const double u = (t - centre(c)) / bandwidth_;
      HermiteFunction hermite(u, gsl_ran_ugaussian_pdf(u));
      for (const double m : moments_[c]) sum += m * hermite.next();
    }
    return sum;
  }

 private:
  double centre(std::size_t cell) const {
    return lowest_ + (static_cast<double>(cell) + 0.5) * cell_width * bandwidth_;
  }
  void add(double height) {
    const auto place = static_cast<std::size_t>((height - lowest_) / (cell_width * bandwidth_)),
               cell = std::min(place, moments_.size() - 1);
    auto& m = moments_[cell];
    const double d = (height - centre(cell)) / bandwidth_;
    double power = 1;
    for (double& sum : m) {
      sum += power;
      power *= d;
    }
    ++count_;
  }

  double lowest_, bandwidth_, count_ = 0;
  std::vector<std::array<double, terms>> moments_;
};

}  // namespace

double silverman_bandwidth(const Moments& moments, double points) {
  return std::pow(4 / (3 * points), 0.2) * moments.sq;
}

std::vector<DensityPoint> kernel_density(const Field& z, double bandwidth, int rows,
                                         std::optional<HeightRange> range) {
  if (!range) range = height_range(z);
  const double lowest = range->lowest, highest = range->highest;
  if (rows < 2) throw ParameterError("rows", "'" + std::to_string(rows) + "' is below 2");
  if (!(bandwidth > 0 && bandwidth >= least_bandwidth * (highest - lowest) && std::isfinite(bandwidth)))
    throw ParameterError("bandwidth", "is not finite or is below 1e-5 of the range of heights");
  const Cells cells(z, lowest, highest, bandwidth);
  std::vector<DensityPoint> out(static_cast<std::size_t>(rows));
  const double from = lowest - 3 * bandwidth, step = (highest - lowest + 6 * bandwidth) / (rows - 1);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double t = from + static_cast<double>(i) * step;
    out[i].height = t;
    out[i].density = cells.sum(t) / (cells.count() * bandwidth);
  }
  return out;
}

// In units of Sq.
void compare_with_gaussian(std::vector<DensityPoint>& curve, const Moments& moments,
                           const EffectiveSampleSize& size, double bandwidth) {
  for (DensityPoint& point : curve) {
    const double t = (point.height - moments.mean) / moments.sq, h = bandwidth / moments.sq;
    const double s = std::hypot(1, h), x = t / s, expected = gsl_ran_gaussian_pdf(t, s);
    const double square =
        gsl_ran_gaussian_pdf(t, std::sqrt(1 + h * h / 2)) * std::numbers::inv_sqrtpi / (2 * h);
    HermiteFunction hermite(x, gsl_ran_ugaussian_pdf(x));
    double power = 1 / s;
    hermite.next();
    auto weight = [&](int) {
      power /= s;
      return std::pow(hermite.next() * power, 2);
    };
    point.gaussian = expected / moments.sq;
    point.misfit_error = std::sqrt(misfit_variance(weight, square - expected * expected, size)) / moments.sq;
  }
}

void set_errors(std::vector<DensityPoint>& curve, const Field& z, const Grid& grid, const FieldExtent& extent,
                double bandwidth, double sq) {
  const auto [lowest, highest] = height_range(z);
  const auto cells = static_cast<Index>((highest - lowest) / (cell_width * bandwidth)) + 1;
  const HeightClasses classes(
      z, grid, extent, {lowest, lowest + static_cast<double>(cells) * cell_width * bandwidth, cells}, sq > 0);
  auto for_each_near = [&](double height, const auto& visit) {
    classes.range().for_each_near(height, reach * bandwidth, [&](Index b) {
      visit(b, gsl_ran_gaussian_pdf(height - classes.range().centre(b), bandwidth));
    });
  };
  std::vector<Frequency> densities;
  for (const DensityPoint& point : curve) {
    ShareErrors::Function kernel(classes.errors());
    for_each_near(point.height, [&](Index b, double value) { kernel.add(b, value); });
    const double heights = 2 * std::sqrt(std::numbers::pi) * bandwidth * point.density;
    densities.push_back(classes.frequency(kernel, heights * classes.errors().points(), [&](double delta) {
      double sum = 0;
      for_each_near(point.height + delta,
                    [&](Index b, double value) { sum += value * classes.errors().share(b); });
      return sum;
    }));
    densities.back().value = point.density;
  }
  set_intervals(densities, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < curve.size(); ++i) curve[i].frequency = densities[i];
}

}  // namespace asperity
