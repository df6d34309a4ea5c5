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

HeightErrors::HeightErrors(const Grid& grid, double mean, double sq, int degree)
    : mean_(mean), sq_(sq), degree_(degree), sums_(grid, local) {
  if (degree == 0) return;
  products_ = polynomials(grid.shape, degree + 2);
  gram_ = products_.none();
}

void HeightErrors::add(const Field& z, int threads) {
  if (degree_ > 0) {
    modes_ = products_.sums(zero_filled((z - mean_) / sq_));
    products_.add(gram_, validity(z));
  }
  const auto fill = [&](Index i, LocalSums::Values& values) {
    const Eigen::ArrayXd x = (z.row(i).transpose() - mean_) / sq_, square = x.square();
    auto set = [&](Local a, const auto& value) { values.col(a + 1) = value.matrix(); };
    set(first, x), set(second, square), set(third, square * x), set(fourth, square.square());
    set(absolute, x.abs()), set(sign, x.sign());
  };
  sums_.add_rows(z.rows(), threads, fill);
}

// The heights lack the modes of the form, so that their power is that of the others.
void HeightErrors::finish(const FieldExtent& extent) {
  means_ = sums_.means(extent);
  patches_ = extent.patches;
  if (degree_ == 0) return;
  const Eigen::MatrixXd modes = orthonormal(gram_, least_share);
  taken_ = std::ranges::count_if(products_.terms(), [&](const auto& t) { return t.a + t.b <= degree_; });
  next_ = modes.rows() - taken_;
  if (next_ < 1) {  // of so narrow an outline
    next_ = 0, power_ = NAN;
    return;
  }
  power_ = (modes * modes_).squaredNorm() / (static_cast<double>(next_) * sums_.count());
}

double HeightErrors::degrees_of_mean() const { return degree_ == 0 ? degrees() : static_cast<double>(next_); }

double HeightErrors::of_mean() const {
  if (degree_ == 0) return (*this)([](const Moments& of) { return of.mean; });
  return sq_ * std::sqrt(power_) / (1 - loss(1.2 + degree_));
}

double HeightErrors::taken() const {
  if (degree_ == 0) return std::min(0.5, std::pow(of_mean() / sq_, 2));
  const double b = static_cast<double>(taken_) * power_ / std::pow(1 - loss(1.2 + 0.35 * degree_), 2);
  return std::isnan(b) ? b : std::min(0.5, b / (1 + b));
}

double HeightErrors::loss(double factor) const { return std::min(0.4, factor / std::sqrt(patches_)); }

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
void QuantileErrors::add(const Field& z) {
  errors_.add(
      z, [this](double height) { return std::ranges::lower_bound(ascending_, height) - ascending_.begin(); });
}

double QuantileErrors::with_mean(std::size_t k, double density) const {
  ShareErrors::Function below(errors_);
  below.add(std::ranges::lower_bound(ascending_, heights_[k]) - ascending_.begin(), 1);
  return below.error(density);
}

}  // namespace asperity
