#include "stats/uncertainty/form_modes.hpp"

#include <algorithm>
#include <cmath>

#include "stats/filter/missing.hpp"
#include "transform/lag_sums.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

constexpr double round_off = 1e-12;

// α of (2); along a periodic axis the mean over both ways round.
Eigen::MatrixXd autocorrelations(Index n, bool periodic, int degree) {
  const Eigen::MatrixXd modes = gram_polynomials(n, degree);
  const RealTransform2D transform({1, fast_length(2 * n)});
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  AlignedVector<double> values(static_cast<std::size_t>(fast_length(2 * n)));
  Eigen::MatrixXd sums(n, modes.cols());
  for (Index a = 0; a < modes.cols(); ++a) {
    std::ranges::fill(values, 0.0);
    std::ranges::copy(modes.col(a), values.begin());
    transform.forward(values.data(), spectrum.data());
    for (Complex& c : spectrum) c = std::norm(c) / static_cast<double>(values.size());
    transform.inverse(spectrum.data(), values.data());
    std::copy_n(values.begin(), n, sums.col(a).begin());
  }
  if (!periodic) {
    const Eigen::ArrayXd pairs = Eigen::ArrayXd::LinSpaced(n, static_cast<double>(n), 1);
    return (sums.array().colwise() * (static_cast<double>(n) / pairs)).matrix();
  }
  Eigen::MatrixXd out = sums;
  out.bottomRows(n - 1) += sums.bottomRows(n - 1).colwise().reverse();
  return out;
}

}  // namespace

FormModes::FormModes(const Grid& grid, int degree) : degree_(degree) {
  if (degree == 0) return;
  along_x_ = autocorrelations(grid.shape.nx, grid.periodic.both(), degree);
  const Eigen::MatrixXd of_y = autocorrelations(grid.shape.ny, grid.periodic.both(), degree);
  along_y_.resize(of_y.rows(), along_x_.cols());
  count_ = 0;
  for (Index a = 0; a < along_x_.cols(); ++a) {
    const Index terms = std::min<Index>(degree - a + 1, of_y.cols());
    along_y_.col(a) = of_y.leftCols(terms).rowwise().sum();
    count_ += static_cast<double>(terms);
  }
}

FormModes::FormModes(const Field& z, const Pairs& pairs, int degree, int threads)
    : FormModes(pairs.grid(), degree) {
  if (degree == 0 || pairs.complete()) return;
  const AxisProducts products = polynomials(shape_of(z), degree);
  Eigen::MatrixXd gram = products.none();
  const Field points = validity(z);
  products.add(gram, points);
  const Eigen::MatrixXd modes = orthonormal(gram, round_off);
  const Shape lags = longest_lags(pairs.grid());
  Field sums = Field::Zero(lags.nx + 1, 2 * lags.ny + 1);
  for (Index k = 0; k < modes.rows(); ++k)
    sums += lag_sums(points * products.combined(modes.row(k).transpose()), pairs.grid(), lags, threads);
  of_points_ = std::make_shared<const LagField>(LagField::of(lags, [&](Index p, Index q) {
    const double share = pairs.pair_fraction(p, q);
    return share > 0 ? sums(p, lags.ny + q) / (count_ * share) : 0;
  }));
}

double FormModes::operator()(Index p, Index q) const {
  if (of_points_) {
    const double b = (*of_points_)(p, q);
    return std::isnan(b) ? 0 : b;
  }
  return degree_ == 0 ? 1 : along_x_.row(p).dot(along_y_.row(std::abs(q))) / count_;
}

}  // namespace asperity
