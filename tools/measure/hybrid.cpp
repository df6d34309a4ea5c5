// Slopes, spectral moments and summits: the group hybrid.
#include <cmath>
#include <numbers>
#include <type_traits>

#include "core/error.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/hybrid/summits.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/measure/rows.hpp"

namespace asperity::cli {
namespace {

// What a surface has, or why it has none.
template <class Value>
struct Had {
  Value value;
  std::string why;
};

template <class Compute, class Value = std::invoke_result_t<Compute>>
Had<Value> had(Compute compute, Value none) try {
  return {compute(), ""};
} catch (const DataError& error) {
  return {none, error.what()};
}

// With relative standard errors of m2 and m4.
void add_profile(Rows& out, const std::string& name, const ProfileSpectralMoments& m, double m2_error,
                 double m4_error, const std::string& where) {
  out.push_back({"m2_" + name, m.m2, "1", m.m2 * m2_error, "mean square slope " + where});
  out.push_back({"m4_" + name, m.m4, "m-2", m.m4 * m4_error, "mean square second derivative " + where});
  out.push_back({"alpha_" + name, m.bandwidth(), "1", unknown, "bandwidth parameter m0 m4 / m2^2 " + where});
}

void add_summits(Rows& out, const std::string& prefix, const Summits& s, const std::string& which) {
  const double any = s.density > 0 ? 1 : unknown;
  out.push_back({prefix + "density", s.density, "m-2", unknown, "summits per area, " + which});
  out.push_back(
      {prefix + "height", any * s.mean_height, "m", unknown, "their mean height above the mean, " + which});
  out.push_back({prefix + "deviation", any * s.height_deviation, "m", unknown,
                 "standard deviation of their heights, " + which});
  out.push_back(
      {prefix + "curvature", any * s.mean_curvature, "m-1", unknown, "their mean curvature, " + which});
  out.push_back({prefix + "radius", s.mean_curvature > 0 ? any * s.radius() : unknown, "m", unknown,
                 "1 / mean curvature, " + which});
}

// Of heights alone; each of them NaN where the surface has none.
struct Hybrid {
  Had<SlopeParameters> slopes;
  Had<SpectralMoments> moments;
  Had<CountedSummits> summits;
  Had<DerivativeErrors> errors;

  explicit Hybrid(Sample& sample)
      : slopes(had([&] { return of_heights(sample).slopes(); }, SlopeParameters{unknown, unknown})),
        moments(had([&] { return of_heights(sample).spectral_moments(); },
                    SpectralMoments{unknown, unknown, unknown, unknown, unknown, unknown, unknown, unknown,
                                    unknown})),
        summits(had([&] { return of_heights(sample).summits(); },
                    CountedSummits{{unknown, unknown, unknown, unknown}, unknown})),
        errors(had([&] { return of_heights(sample).derivative_errors(); },
                   DerivativeErrors{unknown, unknown, unknown, unknown, unknown})) {}

 private:
  static Sample& of_heights(Sample& sample) {
    if (sample.units() == "m") return sample;
    throw DataError(sample.variable(),
                    "slopes and areas are those of heights in m, not of " + sample.units());
  }
};

}  // namespace

Rows hybrid_rows(Sample& sample, const StatsOptions& options) {
  const Hybrid of(sample);
  const SlopeParameters& slopes = of.slopes.value;
  const SpectralMoments& m = of.moments.value;
  // √(2/ν) of ν independent ones.
  auto error = [least = sample.size().least_effective()](double relative) {
    return 2 >= least * relative * relative ? relative : unknown;
  };
  const DerivativeErrors& e = of.errors.value;
  const double square_slope = error(e.square_slope);
  Rows out{{"Sdq", slopes.sdq, "1", 0.5 * slopes.sdq * square_slope, "root mean square slope"},
           {"Sdr", slopes.sdr, "1", slopes.sdr * square_slope,
            "area beyond the plan area, as a share of it; four triangles a cell"}};
  explain(out, 0, of.slopes.why);
  const std::size_t first = out.size();
  out.push_back({"m0", m.m00, "m2", m.m00 * error(std::sqrt(2 / sample.size().effective(2))),
                 "spectral moment of order 0, Sq squared"});
  add_profile(out, "x", m.along(0), error(e.m20), error(e.m40), "along x");
  add_profile(out, "y", m.along(std::numbers::pi / 2), error(e.m02), error(e.m04), "along y");
  if (!options.direction.empty())
    add_profile(out, "direction", m.along(parse_angle("direction", options.direction)), unknown, unknown,
                "at " + options.direction);
  explain(out, first, of.moments.why.empty() ? "no value: there is no slope along it" : of.moments.why);
  const std::size_t counted = out.size();
  add_summits(out, "summit_", of.summits.value, "counted");
  explain(out, counted, of.summits.why.empty() ? "no value: there is no summit" : of.summits.why);
  const std::size_t expected = out.size();
  add_summits(out, "nayak_", expected_summits(m.isotropic()), "expected of a Gaussian surface");
  explain(
      out, expected,
      of.moments.why.empty() ? "no value: no Gaussian surface has such spectral moments" : of.moments.why);
  return out;
}

}  // namespace asperity::cli
