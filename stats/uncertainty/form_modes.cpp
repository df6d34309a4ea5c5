#include "stats/uncertainty/form_modes.hpp"

#include <algorithm>

#include "stats/filter/form.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

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
  along_x_ = autocorrelations(grid.shape.nx, grid.periodic.x, degree);
  along_y_ = autocorrelations(grid.shape.ny, grid.periodic.y, degree);
  count_ = 0;
  for (Index a = 0; a < along_x_.cols(); ++a)
    count_ += static_cast<double>(std::min<Index>(degree - a + 1, along_y_.cols()));
}

LagField FormModes::correlation(Shape max_lag) const {
  if (degree_ == 0) return LagField(Field::Ones(max_lag.nx + 1, 2 * max_lag.ny + 1));
  Eigen::MatrixXd of_y(along_x_.cols(), 2 * max_lag.ny + 1);  // Σ_b α_b over b ≤ d - a, a row an a
  for (Index a = 0; a < of_y.rows(); ++a) {
    const Index terms = std::min<Index>(degree_ - a + 1, along_y_.cols());
    for (Index q = 0; q <= max_lag.ny; ++q)
      of_y(a, max_lag.ny + q) = of_y(a, max_lag.ny - q) = along_y_.row(q).head(terms).sum();
  }
  return LagField((along_x_.topRows(max_lag.nx + 1) * of_y / count_).array());
}

}  // namespace asperity
