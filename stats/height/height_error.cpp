#include "stats/height/height_error.hpp"

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

QuantileErrors::QuantileErrors(const Grid& grid, std::vector<double> heights)
    : heights_(std::move(heights)), sums_(grid, static_cast<Index>(heights_.size()) + 1) {}

void QuantileErrors::add(const Field& rows, int threads) {
  sums_.add_rows(rows.rows(), threads, [&](Index i, LocalSums::Values& values) {
    const Eigen::ArrayXd z = rows.row(i).transpose();
    for (std::size_t k = 0; k < heights_.size(); ++k)
      values.col(static_cast<Index>(k) + 1) = (z <= heights_[k]).cast<double>().matrix();
    values.col(values.cols() - 1) = z.matrix();
  });
}

double QuantileErrors::operator()(std::size_t k) const {
  return means_.error([k](const Eigen::VectorXd& m) { return m(static_cast<Index>(k)); });
}

double QuantileErrors::with_mean(std::size_t k, double density) const {
  return means_.error(
      [=](const Eigen::VectorXd& m) { return m(static_cast<Index>(k)) + density * m(m.size() - 1); });
}

}  // namespace asperity
