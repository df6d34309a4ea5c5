#include "stats/sample/proportions.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {

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
