/// The field that asperity-stats measures, whole in memory or in strips from a file, and what several groups of
/// parameters need of it, computed once, when first needed.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "dataset/field_file.hpp"
#include "stats/height/height_runs.hpp"
#include "stats/height/material_ratio.hpp"
#include "stats/hybrid/derivative_error.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/hypothesis/gaussianity.hpp"
#include "stats/profile/profile.hpp"
#include "stats/spatial/strip_acf.hpp"
#include "stats/uncertainty/translation_error.hpp"
#include "tools/measure/measured.hpp"

namespace asperity::cli {

/// What a field has to tell, whole or not.
class Sample {
 public:
  Sample(Measured measured, const std::string& variable)
      : measured_(std::move(measured)), variable_(variable) {}
  virtual ~Sample() = default;

  const Measured& measured() const { return measured_; }  ///< in strips without heights
  const Grid& grid() const { return measured_.grid; }
  const std::string& units() const { return measured_.units; }
  const std::string& variable() const { return variable_; }

  virtual const Moments& moments() = 0;
  virtual const Pairs& pairs() = 0;
  virtual const EffectiveSampleSize& size() = 0;
  /// Of the Gaussian field below heights of this map.
  virtual EffectiveSampleSize size_below(const CorrelationMap& map) = 0;
  virtual DerivativeErrors derivative_errors() = 0;
  virtual SlopeParameters slopes() = 0;
  virtual SpectralMoments spectral_moments() = 0;
  virtual CountedSummits summits() = 0;
  /// Heights below which these shares of the surface lie.
  virtual std::vector<double> quantiles(const std::vector<double>& shares) = 0;
  virtual MaterialRatioCurve material_ratio() = 0;
  virtual std::array<GoodnessOfFit, 4> goodness_of_fit() = 0;
  virtual ProfileAverages profiles(Axis1D along, double section) = 0;

 protected:
  Measured measured_;

 private:
  std::string variable_;
};

class WholeSample : public Sample {
 public:
  WholeSample(Measured measured, const std::string& variable, int threads);

  const Field& heights() const { return measured().heights; }
  int threads() const { return threads_; }
  const LagField& acf();  ///< estimated up to default_max_lag

  const Moments& moments() override { return moments_; }
  const Pairs& pairs() override;
  const EffectiveSampleSize& size() override;
  EffectiveSampleSize size_below(const CorrelationMap& map) override;
  DerivativeErrors derivative_errors() override;
  SlopeParameters slopes() override { return slope_parameters(heights(), grid(), threads_); }
  SpectralMoments spectral_moments() override {
    return asperity::spectral_moments(heights(), grid(), threads_);
  }
  CountedSummits summits() override { return counted_summits(heights(), grid(), threads_); }
  std::vector<double> quantiles(const std::vector<double>& shares) override;
  MaterialRatioCurve material_ratio() override { return MaterialRatioCurve(heights(), threads_); }
  std::array<GoodnessOfFit, 4> goodness_of_fit() override {
    return GaussianityTest(size())(heights(), moments());
  }
  ProfileAverages profiles(Axis1D along, double section) override;

 private:
  int threads_;
  Moments moments_;
  std::optional<Pairs> pairs_;
  std::optional<LagField> acf_;
  std::optional<EffectiveSampleSize> size_;
};

/// Read in strips of whole rows: once for the mean, two or three times for a form, once for the moments, derivatives
/// and the correlation, once for the order of the heights, once for profiles (along x in strips of columns), and four
/// times for quantiles.
class StripSample : public Sample {
 public:
  struct Request {
    bool derivatives = false;  ///< slopes, spectral moments, summits
    std::size_t memory = 0;
    int threads = 1;
  };
  StripSample(const FieldFile& file, const MeasuredOptions& options, const Request& request);

  /// Whether errors rest on a correlation that is longer than the strips.
  bool correlation_reaches_beyond() const { return reaches_beyond_; }
  Index rows() const { return rows_; }  ///< of a strip

  const Moments& moments() override { return moments_; }
  const Pairs& pairs() override { return *pairs_; }
  const EffectiveSampleSize& size() override { return *size_; }
  EffectiveSampleSize size_below(const CorrelationMap& map) override;
  DerivativeErrors derivative_errors() override;
  SlopeParameters slopes() override { return slope_sums_.parameters(grid()); }
  SpectralMoments spectral_moments() override { return spectral_sums_.moments(grid()); }
  CountedSummits summits() override { return summit_sums_.summits(grid()); }
  std::vector<double> quantiles(const std::vector<double>& shares) override;
  MaterialRatioCurve material_ratio() override { return MaterialRatioCurve(runs()); }
  std::array<GoodnessOfFit, 4> goodness_of_fit() override {
    return GaussianityTest(size())(runs(), moments());
  }
  ProfileAverages profiles(Axis1D along, double section) override;

 private:
  /// visit(strip, own rows, first): with `behind` rows more, as a Strip has them, above the mean and the form.
  template <class Visit>
  void for_each_strip(Index behind, Visit visit) const;
  void measure_level();
  void fit_form(int degree);
  void measure();
  void find_correlation();
  /// The correlation that errors rest on, zero where it is not known.
  LagField known_correlation() const;
  const std::vector<HeightRun>& runs();

  const FieldFile& file_;
  Request request_;
  Index rows_;
  Mean mean_;
  std::optional<FormFit> form_;
  double points_ = 0, largest_ = 0;  ///< that are there; the size of the largest
  Moments moments_;
  SlopeSums slope_sums_;
  SpectralMomentSums spectral_sums_;
  SummitSums summit_sums_;
  std::optional<StripAutocorrelation>
      correlation_;  ///< where the dataset carries none, or points are missing
  std::optional<LagField> acf_;
  std::optional<Pairs> pairs_;
  std::optional<EffectiveSampleSize> size_;
  std::optional<std::vector<HeightRun>> runs_;
  bool reaches_beyond_ = false;
};

}  // namespace asperity::cli
