#include <limits>
#include <vector>

#include "marginal/johnson.hpp"
#include "marginal/measured.hpp"
#include "marginal/predistortion.hpp"
#include "marginal/prescribed.hpp"
#include "reference/exponential_target.hpp"
#include "stability.hpp"

namespace asperity {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = NAN;

double difference(const HeightMoments& m, double skewness, double kurtosis) {
  return std::max({std::abs(m.mean), std::abs(m.variance - 1),
                   std::abs(m.skewness - skewness) / std::max(1.0, std::abs(skewness)),
                   std::abs(m.kurtosis / kurtosis - 1)});
}

// Moments by the trapezoidal rule in y, which is not the fit's.
Finding fitted(double skewness, double kurtosis) {
  const Johnson j = fit_johnson(skewness, kurtosis);
  const HeightMoments m = height_moments(johnson_translation(skewness, kurtosis));
  return {fmt::format("{}, delta = {:.3g}", name_of(j.family), j.delta), "error of the moments",
          difference(m, skewness, kurtosis), 1e-9};
}

void fits(const StabilityTable& table) {
  for (double skewness : {0.0, 1.0, -3.0, 50.0})
    table.answered(fmt::format("skewness {:g}, the least kurtosis", skewness), "nearly two values",
                   [&] { return fitted(skewness, least_kurtosis(skewness)); });
  for (double skewness : {0.0, 50.0})
    table.answered(fmt::format("skewness {:g}, kurtosis 1e4", skewness), "the far corner of the plane",
                   [&] { return fitted(skewness, 1e4); });
  for (double excess : {1e-13, 1e-11, -1e-11, 1e-6})
    table.answered(fmt::format("skewness 0, kurtosis 3 {:+g}", excess),
                   "delta without bound towards the normal", [&] { return fitted(0, 3 + excess); });
  table.answered("skewness 1e-9, kurtosis 3", "beside the normal, below S_L", [] { return fitted(1e-9, 3); });
  // On S_L with w = 1.2.
  const double w = 1.2, skewness = (w + 2) * std::sqrt(w - 1), kurtosis = w * w * (w * w + 2 * w + 3) - 3;
  for (double beside : {-1e-11, 0.0, 1e-11})
    table.answered(fmt::format("lognormal, kurtosis times 1 {:+g}", beside),
                   "gamma without bound towards S_L",
                   [&] { return fitted(skewness, kurtosis * (1 + beside)); });
  table.answered("heights of 38 sigma, skewness 3, kurtosis 20", "the largest that a normal number reaches",
                 [] {
                   const Johnson j = fit_johnson(3, 20);
                   const double largest = std::max(std::abs(j(38.0)), std::abs(j(-38.0)));
                   return Finding{"finite", "height / sigma", largest, 1e300};
                 });
}

void pairs_that_are_none(const StabilityTable& table) {
  auto refused = [&](const char* hard, double skewness, double kurtosis) {
    table.refused(fmt::format("skewness {:g}, kurtosis {:g}", skewness, kurtosis), hard,
                  [=] { fit_johnson(skewness, kurtosis); });
  };
  refused("on the edge K = Sk^2 + 1", 2, 5);
  refused("beyond the edge", 2, 4);
  refused("beyond the scope", 51, 9e3);
  refused("beyond the scope", 0, 1.1e4);
  refused("no number", nan, 3);
  refused("no number", 0, nan);
  refused("no number", 0, infinity);
  table.answered("kurtosis 1.01, automatic", "0.007 below the least", [] {
    const HeightMoments m = height_moments(PrescribedHeights{0, 1.01}.translation());
    return Finding{"the least kurtosis in its place", "change", m.kurtosis - 1.01, 1e-2};
  });
  table.refused("kurtosis 1, automatic", "0.017 below the least", [] {
    PrescribedHeights{0, 1}.translation();
  });
  table.answered("kurtosis 1, nearest", "0.017 below the least", [] {
    const HeightMoments m = height_moments(PrescribedHeights{0, 1, InfeasiblePolicy::nearest}.translation());
    return Finding{"the least kurtosis in its place", "change", m.kurtosis - 1, 2e-2};
  });
  const Field wide = Field::Constant(31, 31, 1.0 / 31);
  table.refused("noise for skewness 2, averaged over 31 x 31", "noise of skewness 62", [&] {
    PrescribedHeights{2, 10}.noise(wide);
  });
  table.refused("noise for kurtosis 2.9, averaged over 31 x 31", "noise of kurtosis -93", [&] {
    PrescribedHeights{0, 2.9}.noise(wide);
  });
}

KernelRequest exponential(Index lags, InfeasiblePolicy infeasible = InfeasiblePolicy::automatic) {
  KernelRequest out;
  const double length = static_cast<double>(lags) / 2;
  out.target = ExponentialTarget{length, length};
  out.lags = {lags, lags};
  out.infeasible = infeasible;
  return out;
}

void correlations(const StabilityTable& table) {
  for (auto [skewness, kurtosis] : {std::pair{0.0, 1.02}, {3.0, 20.0}, {-10.0, 200.0}, {0.0, 1e4}})
    table.answered(fmt::format("correlation of skewness {:g}, kurtosis {:g} and back", skewness, kurtosis),
                   "a steep map", [skewness = skewness, kurtosis = kurtosis] {
                     const CorrelationMap map(johnson_translation(skewness, kurtosis));
                     double worst = 0;
                     for (double r : {-0.01, 0.0, 0.01, 0.5, 0.99, 1.0})
                       if (r >= map.lowest()) worst = std::max(worst, std::abs(map(map.inverse(r)) - r));
                     return Finding{fmt::format("{} orders", map.orders()), "error of R", worst, 1e-9};
                   });
  table.answered(
      "predistorted kernel, skewness 3, kurtosis 20", "correlations far from those of the heights", [] {
        const Kernel k = Predistortion(johnson_translation(3, 20)).solve(exponential(15));
        return Finding{std::string(name_of(k.report.answer)), "residual", k.report.residual, 1e-10};
      });
  KernelRequest wave = exponential(15);
  wave.target =
      Target([](double p, double q) { return std::exp(-0.2 * std::hypot(p, q)) * std::cos(0.6 * p); });
  table.refused("correlation of -0.36 of skewness 10", "peaks have no valleys to stand against",
                [&] { Predistortion(johnson_translation(10, 400)).solve(wave); });
}

void measured(const StabilityTable& table) {
  auto sample = [](std::size_t n, auto value) {
    std::vector<double> out(n);
    for (std::size_t i = 0; i < n; ++i) out[i] = value(i);
    return out;
  };
  auto distribution = [&](const char* name, const char* hard, std::vector<double> heights) {
    table.answered(name, hard, [&] {
      const HeightMoments m = height_moments(MeasuredHeights::of(heights).translation());
      return Finding{fmt::format("skewness {:.2g}, kurtosis {:.3g}", m.skewness, m.kurtosis),
                     "error of mean and variance", std::max(std::abs(m.mean), std::abs(m.variance - 1)),
                     1e-3};
    });
  };
  distribution("measured: two values", "a step",
               sample(1000, [](std::size_t i) { return i % 2 == 0 ? 0.0 : 1.0; }));
  distribution("measured: one spike in 1000", "kurtosis 1000",
               sample(1000, [](std::size_t i) { return i == 7 ? 1.0 : 0.0; }));
  distribution("measured: 1 nm on an offset of 1 m", "cancellation",
               sample(1000, [](std::size_t i) { return 1 + 1e-12 * static_cast<double>(i); }));
  auto refused = [&](const char* name, const char* hard, std::vector<double> heights) {
    table.refused(name, hard, [&] { MeasuredHeights::of(heights); });
  };
  refused("measured: all the same", "no spread", std::vector<double>(1000, 1.0));
  refused("measured: 99 heights", "too few",
          sample(99, [](std::size_t i) { return static_cast<double>(i); }));
  refused("measured: a NaN among them", "no number",
          sample(200, [](std::size_t i) { return i == 3 ? nan : 1.0 * static_cast<double>(i); }));
}

}  // namespace

void marginal_stability() {
  const StabilityTable table("marginal");
  fits(table);
  pairs_that_are_none(table);
  correlations(table);
  measured(table);
}

}  // namespace asperity
