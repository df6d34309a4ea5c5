#include "stats/spectrum/shared_power.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stats/filter/missing.hpp"

namespace asperity {
namespace {

using LagNumbers = Eigen::Array<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double negligible = 1e-12;  // that r of a field without a window holds

// Distances up to `reach` along an axis of n points, each wave number once.
std::vector<Index> distances(Index n) {
  std::vector<Index> out{0};
  for (Index d = 1; d <= SharedPower::reach; ++d) {
    if (2 * d <= n) out.push_back(d);
    if (2 * d < n) out.push_back(-d);
  }
  return out;
}

// Columns w² exp(-2πi d k/n), k the point, one a distance.
Eigen::MatrixXcd waves(const Eigen::ArrayXd& squares, const std::vector<Index>& distances) {
  const auto n = static_cast<double>(squares.size());
  return Eigen::MatrixXcd::NullaryExpr(
      squares.size(), static_cast<Index>(distances.size()), [&](Index i, Index column) {
        const auto d = static_cast<double>(distances[static_cast<std::size_t>(column)]);
        return std::polar(squares(i), -2 * std::numbers::pi * d * static_cast<double>(i) / n);
      });
}

Eigen::MatrixXcd sums(const Field& d, const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& y) {
  if (!has_missing(d)) return x.colwise().sum().transpose() * y.colwise().sum();
  const Field valid = validity(d);
  Eigen::MatrixXcd along_y(d.rows(), y.cols());
  along_y.real() = valid.matrix() * y.real();
  along_y.imag() = valid.matrix() * y.imag();
  return x.transpose() * along_y;
}

}  // namespace

SharedPower::SharedPower(const Field& d, const Eigen::ArrayXd& squares_x, const Eigen::ArrayXd& squares_y)
    : shape_(shape_of(d)) {
  const std::vector<Index> along_x = distances(shape_.nx), along_y = distances(shape_.ny);
  const Eigen::MatrixXcd all = sums(d, waves(squares_x, along_x), waves(squares_y, along_y));
  for (Index a = 0; a < all.rows(); ++a)
    for (Index b = 0; b < all.cols(); ++b)
      if (const double r = std::norm(all(a, b)) / std::norm(all(0, 0)); r > negligible)
        neighbours_.push_back(
            {along_x[static_cast<std::size_t>(a)], along_y[static_cast<std::size_t>(b)], r});
}

double SharedPower::operator()(Index p, Index q) const {
  p = within_x(p), q = within_y(q);
  if (std::max(std::abs(p), std::abs(q)) > reach) return 0;
  for (const auto& [dp, dq, r] : neighbours_)
    if (dp == p && dq == q) return r;
  return 0;
}

double SharedPower::overlap() const {
  double sum = 0;
  for (const Neighbour& n : neighbours_) sum += n.r;
  return sum;
}

std::vector<MeanPower> SharedPower::means(const LagField& psd, Index sets,
                                          const std::function<Index(Index, Index)>& set) const {
  const auto [nx, ny] = shape_;
  const Index Q = psd.max_q();
  const LagNumbers set_of = LagNumbers::NullaryExpr(psd.max_p() + 1, 2 * Q + 1, [&](Index p, Index column) {
    return static_cast<int>(set(p, column - Q));
  });
  std::vector<MeanPower> out(static_cast<std::size_t>(sets));
  std::vector<double> flat(out.size());
  for (Index p = 0; p <= psd.max_p(); ++p)
    for (Index q = within_y(ny / 2 + 1); q <= ny / 2; ++q) {
      const int own = set_of(p, Q + q);
      if (own < 0) continue;
      const bool near_mirror = std::abs(within_x(2 * p)) <= reach && std::abs(within_y(2 * q)) <= reach;
      double power = 0, r_of_set = 0;
      for (const auto& [dp, dq, r] : neighbours_) {
        Index k = within_x(p + dp), l = within_y(q + dq);
        const double mirror = near_mirror ? (*this)(p + k, q + l) : 0;
        if (k < 0) k = -k, l = -l;
        if (set_of(k, Q + l) != own) continue;
        power += psd(k, l) * r / (1 + r + mirror);
        r_of_set += r;
      }
      const double weight = p == 0 || 2 * p == nx ? 1 : 2;  // of p and -p
      const auto s = static_cast<std::size_t>(own);
      out[s].count += weight;
      out[s].mean += weight * psd(p, q);
      out[s].variance += weight * psd(p, q) * power;
      flat[s] += weight * r_of_set;
    }
  for (std::size_t s = 0; s < out.size(); ++s) {
    auto& [mean, variance, degrees, n] = out[s];
    mean /= n;
    variance *= 2 / (n * n);
    degrees = std::min(2 * mean * mean / variance - 2, n * n / flat[s]);
  }
  return out;
}

}  // namespace asperity
