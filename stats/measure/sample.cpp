#include "stats/measure/sample.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "stats/height/height_steps.hpp"
#include "stats/hypothesis/stepped.hpp"
#include "stats/spatial/strip_acf.hpp"
#include "stats/uncertainty/translation_error.hpp"

namespace asperity {
namespace {

SurfaceSums summed(const Surface& surface, ErrorBasis basis, bool derivatives, int threads) {
  DerivativeSums sums;
  if (derivatives) sums.add(Strip::whole(surface.heights, surface.grid), mean(surface.heights), threads);
  return {moments(surface.heights, surface.variable, *surface.ranks), sums, std::move(basis)};
}

SurfaceSums summed(const StripReader& reader, const Surface& surface, bool derivatives, int threads) {
  const Grid& grid = reader.grid();
  const bool known = surface.correlation.has_value(),
             needs_lags = !known || reader.points() < static_cast<double>(grid.shape.cells());
  StripAutocorrelation correlation(grid, reader.rows(), threads);
  std::optional<StripAutocorrelation> modes;  // of a form on an outline
  if (reader.form() && !reader.form()->complete()) modes.emplace(grid, reader.rows(), threads);
  MomentSums moments(Mean{});
  DerivativeSums sums;
  reader.for_each_strip(derivatives ? 2 : 0, [&](const Field& strip, Index core, Index first) {
    moments.add(strip.topRows(core));
    if (derivatives) sums.add({strip, grid, core}, 0, threads);
    if (needs_lags) correlation.add(strip.topRows(core));
    if (modes) FormModes::add(*modes, *reader.form(), strip.topRows(core), first);
  });
  const Moments m = moments.moments(surface.variable);
  refuse_round_off(std::max(m.sp, m.sv), reader.largest(), {.degree = reader.degree()}, surface.variable);
  const ErrorBasis basis{known ? *surface.correlation : correlation.estimate(), !known, correlation.pairs(),
                         modes && surface.degree <= reader.degree()
                             ? FormModes(grid, *reader.form(), *modes)
                             : FormModes(grid, std::max(surface.degree, reader.degree()))};
  return {m, sums, basis, needs_lags && correlation.reaches_beyond(basis.known_lags())};
}

}  // namespace

void DerivativeSums::add(const Strip& strip, double level, int threads) {
  slopes.add(strip, threads);
  spectral.add(strip, level, threads);
  summits.add(strip, level, threads);
}

Sample::Sample(Surface surface, bool derivatives, int threads)
    : surface_(std::move(surface)),
      sums_(summed(surface_, error_basis(surface_, threads), derivatives, threads)),
      size_(basis().size()),
      threads_(threads) {}

Sample::Sample(Surface surface, ErrorBasis basis, const EffectiveSampleSize& size, bool derivatives)
    : surface_(std::move(surface)),
      sums_(summed(surface_, std::move(basis), derivatives, 1)),
      size_(size),
      threads_(1),
      errors_(false) {}

Sample::Sample(const StripReader& reader, Surface surface, bool derivatives, int threads)
    : surface_(std::move(surface)),
      reader_(reader),
      sums_(summed(reader, surface_, derivatives, threads)),
      size_(basis().size()),
      threads_(threads) {
  surface_.level = reader.level();
  surface_.degree = std::max(surface_.degree, reader.degree());
  surface_.largest = reader.largest();
  surface_.step = reader.step();
}

double Sample::round_off() const {
  return round_off_of(std::max({surface_.largest, moments().sp, moments().sv}));
}

SpectralMoments Sample::spectral_moments() const {
  return sums_.derivatives.spectral.moments(grid()).without_round_off(grid(), round_off());
}

CountedSummits Sample::summits() const {
  const CountedSummits counted = sums_.derivatives.summits.summits(grid());
  const SpectralMoments m = spectral_moments();
  if (m.m20 > 0 && m.m02 > 0) return counted;
  CountedSummits none;
  none.density = 0;
  return none;
}

std::optional<Translation> Sample::distribution() const {
  return surface_.distribution ? surface_.distribution
                               : evident_translation(moments(), standard_errors(moments(), size_));
}

const FieldExtent& Sample::extent() const {
  if (!extent_) extent_ = basis().extent();
  return *extent_;
}

template <class Sums>
void Sample::add_all(Sums& sums) const {
  if (reader_)
    reader_->for_each_strip(0, [&](const Field& strip, Index, Index) { sums.add(strip, threads_); });
  else
    sums.add(surface_.heights, threads_);
}

const std::optional<HeightErrors>& Sample::height_errors() const {
  if (errors_ && !height_errors_) {
    height_errors_.emplace(grid(), moments().mean, moments().sq, surface_.degree);
    if (whole())
      height_errors_->add(surface_.heights, threads_, *surface_.ranks);
    else
      add_all(*height_errors_);
    height_errors_->finish(extent());
  }
  return height_errors_;
}

double Sample::taken_by_form() const {
  return taken_from_waves() ? height_errors()->taken() : size_.taken_by_form();
}

double Sample::error_of_taken() const {
  return taken_from_waves() ? std::sqrt(2 / height_errors()->degrees_of_mean()) : 0;
}

std::optional<QuantileErrors> Sample::quantile_errors(const std::vector<double>& heights) const {
  if (!errors_) return std::nullopt;
  QuantileErrors out(grid(), extent(), heights);
  add_all(out);
  out.finish();
  return out;
}

std::optional<DerivativeErrors> Sample::derivative_errors() const {
  if (!errors_) return std::nullopt;
  DerivativeErrors out(grid());
  if (reader_)
    reader_->for_each_strip(2, [&](const Field& strip, Index core, Index) {
      out.add({strip, grid(), core}, 0, threads_);
    });
  else
    out.add(Strip::whole(surface_.heights, grid()), moments().mean, threads_);
  out.finish(extent());
  return out;
}

std::optional<SizeErrors> Sample::size_errors() const {
  if (!errors_ || !whole() || !basis().estimated || !size_.gives_errors()) return std::nullopt;
  return SizeErrors(surface_.heights, basis().correlation, basis().pairs, basis().form, extent(), size_,
                    threads_);
}

MaterialRatioCurve Sample::material_ratio() const {
  return reader_ ? MaterialRatioCurve(bins()) : MaterialRatioCurve(surface_.heights, threads_);
}

std::array<GoodnessOfFit, 4> Sample::goodness_of_fit() const {
  const std::vector<HeightBin> runs = reader_ ? bins() : runs_of_equal(surface_.heights);
  if (const HeightSteps steps = height_steps(runs); steps.step > 0) {
    const bool lost = basis().estimated && before_rounding(moments(), steps.step).sq > 0;
    return gaussianity_of_steps(
        runs, moments(), steps,
        lost ? basis().size(before_rounding(basis().correlation.normalised(), moments(), steps.step))
             : size_);
  }
  const GaussianityTest test(size_);
  return reader_ ? test(runs, moments()) : test(surface_.heights, moments());
}

ProfileAverages Sample::profiles(Axis1D along, double section) const {
  ProfileSums sums(grid(), along, section, round_off());
  if (!reader_)
    sums.add(surface_.heights);
  else if (along == Axis1D::y)
    reader_->for_each_strip(0, [&](const Field& strip, Index, Index) { sums.add(strip); });
  else
    reader_->for_each_columns([&](const Field& columns) { sums.add(columns); });
  return sums.averages(basis().pairs, basis().known_lags());
}

std::vector<double> Sample::quantiles(const std::vector<double>& shares) const {
  if (reader_) return selected(shares);
  const MaterialRatioCurve curve = material_ratio();
  std::vector<double> out(shares.size());
  std::ranges::transform(shares, out.begin(), [&](double share) { return curve.quantile(share); });
  return out;
}

// Between the two heights beside it, as the material ratio curve has it.
std::vector<double> Sample::selected(const std::vector<double>& shares) const {
  const double last = reader_->points() - 1;
  std::vector<std::uint64_t> ranks;
  for (const double share : shares) {
    const double below = std::min(std::floor(share * last), std::max(0.0, last - 1));
    ranks.push_back(static_cast<std::uint64_t>(below));
    ranks.push_back(static_cast<std::uint64_t>(std::min(below + 1, last)));
  }
  RankSelection selection(ranks);
  for (int pass = 0; pass < RankSelection::passes; ++pass) {
    reader_->for_each_strip(0, [&](const Field& strip, Index, Index) { selection.add(strip); });
    selection.end_pass();
  }
  std::vector<double> out;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double lower = selection.height(2 * i), upper = selection.height(2 * i + 1);
    out.push_back(lower + (shares[i] * last - static_cast<double>(ranks[2 * i])) * (upper - lower));
  }
  return out;
}

const std::vector<HeightBin>& Sample::bins() const {
  if (!bins_) {
    HeightBins bins(moments());
    reader_->for_each_strip(0, [&](const Field& strip, Index, Index) { bins.add(strip); });
    bins_ = bins.ascending();
  }
  return *bins_;
}

}  // namespace asperity
