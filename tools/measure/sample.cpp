#include "tools/measure/sample.hpp"

#include <algorithm>
#include <cmath>

#include "stats/filter/selection.hpp"

namespace asperity::cli {
namespace {

constexpr std::size_t bytes_a_point = 80;  // of a strip, with its transform and its lags
constexpr std::size_t bytes_a_point_of_columns = 32;
constexpr Index least_rows = 4;

// How many rows there are to a strip, all strips but the last of the same number.
Index rows_of_strip(const Grid& grid, std::size_t memory) {
  const std::size_t row = bytes_a_point * static_cast<std::size_t>(grid.shape.ny);
  const auto most = static_cast<Index>(memory / row);
  if (most < least_rows)
    throw UsageError("memory", std::to_string(memory) + " bytes: does not hold " +
                                   std::to_string(least_rows) + " rows of " + std::to_string(grid.shape.ny) +
                                   " points, " + std::to_string(row * static_cast<std::size_t>(least_rows)));
  const Index strips = (grid.shape.nx + most - 1) / most;
  return (grid.shape.nx + strips - 1) / strips;
}

// How many columns; at least one, whatever the memory.
Index columns_of_strip(const Grid& grid, std::size_t memory) {
  const std::size_t column = bytes_a_point_of_columns * static_cast<std::size_t>(grid.shape.nx);
  return std::clamp<Index>(static_cast<Index>(memory / column), 1, grid.shape.ny);
}

}  // namespace

// ---- whole ----

WholeSample::WholeSample(Measured measured, const std::string& variable, int threads)
    : Sample(std::move(measured), variable),
      threads_(threads),
      moments_(asperity::moments(heights(), variable)) {}

const Pairs& WholeSample::pairs() {
  if (!pairs_) pairs_ = Pairs::of(heights(), grid(), threads_);
  return *pairs_;
}

const LagField& WholeSample::acf() {
  if (!acf_)
    acf_ = estimate_autocorrelation(heights(), pairs(),
                                    {.max_lag = default_max_lag(grid()), .threads = threads_});
  return *acf_;
}

const EffectiveSampleSize& WholeSample::size() {
  if (!size_)
    size_ = measured().drawn ? EffectiveSampleSize(*measured().drawn, pairs())
                             : EffectiveSampleSize::of_estimate(acf(), pairs());
  return *size_;
}

EffectiveSampleSize WholeSample::size_below(const CorrelationMap& map) {
  return measured().drawn ? EffectiveSampleSize(underlying_correlation(*measured().drawn, map), pairs())
                          : EffectiveSampleSize::of_estimate(underlying_correlation(acf(), map), pairs());
}

DerivativeErrors WholeSample::derivative_errors() {
  const DifferencePairs differences(pairs(), heights(), threads_);
  return measured().drawn ? asperity::derivative_errors(*measured().drawn, differences)
                          : derivative_errors_of_estimate(acf(), differences);
}

std::vector<double> WholeSample::quantiles(const std::vector<double>& shares) {
  const MaterialRatioCurve curve = material_ratio();
  std::vector<double> out;
  out.reserve(shares.size());
  for (const double share : shares) out.push_back(curve.quantile(share));
  return out;
}

ProfileAverages WholeSample::profiles(Axis1D along, double section) {
  const LagField rho = measured().drawn ? *measured().drawn : significant_lags(acf(), pairs());
  return average_profiles(heights(), pairs(), along, section, rho);
}

// ---- in strips ----

StripSample::StripSample(const FieldFile& file, const MeasuredOptions& options, const Request& request)
    : Sample(without_heights(file.dataset(), options), options.variable),
      file_(file),
      request_(request),
      rows_(rows_of_strip(file.grid(), request.memory)) {
  measure_level();
  if (const int degree = form_degree(options.level)) fit_form(degree);
  const bool complete = points_ == static_cast<double>(grid().shape.cells());
  if (!measured().drawn || !complete) correlation_.emplace(grid(), rows_, request_.threads);
  measure();
  refuse_round_off(std::max(moments_.sp, moments_.sv), largest_, options);
  find_correlation();
}

template <class Visit>
void StripSample::for_each_strip(Index behind, Visit visit) const {
  const Index nx = grid().shape.nx;
  for (Index first = 0; first < nx; first += rows_) {
    const Index own = std::min(rows_, nx - first), within = std::min(own + behind, nx - first);
    Field strip = file_.rows(first, within);
    if (grid().periodic && rows_ < nx && within < own + behind) {
      const Index around = own + behind - within;
      strip.conservativeResize(own + behind, Eigen::NoChange);
      strip.bottomRows(around) = file_.rows(0, around);
    }
    strip = (strip - mean_.base) - mean_.above;
    if (form_) {
      form_->remove(strip.topRows(within), first);
      form_->remove(strip.bottomRows(strip.rows() - within), 0);
    }
    visit(strip, own, first);
  }
}

void StripSample::measure_level() {
  MeanSum sum;
  for_each_strip(0, [&](const Field& strip, Index, Index) {
    sum.add(strip);
    largest_ = std::max(largest_, strip.abs().maxCoeff<Eigen::PropagateNumbers>());
  });
  mean_ = sum.mean();
  points_ = sum.count();
  measured_.level = mean_.value();
}

void StripSample::fit_form(int degree) {
  form_.emplace(grid().shape, degree);
  while (!form_->done()) {
    for_each_strip(0, [&](const Field& strip, Index, Index first) { form_->add(strip, first); });
    form_->end_pass();
  }
}

void StripSample::measure() {
  MomentSums sums(Mean{});
  for_each_strip(request_.derivatives ? 2 : 0, [&](const Field& strip, Index own, Index) {
    const Field inner = strip.topRows(own);
    sums.add(inner);
    if (correlation_) correlation_->add(inner);
    if (!request_.derivatives) return;
    const Strip with_neighbours{strip, grid(), own};
    slope_sums_.add(with_neighbours, request_.threads);
    spectral_sums_.add(with_neighbours, 0, request_.threads);
    summit_sums_.add(with_neighbours, 0, request_.threads);
  });
  moments_ = sums.moments(variable());
}

void StripSample::find_correlation() {
  pairs_ = correlation_ ? correlation_->pairs() : Pairs(grid());
  if (!measured().drawn) acf_ = correlation_->estimate();
  size_ = acf_ ? EffectiveSampleSize::of_estimate(*acf_, *pairs_)
               : EffectiveSampleSize(*measured().drawn, *pairs_);
  reaches_beyond_ = correlation_ && correlation_->reaches_beyond(known_correlation());
}

EffectiveSampleSize StripSample::size_below(const CorrelationMap& map) {
  return acf_ ? EffectiveSampleSize::of_estimate(underlying_correlation(*acf_, map), *pairs_)
              : EffectiveSampleSize(underlying_correlation(*measured().drawn, map), *pairs_);
}

LagField StripSample::known_correlation() const {
  return acf_ ? significant_lags(*acf_, *pairs_) : *measured().drawn;
}

const std::vector<HeightRun>& StripSample::runs() {
  if (!runs_) {
    HeightCells cells(moments_);
    for_each_strip(0, [&](const Field& strip, Index, Index) { cells.add(strip); });
    runs_ = cells.runs();
  }
  return *runs_;
}

ProfileAverages StripSample::profiles(Axis1D along, double section) {
  ProfileSums sums(grid(), along, section);
  if (along == Axis1D::y) {
    for_each_strip(0, [&](const Field& strip, Index, Index) { sums.add(strip); });
    return sums.averages(pairs(), known_correlation());
  }
  const auto [nx, ny] = grid().shape;
  const Index columns = columns_of_strip(grid(), request_.memory);
  for (Index first = 0; first < ny; first += columns) {
    Field strip = file_.columns(first, std::min(columns, ny - first));
    strip = (strip - mean_.base) - mean_.above;
    if (form_) form_->remove(strip, 0, first);
    sums.add(strip);
  }
  return sums.averages(pairs(), known_correlation());
}

DerivativeErrors StripSample::derivative_errors() {
  const DifferencePairs pairs(*pairs_);
  return acf_ ? derivative_errors_of_estimate(*acf_, pairs)
              : asperity::derivative_errors(*measured().drawn, pairs);
}

// Between the two heights beside it, as the material ratio curve has it.
std::vector<double> StripSample::quantiles(const std::vector<double>& shares) {
  const double last = points_ - 1;
  std::vector<std::uint64_t> ranks;
  for (const double share : shares) {
    const double below = std::min(std::floor(share * last), std::max(0.0, last - 1));
    ranks.push_back(static_cast<std::uint64_t>(below));
    ranks.push_back(static_cast<std::uint64_t>(std::min(below + 1, last)));
  }
  RankSelection selection(ranks);
  for (int pass = 0; pass < RankSelection::passes; ++pass) {
    for_each_strip(0, [&](const Field& strip, Index, Index) { selection.add(strip); });
    selection.end_pass();
  }
  std::vector<double> out;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double lower = selection.height(2 * i), upper = selection.height(2 * i + 1);
    out.push_back(lower + (shares[i] * last - static_cast<double>(ranks[2 * i])) * (upper - lower));
  }
  return out;
}

}  // namespace asperity::cli
