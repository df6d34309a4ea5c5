#include "stats/sample/moments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/form.hpp"

namespace asperity {
namespace {

struct Sums {
  double count = 0, absolute = 0, second = 0, third = 0, fourth = 0;
  double highest = -std::numeric_limits<double>::infinity(), lowest = std::numeric_limits<double>::infinity();

  void operator+=(const Sums& other) {
    count += other.count;
    absolute += other.absolute;
    second += other.second;
    third += other.third;
    fourth += other.fourth;
    highest = std::max(highest, other.highest);
    lowest = std::min(lowest, other.lowest);
  }
};

Sums sums_of(const Field& z, const Mean& mean) {
  Sums sums;
  Eigen::ArrayXd row(z.cols()), square;
  for (Index i = 0; i < z.rows(); ++i) {
    row = (z.row(i).transpose() - mean.base) - mean.above;
    Index there = row.size();
    if (std::isnan(row.sum()))
      there = std::remove_if(row.begin(), row.end(), [](double height) { return std::isnan(height); }) -
              row.begin();
    const auto d = row.head(there);
    if (d.size() == 0) continue;
    square = d.square();
    sums += {static_cast<double>(d.size()), d.abs().sum(), square.sum(), (square * d).sum(),
             square.square().sum(),         d.maxCoeff(),  d.minCoeff()};
  }
  return sums;
}

}  // namespace

Moments moments(const Field& z, std::string_view variable) {
  const Mean mean = mean_above_base(z);
  const Sums sums = sums_of(z, mean);
  const double n = sums.count, variance = sums.second / n, fourth = sums.fourth / n;
  if (sums.highest == sums.lowest && std::isfinite(sums.highest))
    throw DataError(std::string(variable), "every value is the same: skewness and kurtosis are undefined");
  if (!(variance * variance >= std::numeric_limits<double>::min() && std::isfinite(fourth)))
    throw DataError(std::string(variable),
                    "heights up to " + shortest(std::max(sums.highest, -sums.lowest)) +
                        " from the mean: infinite, or with fourth powers beyond the range of a double; give "
                        "them in another unit");
  return {.mean = mean.value(),
          .sa = sums.absolute / n,
          .sq = std::sqrt(variance),
          .ssk = sums.third / n / (variance * std::sqrt(variance)),
          .sku = fourth / (variance * variance),
          .sp = sums.highest,
          .sv = -sums.lowest};
}

// ---- heights at first sight ----

void Proportions::Steps::add(double step) {
  if (std::isnan(step)) return;
  squares += step * step;
  ++count;
}

double Proportions::Steps::slope(double spacing) const {
  return count > 0 ? squares / count / (spacing * spacing) : 0;
}

void Proportions::add(const Eigen::Ref<const Field>& rows) {
  const auto [nx, ny] = grid_.shape;
  for (Index i = 0; i < rows.rows(); ++i, ++row_) {
    const double x = static_cast<double>(2 * row_ + 1 - nx) / 2;
    const double* row = rows.data() + i * rows.outerStride();
    double count = 0, y_sum = 0, yy = 0, z_sum = 0, yz = 0;
    for (Index j = 0; j < ny; ++j) {
      const double y = static_cast<double>(2 * j + 1 - ny) / 2;
      if (std::isnan(base_)) base_ = row[j];
      const double z = row[j] - base_;
      if (row_ > 0) along_x_.add(row[j] - before_[size(j)]);
      if (j > 0) along_y_.add(row[j] - row[j - 1]);
      if (std::isnan(z)) continue;
      ++count, y_sum += y, yy += y * y, z_sum += z, yz += y * z, zz_ += z * z;
    }
    count_ += count, x_ += x * count, y_ += y_sum, z_ += z_sum;
    xx_ += x * x * count, xy_ += x * y_sum, yy_ += yy, xz_ += x * z_sum, yz_ += yz;
    before_.assign(row, row + ny);
  }
}

double Proportions::covariance(double product, double one, double other) const {
  return count_ > 0 ? product / count_ - one / count_ * (other / count_) : 0;
}

double Proportions::sq() const { return std::sqrt(std::max(0.0, covariance(zz_, z_, z_))); }

double Proportions::rms_slope() const {
  return std::sqrt(along_x_.slope(grid_.dx) + along_y_.slope(grid_.dy));
}

// Of points on one line, the plane is one along an axis.
double Proportions::plane_share() const {
  const double xx = covariance(xx_, x_, x_), xy = covariance(xy_, x_, y_), yy = covariance(yy_, y_, y_),
               xz = covariance(xz_, x_, z_), yz = covariance(yz_, y_, z_), zz = covariance(zz_, z_, z_);
  if (!(zz > 0)) return 0;
  const double area = xx * yy - xy * xy;
  if (area > 1e-9 * xx * yy) return (xz * xz * yy - 2 * xz * yz * xy + yz * yz * xx) / (area * zz);
  return std::max(xx > 0 ? xz * xz / xx : 0, yy > 0 ? yz * yz / yy : 0) / zz;
}

}  // namespace asperity
