#include "stats/profile/profile.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/feature/hills.hpp"
#include "stats/filter/missing.hpp"
#include "stats/height/material_ratio.hpp"

namespace asperity {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// (1) of heights above their mean.
void add_moments(ProfileParameters& out, const Eigen::ArrayXd& z) {
  const ValidSum square = sum_of_valid(z.square());
  const double n = square.count, q = std::sqrt(square.sum / n);
  out[profile_a] = sum_of_valid(z.abs()).sum / n;
  out[profile_q] = q;
  if (!(q > 0)) return;
  out[profile_sk] = sum_of_valid(z.cube()).sum / (n * q * q * q);
  out[profile_ku] = sum_of_valid(z.square().square()).sum / (n * q * q * q * q);
}

// Peaks and valleys of whole sections, each of which may lack some of its points, not all.
void add_extremes(ProfileParameters& out, const Eigen::ArrayXd& z, double points_in_section) {
  const double n = static_cast<double>(z.size());
  const auto sections = static_cast<Index>(std::max(1.0, n / points_in_section * (1 + 1e-12)));
  double peaks = 0, valleys = 0, count = 0;
  for (Index s = 0; s < sections; ++s) {
    auto edge = [&](Index k) {
      return std::min(z.size(), static_cast<Index>(
                                    std::llround(static_cast<double>(k) * std::min(points_in_section, n))));
    };
    const auto heights = z.segment(edge(s), edge(s + 1) - edge(s));
    if (heights.isNaN().all()) continue;
    peaks += heights.maxCoeff<Eigen::PropagateNumbers>();
    valleys -= heights.minCoeff<Eigen::PropagateNumbers>();
    ++count;
  }
  out[profile_p] = peaks / count;
  out[profile_v] = valleys / count;
  out[profile_z] = out[profile_p] + out[profile_v];
  out[profile_t] = z.maxCoeff<Eigen::PropagateNumbers>() - z.minCoeff<Eigen::PropagateNumbers>();
}

// (2).
double rms_slope(const Eigen::ArrayXd& z, double step, bool periodic) {
  if (periodic) {
    const Index margin = std::min<Index>(3, z.size());
    Eigen::ArrayXd around(z.size() + 2 * margin);
    around << z.tail(margin), z, z.head(margin);
    return rms_slope(around, step, false);
  }
  const Index n = z.size() - 6;
  if (n < 1) return none;
  auto at = [&](Index shift) { return z.segment(3 + shift, n); };
  const Eigen::ArrayXd slope = (at(3) - at(-3) - 9 * (at(2) - at(-2)) + 45 * (at(1) - at(-1))) / (60 * step);
  const ValidSum square = sum_of_valid(slope.square());
  return square.count > 0 ? std::sqrt(square.sum / square.count) : none;
}

// Walks along a profile and sums the lengths of its elements, in samples, and their heights.
class Elements {
 public:
  explicit Elements(double threshold) : threshold_(threshold) {}

  void add(double sample, double height) {
    if (std::isnan(height)) {
      *this = Elements(threshold_, lengths_, heights_, count_);
      return;
    }
    if (before_ * height < 0 || (height == 0 && before_ != 0)) cross(sample - height / (height - before_));
    if (std::abs(height) > threshold_) reach(height > 0 ? 1 : -1, std::abs(height));
    before_ = height;
  }
  double mean_length() const { return count_ > 0 ? lengths_ / count_ : none; }
  double mean_height() const { return count_ > 0 ? heights_ / count_ : none; }

 private:
  Elements(double threshold, double lengths, double heights, double count)
      : threshold_(threshold), lengths_(lengths), heights_(heights), count_(count) {}

  void cross(double at) {
    if (std::isnan(first_)) first_ = at;
    last_ = at;
  }
  // A hill (side 1) or a dale (-1): if it is not the one that was, the crossings since then end an element.
  void reach(int side, double far) {
    if (side_ != 0 && side != side_) {
      double& former = end_[side > 0 ? 1 : 0];
      const double end = 0.5 * (first_ + last_);
      if (!std::isnan(former)) lengths_ += end - former, heights_ += far_[0] + far_[1], ++count_;
      former = end;
    }
    double& own = far_[side > 0 ? 1 : 0];
    own = side == side_ ? std::max(own, far) : far;
    side_ = side;
    first_ = none;
  }

  double threshold_, lengths_ = 0, heights_ = 0, count_ = 0;
  double before_ = 0, first_ = none, last_ = none;
  double end_[2] = {none, none};  // where the last element ended, downwards and upwards
  double far_[2] = {0, 0};        // depth of the last dale, height of the last hill
  int side_ = 0;
};

void add_elements(ProfileParameters& out, const Eigen::ArrayXd& z, double step) {
  Elements elements(0.1 * out[profile_z]);
  for (Index i = 0; i < z.size(); ++i) elements.add(static_cast<double>(i), z(i));
  out[profile_sm] = step * elements.mean_length();
  out[profile_c] = elements.mean_height();
}

// Of a straight profile all lengths are 0, and there is no share.
void add_material(ProfileParameters& out, const Eigen::ArrayXd& z, const std::array<double, 2>& ratios) {
  const MaterialRatioCurve curve{Field(z)};
  const CoreParameters core = curve.core();
  out[profile_k] = core.sk, out[profile_pk] = core.spk, out[profile_vk] = core.svk;
  if (out[profile_q] > 0) out[profile_mr1] = core.smr1, out[profile_mr2] = core.smr2;
  out[profile_pkx] = core.spkx, out[profile_vkx] = core.svkx;
  out[profile_ak1] = core.sak1, out[profile_ak2] = core.sak2;
  out[profile_mc_p] = curve.height(ratios[0]), out[profile_mc_q] = curve.height(ratios[1]);
  out[profile_dc] = curve.fall(ratios);
}

// The mean height of the five highest peaks.
double five_highest(const Eigen::ArrayXd& z, bool periodic, double least) {
  constexpr std::ptrdiff_t five = 5;
  const Index n = z.size();
  auto ends = [&](Index peak, Index step) {  // or is beside a missing point, with all of its height
    for (Index k = 1, at = peak; k < n; ++k) {
      at = periodic ? (at + step + n) % n : at + step;
      if (at < 0 || at >= n || std::isnan(z(at))) return true;
      if (z(at) != z(peak)) return false;
    }
    return true;
  };
  std::vector<double> heights;
  for (const Hill& h : pruned(hills_of(Field(z.transpose()), {false, periodic}), least).all)
    if (!ends(h.peak, 1) && !ends(h.peak, -1)) heights.push_back(h.height);
  if (std::ssize(heights) < five) return none;
  std::ranges::partial_sort(heights, heights.begin() + five, std::ranges::greater());
  return std::accumulate(heights.begin(), heights.begin() + five, 0.0) / five;
}

// c; lags p run along the profiles, j across.
double profiles_worth_one(const LagField& rho, const Pairs& pairs, Axis1D along) {
  double all = 0, same = 0;
  for_each_lag(rho, pairs, [&](Index p, Index q, double weight) {
    const double term = weight * rho(p, q) * rho(p, q);
    all += term;
    if ((along == Axis1D::x ? q : p) == 0) same += term;
  });
  return same > 0 ? std::max(1.0, all / same) : none;
}

// (4) of a profile, a column each; NaN where it is straight.
Eigen::ArrayXXd local_functions(const Eigen::ArrayXd& heights, double round_off) {
  Eigen::ArrayXXd out = Eigen::ArrayXXd::Constant(heights.size(), 2, none);
  auto mean = [](const Eigen::ArrayXd& f) {
    const ValidSum sum = sum_of_valid(f);
    return sum.sum / sum.count;
  };
  const Eigen::ArrayXd h = heights - mean(heights), square = h.square();
  if (!(h.abs() > round_off).any()) return out;
  const double q = std::sqrt(mean(square));
  out.col(0) = h.abs() - mean(h.sign()) * h;
  out.col(1) = q + (square - q * q) / (2 * q);
  return out;
}

// Their means over all profiles, those that are rows of the field.
LocalMeans means_in_plane(const Field& rows, const Grid& grid, const FieldExtent& extent, double round_off) {
  LocalSums sums(grid, 2);
  sums.add_rows(rows.rows(), 1, [&](Index i, LocalSums::Values& values) {
    values.rightCols(2) = local_functions(rows.row(i).transpose(), round_off).matrix();
  });
  return sums.means(extent);
}

LocalMeans means_in_plane(const Field& heights, const Grid& grid, const FieldExtent& extent, Axis1D along,
                          double round_off) {
  if (along == Axis1D::y) return means_in_plane(heights, grid, extent, round_off);
  const Grid turned{{grid.shape.ny, grid.shape.nx}, grid.dy, grid.dx, {grid.periodic.y, grid.periodic.x}};
  return means_in_plane(heights.transpose(), turned, {extent.patches, 1 / extent.elongation, extent.negative},
                        round_off);
}

}  // namespace

ProfileParameters profile_parameters(const Eigen::ArrayXd& heights, double step, double section,
                                     bool periodic, double round_off, const std::array<double, 2>& ratios) {
  ProfileParameters out = ProfileParameters::Constant(none);
  const ValidSum sum = sum_of_valid(heights);
  if (sum.count < 2) return out;
  Eigen::ArrayXd z = heights - sum.sum / sum.count;
  if (!(z.abs() > round_off).any()) z = z.isNaN().select(z, 0.0);
  add_moments(out, z);
  add_extremes(out, z, section / step);
  out[profile_dq] = rms_slope(z, step, periodic);
  add_elements(out, z, step);
  add_material(out, z, ratios);
  const double least = 0.05 * out[profile_z];
  out[profile_5p] = five_highest(z, periodic, least), out[profile_5v] = five_highest(-z, periodic, least);
  out[profile_10z] = out[profile_5p] + out[profile_5v];
  return out;
}

ProfileAverages average_profiles(const Field& heights, const Pairs& pairs, const FieldExtent& extent,
                                 Axis1D along, double section, const LagField& rho, double round_off,
                                 const std::array<double, 2>& ratios) {
  const Grid& grid = pairs.grid();
  const bool x = along == Axis1D::x;
  const double length = x ? grid.size_x() : grid.size_y(), step = x ? grid.dx : grid.dy;
  if (std::isfinite(section) && section > length * (1 + 1e-12))
    throw ParameterError(
        "lambda-c", "'" + shortest(section) + " m' is longer than the profiles, " + shortest(length) + " m");
  std::vector<ProfileParameters> profiles;
  for (Index i = 0, m = x ? heights.cols() : heights.rows(); i < m; ++i) {
    const Eigen::ArrayXd profile = x ? Eigen::ArrayXd(heights.col(i)) : heights.row(i).transpose();
    profiles.push_back(
        profile_parameters(profile, step, section, x ? grid.periodic.x : grid.periodic.y, round_off, ratios));
  }
  const double share = 1 / profiles_worth_one(rho, pairs, along);
  const bool across = x ? grid.periodic.y : grid.periodic.x;
  ProfileAverages out;
  for (Index k = 0; k < profile_parameters_count; ++k)
    out.of[size(k)] = sequence_mean(
        Eigen::ArrayXd::NullaryExpr(std::ssize(profiles), [&](Index j) { return profiles[size(j)][k]; }),
        share, across);
  const LocalMeans plane = means_in_plane(heights, grid, extent, along, round_off);
  for (Index k = 0; k < 2; ++k)
    if (std::isfinite(out.of[size(k)].of_mean.error))
      out.of[size(k)].of_mean = plane.error([k](const Eigen::VectorXd& m) { return m(k); });
  out.profiles = out.of[profile_q].count;
  out.independent = out.profiles * share;
  return out;
}

}  // namespace asperity
