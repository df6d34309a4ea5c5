#include "tools/measure/acf_result.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "dataset/layout.hpp"
#include "stats/filter/missing.hpp"
#include "stats/height/distribution.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/spatial/tapered_acf.hpp"
#include "stats/uncertainty/translation_error.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/measure/field_options.hpp"
#include "tools/surface/marginal.hpp"

namespace asperity::cli {
namespace {

void add_profile(Table& table, const AcfResult& result, bool absolute, bool x) {
  const AcfEstimate& estimate = result.estimate;
  const Grid& grid = estimate.grid();
  const ProfileErrors& errors = (*result.profiles)[x ? 0 : 1];
  const Index lags = x ? estimate.rho.max_p() : estimate.rho.max_q();
  const double spacing = x ? grid.dx : grid.dy, scale = absolute ? estimate.variance : 1;
  const LagField rho = estimate.rho.within(x ? Shape{lags, 0} : Shape{0, lags});
  for (Index lag = 0; lag <= lags; ++lag) {
    const Index p = x ? lag : 0, q = x ? 0 : lag;
    const double value = scale * rho(p, q), error = errors.acf(lag);
    const Interval ends = errors.interval(value, lag);
    std::vector<Cell> row{x ? "x" : "y", static_cast<double>(lag) * spacing, value, error, ends.low,
                          ends.high};
    if (result.target) row.push_back(scale * (*result.target)(p, q));
    if (result.structure) {
      row.push_back((*result.structure)(p, q));
      row.push_back(errors.structure(lag));
      const Interval of_structure = errors.structure_interval((*result.structure)(p, q), lag);
      row.push_back(of_structure.low), row.push_back(of_structure.high);
    }
    table.rows.push_back(std::move(row));
  }
}

// Over the half-plane of lags.
class Writer {
 public:
  Writer(Dataset& data, const Grid& grid, const AcfContent& content)
      : data_(data), grid_(grid), content_(content) {}

  void acf(const Field& values, const char* meaning = "autocorrelation estimated from the field") {
    write("acf", values, content_.unit(), meaning);
  }
  void error(const Field& values, const char* meaning = "standard error of the mean autocorrelation") {
    write("acf_error", values, content_.unit(), meaning);
  }
  void structure(const Field& values) {
    write("structure_function", values, content_.squared(),
          "mean square difference of two points a lag apart");
  }
  void scalars(double variance, double skewness, double kurtosis) {
    data_.attributes.set("acf_skewness", skewness);
    data_.attributes.set("acf_kurtosis", kurtosis);
    // In m2: of heights only.
    if (content_.units == "m") data_.attributes.set("acf_variance", variance);
  }
  void taper() {
    if (*content_.taper != 0) data_.attributes.set("acf_taper", content_.taper);
  }
  void lengths(const auto& parameters, auto value) {
    for (const auto& length : parameters) data_.attributes.set("acf_" + length.name, value(length));
  }

 private:
  void write(const char* name, const Field& values, const std::string& unit, const char* meaning) {
    const Axis lag_x{"lag_x", 0, grid_.dx, "m", "lag in x"},
        lag_y{"lag_y", -(values.cols() / 2), grid_.dy, "m", "lag in y"};
    set_table(data_, name, values, lag_x, lag_y, {unit, meaning}, Missing::not_a_number);
  }

  Dataset& data_;
  const Grid& grid_;
  const AcfContent& content_;
};

}  // namespace

std::string AcfContent::squared() const { return unit_to(units, 2); }

const char* taper_of(const Grid& grid) { return grid.periodic.both() ? "none" : "tukey"; }

namespace {

// Rounding to steps is noise of step²/12, in a second difference six times as much: the larger share.
double share_of_rounding(double step, const AcfEstimate& of) {
  const LagField& rho = of.rho;
  double share = 0;
  for (const Shape axis : {Shape{1, 0}, Shape{0, 1}}) {
    if ((axis.nx ? rho.max_p() : rho.max_q()) < 2) continue;
    const double bend = 6 - 8 * rho(axis.nx, axis.ny) + 2 * rho(2 * axis.nx, 2 * axis.ny);
    share = std::max(share, step * step / 2 / of.variance / bend);
  }
  return share;
}

}  // namespace

AcfResult tapered_acf(const Surface& surface, Shape max_lag, int threads) {
  const ErrorBasis basis = error_basis(surface, threads);
  AcfResult out{
      AcfEstimate(tapered_autocorrelation(surface.heights, surface.grid, max_lag, threads), basis, true)};
  out.step = height_steps(surface.heights).step;
  out.rounding = share_of_rounding(out.step, out.estimate);
  out.slopes = slopes_by_taper(surface.heights, surface.grid, out.estimate.rho);
  out.moments = moments(surface.heights, surface.variable);
  const EffectiveSampleSize size = basis.size();
  const bool enough = sum_of_valid(surface.heights).count >= static_cast<double>(MeasuredHeights::least),
             other = enough && evident_translation(out.moments, standard_errors(out.moments, size));
  if (enough) out.quantiles = quantiles_of(surface.heights);
  out.marginal = other ? "measured" : "gaussian";
  return out;
}

void warn_of_taper(const Tool& tool, const Surface& surface, const AcfResult& result) {
  constexpr double notable = 1.05, tenfold = 10, rounded = 0.05;
  if (result.rounding > rounded)
    tool.warn(
        fmt::format("heights stand on steps of {}, {:.0f} % of their mean square second difference: twins "
                    "have the rounding as "
                    "noise, and more summits than the surface; smooth it first (--lambda-s)",
                    format_quantity(result.step, surface.units), 100 * std::min(result.rounding, 1.0)));
  if (result.slopes <= notable) return;
  const Shape lags = result.estimate.rho.max_lag();
  const std::string by =
      result.slopes < tenfold ? fmt::format("by {:.0f} %", 100 * (result.slopes - 1)) : "tenfold or more";
  if (lags != longest_lags(surface.grid))
    return tool.warn("the cut at " + text(lags) + " lags raises the rms slope of twins " + by +
                     ": allow longer ones (--max-lag)");
  tool.warn("the taper raises the rms slope of twins " + by +
            (has_missing(surface.heights)
                 ? ": it falls to 0 at wide holes; cut out a part without them (asperity-filter --crop)"
                 : ": the heights vary too slowly for a map of this size; take off the form (--remove-form "
                   "plane) or long waves (--lambda-c), or measure a larger map"));
}

MeasuredHeights quantiles_of(const Field& heights) {
  std::vector<double> sample(heights.data(), heights.data() + heights.size());
  std::erase_if(sample, [](double z) { return std::isnan(z); });
  return MeasuredHeights::of(std::move(sample));
}

Eigen::ArrayXd profiles_of(const Field& half_plane) {
  const LagField lags(half_plane);
  Eigen::ArrayXd out(lags.max_p() + lags.max_q() + 2);
  out << lags.along_x(), lags.along_y();
  return out;
}

Table acf_profiles(const AcfResult& result, const AcfContent& content) {
  const std::string unit = content.unit();
  Table table{{{"direction", ""},
               {"lag", "m"},
               {"acf", unit, Holds::unknown},
               {"standard_error", unit, Holds::unknown},
               {"low_95", unit, Holds::open},
               {"high_95", unit, Holds::open}},
              {}};
  if (result.target) table.columns.push_back({"target", unit, Holds::unknown});
  if (result.structure)
    for (const char* name : {"", "_standard_error", "_low_95", "_high_95"})
      table.columns.push_back({std::string("structure_function") + name, content.squared(), Holds::unknown});
  for (const bool x : {true, false}) add_profile(table, result, content.absolute, x);
  return table;
}

void add_acf(Dataset& data, const AcfResult& result, const Parameters& lengths, const AcfContent& content) {
  drop_results(data, "acf", content.variable);
  data.attributes.set("acf_variable", content.variable);
  const AcfEstimate& estimate = result.estimate;
  Writer writer(data, estimate.basis.pairs.grid(), content);
  const Field& rho = estimate.rho.half_plane();
  content.absolute ? writer.acf(estimate.variance * rho) : writer.acf(rho);
  if (result.errors)
    writer.error(result.errors->half_plane(), "standard error of acf, from the field's own long waves");
  if (result.structure) writer.structure(result.structure->half_plane());
  if (result.quantiles) set_quantiles(data, "acf_quantiles", *result.quantiles);
  if (*result.marginal != 0) data.attributes.set("acf_marginal", result.marginal);
  writer.taper();
  writer.scalars(estimate.variance, result.moments.ssk, result.moments.sku);
  check_finite(lengths);
  writer.lengths(lengths, [](const Parameter& length) { return length.value; });
}

// ---- several surfaces ----

void PooledAcf::add(const AcfResult& result, double weight) {
  const Field own = result.sums->acf(result.estimate).half_plane();
  if (n_ == 0) mean_ = squares_ = products_ = Field::Zero(own.rows(), own.cols());
  const Field apart = own - mean_;
  const double of_variance = apart(0, apart.cols() / 2), share = weight * weights_ / (weights_ + weight);
  ++n_, weights_ += weight;
  mean_ += weight * apart / weights_;
  squares_ += share * apart.square(), products_ += share * of_variance * apart;
}

Field PooledAcf::values(bool absolute) const { return absolute ? mean_ : Field(mean_ / variance()); }

Field PooledAcf::errors(bool absolute) const {
  const double of_mean = weights_ * (n_ - 1);
  if (absolute) return (squares_ / of_mean).sqrt();
  const Field rho = values(false);
  const Index zero = mean_.cols() / 2;
  Field out = (squares_ - 2 * rho * products_ + rho.square() * squares_(0, zero)).max(0.0);
  out(0, zero) = 0;  // without round-off
  return (out / of_mean).sqrt() / variance();
}

void AcfEnsemble::add(const AcfResult& result, const Parameters& lengths, bool function) {
  const double weight = weights_.of(result.area, result.enough());
  lengths_.add(lengths, weight);
  pool_.add(*result.sums, weight);
  if (!function) return;
  acf_.add(result, weight);
  if (result.structure) structure_.add(result.structure->half_plane(), weight);
  structured_ = result.structure.has_value();
}

std::vector<EnsembleParameter> AcfEnsemble::lengths() const {
  std::vector<EnsembleParameter> out = lengths_.all();
  take_pooled(out, pool_.all(of_acf_), pool_);
  if (!weights_.give_errors())
    for (EnsembleParameter& p : out) p.standard_error = unknown;
  return out;
}

Dataset AcfEnsemble::dataset() const {
  Dataset out;
  set_grid(out, grid());
  out.attributes.set("acf_variable", content_.variable);
  out.attributes.set("acf_surfaces", surfaces());
  Writer writer(out, grid(), content_);
  writer.acf(acf_.values(content_.absolute), "autocorrelation of the pooled surfaces");
  const double known = weights_.give_errors() ? 1 : unknown;
  writer.error(known * acf_.errors(content_.absolute), "standard error of the pooled autocorrelation");
  if (structured_) writer.structure(structure_.mean());
  writer.taper();
  const Parameters pooled = pool_.all({});
  const auto value = [&](const char* name) {
    return std::ranges::find(pooled, name, &Parameter::name)->value;
  };
  writer.scalars(std::pow(value("Sq"), 2), value("Ssk"), value("Sku"));
  writer.lengths(lengths(), [](const EnsembleParameter& length) { return length.mean; });
  return out;
}

}  // namespace asperity::cli
