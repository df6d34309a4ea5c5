#include "stats/measure/pooled_maps.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "core/words.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/sample/ensemble.hpp"
#include "stats/spatial/acf_length.hpp"

namespace asperity {
namespace {

constexpr int heights_of_map = 500, most_groups = PooledMaps::most_degrees + 1;

// Shares of the area that the classes of heights resolve, four of them from either end; extremes of single
// maps are not of their pool.
bool is_resolved(double share) { return std::min(share, 1 - share) >= 4.0 / heights_of_map; }

// Means of derivatives, by the names that begin so; m0 has a value where slopes have.
bool is_mean_of_derivatives(const std::string& name) {
  return name == "m0" || name.starts_with("m2_") || name.starts_with("m4_") || name == "summit_curvature" ||
         name == "peak_curvature";
}

// Extremes over the directions of a noisy contour: the bounds that the bias leads away from.
std::optional<std::pair<double, double>> bounds_of_extreme(const std::string& name) {
  if (name == "Sal" || name == "slowest_decay") return {{0, INFINITY}};
  if (name == "Str") return {{0, 1}};
  if (name == "gamma" || (name.starts_with("ellipticity_") && !name.ends_with("_direction")))
    return {{1, INFINITY}};
  return {};
}

void add_row(Parameters& out, const std::string& name, double value) {
  out.push_back({name, value, "", unknown, ""});
}

}  // namespace

// ---- of one map ----

MapSums::MapSums(const Moments& m, const Grid& grid, double taken, const Parameters& rows) : grid_(grid) {
  const double square = m.sq * m.sq;
  sums_ << m.sa, square, m.ssk * square * m.sq, m.sku * square * square, square * taken / (1 - taken);
  for (const Parameter& row : rows) {
    if (is_mean_of_derivatives(row.name)) rows_[row.name] = row.value;
    if (row.name == "Sdq") rows_[row.name] = row.value * row.value;
  }
}

// The means of classes of equal shares keep the areas under the curve.
void MapSums::set_heights(const MaterialRatioCurve& curve, double mean) {
  constexpr int parts = 8;
  for (int k = 0; k < heights_of_map; ++k) {
    double sum = 0;
    for (int i = 0; i < parts; ++i) sum += curve.quantile((k + (i + 0.5) / parts) / heights_of_map);
    heights_.push_back(sum / parts - mean);
  }
}

LagField MapSums::acf(const AcfEstimate& estimate) const {
  const double took = sums_(4);
  return LagField::of(estimate.rho.max_lag(), [&](Index p, Index q) {
    const double share = estimate.biased ? estimate.basis.pairs.pair_fraction(p, q) : 1;
    return estimate.variance * estimate.rho(p, q) + took * share * estimate.basis.form(p, q);
  });
}

void MapSums::set_acf(const AcfEstimate& estimate, double level) {
  constexpr Index times = 2, least = 32;
  const auto [p, q] = lags_about(estimate.rho, estimate.grid(), level);
  acf_ = acf(estimate).within({times * p + least, times * q + least});
}

void MapSums::weigh(double weight) {
  weight_ = weight, weights_ = {weight};
  sums_ *= weight;
  for (auto& row : rows_) row.second *= weight;
  if (acf_ && weight != 1) acf_ = LagField(weight * acf_->half_plane());
}

namespace {

// From values at -P…P or 0…P to those at lags `ratio` ≥ 1 times as far, by cubics through four of them on
// either side of 0: none passes through the cusp there.
Eigen::MatrixXd to_coarser(Index lags, double ratio, bool both_signs) {
  constexpr double printed = 1e-6;
  const auto last = static_cast<Index>(static_cast<double>(lags) / ratio * (1 + printed));
  const Index zero = both_signs ? lags : 0, zero_of_coarse = both_signs ? last : 0;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(last + zero_of_coarse + 1, lags + zero + 1);
  for (Index k = -zero_of_coarse; k <= last; ++k) {
    const double at = std::abs(static_cast<double>(k)) * ratio, sign = k < 0 ? -1 : 1;
    const Index first = std::clamp<Index>(static_cast<Index>(at) - 1, 0, std::max<Index>(lags - 3, 0)),
                end = std::min(first + 4, lags + 1);
    for (Index i = first; i < end; ++i) {
      double weight = 1;
      for (Index j = first; j < end; ++j)
        if (j != i) weight *= (at - static_cast<double>(j)) / static_cast<double>(i - j);
      out(k + zero_of_coarse, zero + static_cast<Index>(sign) * i) = weight;
    }
  }
  return out;
}

}  // namespace

void MapSums::take_spacing(const Grid& coarser) {
  if (same_spacing(grid_, coarser)) return;
  for (auto& [name, sum] : rows_)
    if (name != "m0") sum = unknown;
  if (acf_) {
    const Eigen::MatrixXd x = to_coarser(acf_->max_p(), coarser.dx / grid_.dx, false),
                          y = to_coarser(acf_->max_q(), coarser.dy / grid_.dy, true);
    acf_ = LagField((x * acf_->half_plane().matrix() * y.transpose()).array());
  }
  grid_.dx = coarser.dx, grid_.dy = coarser.dy;
}

// Of maps of unequal weight as many of equal weight: their means keep the areas under the curve.
Field MapSums::heights() const {
  if (std::ranges::equal(weights_, std::vector(weights_.size(), weights_[0])))
    return Eigen::Map<const Field>(heights_.data(), std::ssize(heights_), 1);
  std::vector<std::pair<double, double>> parts;
  for (std::size_t k = 0; k < heights_.size(); ++k)
    parts.emplace_back(heights_[k], weights_[k / heights_of_map] / weight_);
  std::ranges::sort(parts);
  const double weight = 1.0 / static_cast<double>(weights_.size());
  Field out = Field::Zero(std::ssize(heights_), 1);
  double below = 0;  // of all heights, in classes
  for (const auto& [height, share] : parts)
    for (double rest = share / weight; rest > 0;) {
      const Index k = std::min(static_cast<Index>(below), out.rows() - 1);
      const double taken = k + 1 == out.rows() ? rest : std::min(rest, static_cast<double>(k + 1) - below);
      out(k) += taken * height;
      below += taken, rest -= taken;
    }
  return out;
}

void MapSums::operator+=(const MapSums& more) {
  weight_ += more.weight_;
  sums_ += more.sums_;
  for (auto& [name, sum] : rows_) {
    const auto found = more.rows_.find(name);
    sum += found == more.rows_.end() ? unknown : found->second;
  }
  heights_.insert(heights_.end(), more.heights_.begin(), more.heights_.end());
  weights_.insert(weights_.end(), more.weights_.begin(), more.weights_.end());
  if (!acf_ || !more.acf_) return acf_.reset();
  const Shape both{std::min(acf_->max_p(), more.acf_->max_p()), std::min(acf_->max_q(), more.acf_->max_q())};
  acf_ = LagField(acf_->within(both).half_plane() + more.acf_->within(both).half_plane());
}

double taken_from(const Surface& surface, const AcfEstimate& estimate, const Moments& moments, int threads) {
  const bool known = !estimate.basis.estimated && estimate.size.sum(1) > 0;
  const double by_correlation = estimate.size.taken_by_form();
  if (known) return by_correlation;
  const double taken =
      HeightErrors(surface.heights, surface.grid, estimate.basis.extent(), moments, surface.degree, threads)
          .taken();
  return std::isnan(taken) ? by_correlation : taken;
}

MapSums map_sums(const Sample& sample, const Parameters& rows, const MeasureOptions& asked) {
  const double taken = sample.taken_by_form();
  MapSums out(sample.moments(), sample.grid(), std::isnan(taken) ? sample.size().taken_by_form() : taken,
              rows);
  if (asked.groups.contains(Group::material) || asked.groups.contains(Group::quantiles))
    out.set_heights(sample.material_ratio(), sample.moments().mean);
  if (asked.groups.contains(Group::spatial)) out.set_acf(AcfEstimate::of(sample), asked.sal_level);
  return out;
}

// ---- of several ----

namespace {

void add_core(Parameters& out, const MaterialRatioCurve& curve, const PooledOptions& options) {
  const auto [p, q] = options.material_ratios;
  const CoreParameters core = curve.core();
  const VolumeParameters volumes = curve.volumes(p, q);
  add_row(out, "Sk", core.sk), add_row(out, "Spk", core.spk), add_row(out, "Svk", core.svk);
  add_row(out, "Smr1", core.smr1), add_row(out, "Smr2", core.smr2);
  add_row(out, "Sak1", core.sak1), add_row(out, "Sak2", core.sak2);
  if (is_resolved(p)) add_row(out, "Smc_p", curve.height(p));
  if (is_resolved(q)) add_row(out, "Smc_q", curve.height(q));
  if (is_resolved(p) && is_resolved(q)) add_row(out, "Sdc", curve.fall(options.material_ratios));
  add_row(out, "Sxp", curve.fall(sxp_ratios));
  add_row(out, "Vmp", volumes.vmp), add_row(out, "Vmc", volumes.vmc);
  add_row(out, "Vvc", volumes.vvc), add_row(out, "Vvv", volumes.vvv);
  for (const auto& [c, text] : options.material_heights) add_row(out, "Smr_" + text, curve.ratio(c));
  for (const double share : options.quantiles)
    if (is_resolved(share)) add_row(out, "quantile_" + shortest(share), curve.quantile(share));
}

// Functions of the means of derivatives.
void add_derivatives(Parameters& out, double m0, const std::function<double(const std::string&)>& mean) {
  add_row(out, "m0", m0);
  add_row(out, "Sdq", std::sqrt(mean("Sdq")));
  for (const std::string along : {"x", "y", "direction"})
    add_row(out, "alpha_" + along,
            ProfileSpectralMoments{m0, mean("m2_" + along), mean("m4_" + along)}.bandwidth());
  for (const std::string of : {"summit", "peak"}) add_row(out, of + "_radius", 1 / mean(of + "_curvature"));
  const Summits expected =
      expected_summits({m0, std::sqrt(mean("m2_x") * mean("m2_y")), std::sqrt(mean("m4_x") * mean("m4_y"))});
  add_row(out, "nayak_density", expected.density), add_row(out, "nayak_height", expected.mean_height);
  add_row(out, "nayak_deviation", expected.height_deviation);
  add_row(out, "nayak_curvature", expected.mean_curvature), add_row(out, "nayak_radius", expected.radius());
}

// From the values of all, NaN where one lacks it; directions are those of axes.
Eigen::ArrayXd deviations(const Parameters& values, const Parameters& all) {
  return Eigen::ArrayXd::NullaryExpr(std::ssize(all), [&](Index i) {
    const Parameter& of = all[static_cast<std::size_t>(i)];
    const auto found = std::ranges::find(values, of.name, &Parameter::name);
    if (found == values.end()) return unknown;
    const double apart = found->value - of.value;
    return of.unit == "rad" ? std::remainder(apart, std::numbers::pi) : apart;
  });
}

}  // namespace

void PooledMaps::add(MapSums map, double weight) {
  map.weigh(weight);
  if (maps_ == 0) grid_ = map.grid_;
  one_spacing_ &= same_spacing(grid_, map.grid_);
  grid_.dx = std::max(grid_.dx, map.grid_.dx), grid_.dy = std::max(grid_.dy, map.grid_.dy);
  for (MapSums& group : groups_) group.take_spacing(grid_);
  map.take_spacing(grid_);
  if (maps_ < most_groups)
    groups_.push_back(std::move(map));
  else
    groups_[static_cast<std::size_t>(maps_ % most_groups)] += map;
  ++maps_;
}

Parameters PooledMaps::evaluated(const MapSums& of, const PooledOptions& options) {
  const Eigen::Array<double, 5, 1> mean = of.sums_ / of.weight_;
  const double square = mean(1), whole = square + mean(4), larger = std::sqrt(whole / square);
  Parameters out;
  add_row(out, "Sa", mean(0) * larger), add_row(out, "Sq", std::sqrt(whole));
  add_row(out, "Ssk", mean(2) / (square * std::sqrt(square))),
      add_row(out, "Sku", mean(3) / (square * square));
  if (!of.heights_.empty()) {
    add_core(out, MaterialRatioCurve(larger * of.heights()), options);
  }
  const auto mean_of = [&](const std::string& name) {
    const auto found = of.rows_.find(name);
    return found == of.rows_.end() ? unknown : found->second / of.weight_;
  };
  add_derivatives(out, std::isnan(mean_of("m0")) ? unknown : whole, mean_of);
  if (of.acf_ && options.of_acf)
    std::ranges::copy(options.of_acf(of.acf_->normalised(), of.grid_), std::back_inserter(out));
  return out;
}

Parameters PooledMaps::all(const PooledOptions& options) const {
  if (groups_.empty()) return {};
  const auto all_but = [&](std::size_t left_out) {
    std::optional<MapSums> sum;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (g == left_out) continue;
      if (sum)
        *sum += groups_[g];
      else
        sum = groups_[g];
    }
    return evaluated(*sum, options);
  };
  Parameters out = all_but(groups_.size());
  if (groups_.size() < 2) return out;
  Ensemble apart;
  const double n = static_cast<double>(groups_.size());
  double whole = 0;
  for (const MapSums& group : groups_) whole += group.weight_of_map();
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const double weight = groups_[g].weight_of_map(), times = (whole - weight) / weight / (n - 1);
    apart.add(times * deviations(all_but(g), out), weight);  // once of equal maps
  }
  // One that no map moves, such as a direction between few lags, is known to the lags only.
  const Eigen::ArrayXd errors =
      (apart.count() == n && apart.spread() > 0).select(apart.spread() * ((n - 1) / std::sqrt(n)), unknown);
  const Eigen::ArrayXd bias = (n - 1) * apart.mean();
  for (std::size_t i = 0; i < out.size(); ++i) {
    Parameter& p = out[i];
    p.standard_error = errors(static_cast<Index>(i));
    const double freed = p.value - bias(static_cast<Index>(i));
    if (const auto bounds = bounds_of_extreme(p.name); bounds && std::isfinite(freed))
      p.value = std::clamp(freed, bounds->first, bounds->second);
    constexpr double any = std::numbers::pi / 8;  // of a random axis the error is π/√12
    if (p.unit == "rad" && p.standard_error > any) p.value = p.standard_error = unknown;
  }
  return out;
}

}  // namespace asperity
