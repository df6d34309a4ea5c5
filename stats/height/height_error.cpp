#include "stats/height/height_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stats/filter/form.hpp"

namespace asperity {
namespace {

// Columns of LocalSums, less the first: means of functions of x = (z - mean)/Sq.
enum Local { first, second, third, fourth, absolute, sign, local };

constexpr double least_share = 1e-10;  // of the points' largest λ: modes that are hardly there

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

HeightErrors::HeightErrors(const Field& z, const Grid& grid, const FieldExtent& extent,
                           const Moments& moments, int degree, int threads)
    : mean_(moments.mean), sq_(moments.sq), degree_(degree), patches_(extent.patches) {
  LocalSums sums(grid, local);
  sums.add_rows(z.rows(), threads, [&](Index i, LocalSums::Values& values) {
    const Eigen::ArrayXd x = (z.row(i).transpose() - mean_) / sq_, square = x.square();
    auto set = [&](Local a, const auto& value) { values.col(a + 1) = value.matrix(); };
    set(first, x), set(second, square), set(third, square * x), set(fourth, square.square());
    set(absolute, x.abs()), set(sign, x.sign());
  });
  means_ = sums.means(extent);
  if (degree > 0) find_power((z - mean_) / sq_, sums.count());
}

// The heights lack the modes of the form, so that their power is that of the others.
void HeightErrors::find_power(const Field& x, double points) {
  const AxisProducts products = polynomials(shape_of(x), degree_ + 2);  // P_a P_b, a + b ≤ d + 2
  Eigen::MatrixXd gram = products.none();
  products.add(gram, validity(x));
  const Eigen::MatrixXd modes = orthonormal(gram, least_share);
  taken_ = std::ranges::count_if(products.terms(), [&](const auto& t) { return t.a + t.b <= degree_; });
  next_ = std::max<Index>(0, modes.rows() - taken_);
  if (next_ == 0) return;  // of so narrow an outline
  power_ = (modes * products.sums(zero_filled(x))).squaredNorm() / (static_cast<double>(next_) * points);
}

WaveError HeightErrors::of_mean() const {
  if (degree_ == 0) return (*this)([](const Moments& of) { return of.mean; });
  return {sq_ * std::sqrt(power_) / (1 - loss(1.2 + degree_)), static_cast<double>(next_)};
}

double HeightErrors::taken() const {
  if (degree_ == 0) return std::min(0.5, std::pow(of_mean().error / sq_, 2));
  const double b = static_cast<double>(taken_) * power_ / std::pow(1 - loss(1.2 + 0.35 * degree_), 2);
  return std::isnan(b) ? b : std::min(0.5, b / (1 + b));
}

double HeightErrors::error_of_taken() const { return taken() * std::sqrt(2 / of_mean().degrees); }

double HeightErrors::loss(double factor) const { return std::min(0.4, factor / std::sqrt(patches_)); }

WaveError HeightErrors::operator()(const Function& parameter) const {
  return means_.error([&](const Eigen::VectorXd& means) {
    Moments m = moments_of(means);
    m.mean = mean_ + sq_ * m.mean, m.sq *= sq_, m.sa *= sq_;
    return parameter(m);
  });
}

QuantileErrors::QuantileErrors(const Field& z, const Grid& grid, const FieldExtent& extent,
                               std::vector<double> heights)
    : heights_(std::move(heights)),
      ascending_(heights_),
      errors_(grid, extent, static_cast<Index>(heights_.size()) + 1) {
  std::ranges::sort(ascending_);
  // Class k holds heights up to the k-th and above the one before.
  errors_.add(
      z, [this](double height) { return std::ranges::lower_bound(ascending_, height) - ascending_.begin(); });
  errors_.accumulate();
}

WaveError QuantileErrors::with_mean(std::size_t k, double density) const {
  ShareErrors::Function below(errors_);
  below.add(std::ranges::lower_bound(ascending_, heights_[k]) - ascending_.begin(), 1);
  return below.error(density);
}

}  // namespace asperity
