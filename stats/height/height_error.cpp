#include "stats/height/height_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {
namespace {

// Columns of LocalSums, less the first: means of functions of x = (z - mean)/Sq.
enum Local { first, second, third, fourth, absolute, sign, local };

Moments moments_of(const Eigen::VectorXd& m) {
  const double x = m(first), square = m(second) - x * x, sq = std::sqrt(square);
  Moments out;
  out.mean = x;
  out.sq = sq;
  out.sa = m(absolute) - m(sign) * x;  // its slope: that of the mean of |x - x̄|
  out.ssk = (m(third) - 3 * x * m(second) + 2 * x * x * x) / (square * sq);
  out.sku = (m(fourth) - 4 * x * m(third) + 6 * x * x * m(second) - 3 * x * x * x * x) / (square * square);
  return out;
}

}  // namespace

HeightErrors::HeightErrors(const Grid& grid, double mean, double sq)
    : mean_(mean), sq_(sq), sums_(grid, local) {}

void HeightErrors::add(const Field& rows, int threads) {
  sums_.add_rows(rows.rows(), threads, [&](Index i, LocalSums::Values& values) {
    const Eigen::ArrayXd x = (rows.row(i).transpose() - mean_) / sq_, square = x.square();
    auto set = [&](Local a, const auto& value) { values.col(a + 1) = value.matrix(); };
    set(first, x), set(second, square), set(third, square * x), set(fourth, square.square());
    set(absolute, x.abs()), set(sign, x.sign());
  });
}

double HeightErrors::operator()(const Function& parameter) const {
  return means_.error([&](const Eigen::VectorXd& means) {
    Moments m = moments_of(means);
    m.mean = mean_ + sq_ * m.mean, m.sq *= sq_, m.sa *= sq_;
    return parameter(m);
  });
}

QuantileErrors::QuantileErrors(const Grid& grid, const FieldExtent& extent, std::vector<double> heights)
    : heights_(std::move(heights)),
      ascending_(heights_),
      errors_(grid, extent, static_cast<Index>(heights_.size()) + 1) {
  std::ranges::sort(ascending_);
}

// Class k holds heights up to the k-th and above the one before.
void QuantileErrors::add(const Field& rows, int) {
  errors_.add(rows,
              [this](double z) { return std::ranges::lower_bound(ascending_, z) - ascending_.begin(); });
}

double QuantileErrors::left_by_mean() const {
  const ShareErrors::Function none(errors_);
  return asperity::left_by_mean(none.error(1), errors_.rms());
}

double QuantileErrors::with_mean(std::size_t k, double density) const {
  ShareErrors::Function below(errors_);
  below.add(std::ranges::lower_bound(ascending_, heights_[k]) - ascending_.begin(), 1);
  return below.error(density);
}

}  // namespace asperity
