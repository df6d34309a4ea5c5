#include "stats/measure/sample.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "stats/height/distribution.hpp"
#include "stats/hypothesis/gaussianity.hpp"
#include "stats/uncertainty/translation_error.hpp"

namespace asperity {

Sample::Sample(Surface surface, int threads)
    : surface_(std::move(surface)),
      moments_(asperity::moments(surface_.heights, surface_.variable)),
      basis_(error_basis(surface_, threads)),
      size_(basis_.size()),
      threads_(threads) {}

Sample::Sample(Surface surface, ErrorBasis basis, const EffectiveSampleSize& size)
    : surface_(std::move(surface)),
      moments_(asperity::moments(surface_.heights, surface_.variable)),
      basis_(std::move(basis)),
      size_(size),
      threads_(1),
      errors_(false) {}

double Sample::round_off() const {
  return round_off_of(std::max({surface_.largest, moments().sp, moments().sv}));
}

const SpectralMoments& Sample::spectral_moments() const {
  if (!spectral_)
    spectral_ =
        asperity::spectral_moments(surface_.heights, grid(), threads_).without_round_off(grid(), round_off());
  return *spectral_;
}

const CountedSummits& Sample::summits() const {
  if (summits_) return *summits_;
  summits_ = counted_summits(surface_.heights, grid(), 0, threads_);
  if (const SpectralMoments& m = spectral_moments(); !(m.m20 > 0 && m.m02 > 0)) {
    summits_.emplace();
    summits_->density = 0;
  }
  return *summits_;
}

std::optional<Translation> Sample::distribution() const {
  return surface_.distribution ? surface_.distribution
                               : evident_translation(moments(), standard_errors(moments(), size_));
}

const FieldExtent& Sample::extent() const {
  if (!extent_) extent_ = basis().extent();
  return *extent_;
}

const std::optional<HeightErrors>& Sample::height_errors() const {
  if (errors_ && !height_errors_)
    height_errors_.emplace(surface_.heights, grid(), extent(), moments(), surface_.degree, threads_);
  return height_errors_;
}

double Sample::taken_by_form() const {
  return taken_from_waves() ? height_errors()->taken() : size_.taken_by_form();
}

double Sample::error_of_taken() const { return taken_from_waves() ? height_errors()->error_of_taken() : 0; }

std::optional<QuantileErrors> Sample::quantile_errors(const std::vector<double>& heights) const {
  if (!errors_) return std::nullopt;
  return QuantileErrors(surface_.heights, grid(), extent(), heights);
}

std::optional<MaterialErrors> Sample::material_errors(const MaterialRatioCurve& curve,
                                                      const std::array<double, 2>& ratios) const {
  if (!errors_) return std::nullopt;
  return asperity::material_errors(surface_.heights, grid(), extent(), curve, ratios);
}

std::optional<DerivativeErrors> Sample::derivative_errors() const {
  if (!errors_) return std::nullopt;
  return DerivativeErrors(surface_.heights, grid(), extent(), threads_);
}

std::optional<SizeErrors> Sample::size_errors() const {
  if (!errors_ || !basis().estimated || !size_.gives_errors()) return std::nullopt;
  return SizeErrors(surface_.heights, basis().correlation, basis().pairs, basis().form, extent(), size_,
                    threads_);
}

MaterialRatioCurve Sample::material_ratio() const { return MaterialRatioCurve(surface_.heights, threads_); }

std::array<GoodnessOfFit, 4> Sample::goodness_of_fit() const {
  const std::vector<HeightRun> runs = runs_of_equal(surface_.heights);
  if (const HeightSteps steps = height_steps(runs); steps.step > 0) {
    const bool lost = basis().estimated && before_rounding(moments(), steps.step).sq > 0;
    return gaussianity_of_steps(
        runs, moments(), steps,
        lost ? basis().size(before_rounding(basis().correlation.normalised(), moments(), steps.step))
             : size_);
  }
  return GaussianityTest(size_)(surface_.heights, moments());
}

ProfileAverages Sample::profiles(Axis1D along, double section, const std::array<double, 2>& ratios) const {
  return average_profiles(surface_.heights, basis().pairs, extent(), along, section, basis().known_lags(),
                          round_off(), ratios);
}

std::vector<double> Sample::quantiles(const std::vector<double>& shares) const {
  const MaterialRatioCurve curve = material_ratio();
  std::vector<double> out(shares.size());
  std::ranges::transform(shares, out.begin(), [&](double share) { return curve.quantile(share); });
  return out;
}

}  // namespace asperity
