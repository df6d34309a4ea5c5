// Tables of spectra: power laws between their rows, and Abel's transform of those of profiles.
#include "acf/radial_spectrum.hpp"

#include <functional>
#include <random>
#include <string>

#include "core/error.hpp"
#include "waves.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

SpectrumRows table_of_law(double first, double last, double ratio, const std::function<double(double)>& law) {
  SpectrumRows out;
  for (double q = first; q < last * (1 + 1e-9); q *= ratio) out.q.push_back(q), out.density.push_back(law(q));
  return out;
}

std::function<double(double)> power_law(double factor, double exponent) {
  return [=](double q) { return factor * std::pow(q, -exponent); };
}

}  // namespace

TEST_CASE("a power law in two rows is itself between them, nothing beyond, with its integral for a height",
          "[psd][exact]") {
  for (const double s : {0.0, 2.0, 3.6, 4.0}) {
    const RadialSpectrum c(table_of_law(2e3, 2e4, 10, power_law(7, s)));
    CAPTURE(s);
    for (const double q : {2e3, 3.3e3, 1.9e4})
      CHECK(relative_error(c(q), 7 * std::pow(q, -s)) <= 100 * epsilon);
    CHECK(c(1.9e3) == 0);
    CHECK(c(2.1e4) == 0);
    const double a = 2e3, b = 1.2e4;
    const double sum = s == 2 ? std::log(b / a) : (std::pow(b, 2 - s) - std::pow(a, 2 - s)) / (2 - s);
    CHECK(relative_error(c.mean_square(1, b), 7 * sum / turn) <= 100 * epsilon);
  }
}

// Of C = 1, the area between the square and the circle, over (2π)². A ring has the share of its middle: with
// 48 an octave, 1.4 % wide, within 1e-3 of the area beyond a square that the circle goes around.
TEST_CASE("what the grid does not show is the power beyond its sides, corners counted", "[psd][law]") {
  const RadialSpectrum flat({{1, 10}, {1, 1}});
  const double within = turn / 2 * (100 - 1), unit = turn * turn;
  CHECK(flat.mean_square_beyond(10, 10) <= 1e-12);
  CHECK(relative_error(flat.mean_square_beyond(5, 5), (within - (100 - turn / 2)) / unit) <= 1e-3);
  CHECK(relative_error(flat.mean_square_beyond(5, 100),
                       2 * (100 * std::acos(0.5) - 5 * std::sqrt(75)) / unit) <= 2e-3);
}

// C1 = A q^-s is 1/π ∫ C(√(q² + v²)) dv of C = √π s Γ((s+1)/2)/Γ(s/2+1) A q^-(s+1).
TEST_CASE("the profiles of a power law give its surface, to the last row", "[psd][exact]") {
  for (const double s : {1.5, 2.6, 3.0, 4.4}) {
    const double factor = std::sqrt(turn / 2) * s * std::tgamma((s + 1) / 2) / std::tgamma(s / 2 + 1);
    for (const auto& [ratio, tolerance] :
         {std::pair{1.1, 1e-6}, {std::sqrt(2), 1e-6}, {10.0, 1e-5}, {1.01, 1e-2}}) {
      const ProfileSpectrum c = spectrum_of_profiles(table_of_law(1e4, 1e6, ratio, power_law(3, s)));
      CAPTURE(s, ratio);
      CHECK(c.change == 0);
      for (const double q : {1.1e4, 2e4, 3.7e5, 7e5})
        CHECK(relative_error(c.spectrum(q), 3 * factor * std::pow(q, -s - 1)) <= tolerance);
    }
  }
}

// C1 = (1 + q²)^-1 has C = π (1 + q²)^-3/2, a correlation exp(-r). ln G is within (ln ratio)² of its chords.
TEST_CASE("the profiles of an exponential correlation give its surface at order 2 in the step of ln q",
          "[psd][order]") {
  double coarse = 0;
  for (const double ratio : {1.96, 1.4, 1.18321595661992}) {
    const ProfileSpectrum c =
        spectrum_of_profiles(table_of_law(0.01, 1000, ratio, [](double q) { return 1 / (1 + q * q); }));
    double error = 0;
    for (double q = 0.1; q < 30; q *= 1.05)
      error = std::max(error, relative_error(c.spectrum(q), turn / 2 * std::pow(1 + q * q, -1.5)));
    CAPTURE(ratio, coarse, error);
    CHECK(error <= 0.5 * std::pow(std::log(ratio), 2));
    if (coarse > 0) CHECK(coarse / error >= 3);
    coarse = error;
  }
}

// Waves of one direction: C1 has a peak that no isotropic surface has.
TEST_CASE("profiles that no isotropic surface has are refused", "[psd][contract]") {
  CHECK_THROWS_AS(spectrum_of_profiles({{1, 2, 3, 4, 5, 6}, {1e-3, 1e-3, 1, 1, 1e-3, 1e-4}}), DataError);
  CHECK_THROWS_AS(spectrum_of_profiles({{1, 2}, {1e-3, 1}}), DataError);
}

// C1 of n profiles is C1 χ²/ν. The power of the waves beyond q, a sum over many rows, keeps that chance small:
// of 200 rows of ν = 20, each of a standard deviation of 0.32, σ² within 4 times 0.32 √(Σ C1²)/Σ C1.
TEST_CASE("a spectrum of profiles with its chance gives the power of the surface at both sides of a wave",
          "[psd][statistics]") {
  const auto exact = [](double q) { return 1 / (1 + q * q); };
  SpectrumRows rows;
  std::mt19937_64 generator(7);
  std::chi_squared_distribution<double> chance(20);
  double sum = 0, squares = 0;
  for (int k = 1; k <= 200; ++k) {
    rows.q.push_back(0.1 * k), rows.density.push_back(exact(0.1 * k) * chance(generator) / 20);
    sum += exact(0.1 * k), squares += std::pow(exact(0.1 * k), 2);
  }
  const ProfileSpectrum c = spectrum_of_profiles(rows);
  CHECK(c.change <= 0.05);
  const double tolerance = 4 * 0.32 * std::sqrt(squares) / sum;
  for (const auto& [low, high] : {std::pair{0.1, 20.0}, {0.1, 2.0}, {1.0, 20.0}}) {
    const auto power = [](double q) { return turn / 2 / std::sqrt(1 + q * q) / turn; };  // of shorter waves
    CAPTURE(low, high);
    CHECK(relative_error(c.spectrum.mean_square(low, high), power(low) - power(high)) <= tolerance);
  }
}

TEST_CASE("rows that are no spectrum are refused by their number", "[psd][contract]") {
  const auto said = [](const SpectrumRows& rows) -> std::string {
    try {
      spectrum_of_profiles(rows), RadialSpectrum{rows};
    } catch (const DataError& e) {
      return e.what();
    }
    return "";
  };
  CHECK(said({{1}, {1}}).starts_with("it has 1 row"));
  CHECK(said({{1, 2, 2}, {1, 1, 1}}).starts_with("row 3: the wave number 2 follows 2"));
  CHECK(said({{0, 2}, {1, 1}}).starts_with("row 1: the wave number 0 must be above 0"));
  CHECK(said({{1, NAN}, {1, 1}}).starts_with("row 2: the wave number"));
  CHECK(said({{1, 2}, {1, 0}}).starts_with("row 2: the density 0 must be above 0"));
  CHECK(said({{1, 2}, {-1, 1}}).starts_with("row 1: the density -1"));
  CHECK(said({{1, 2, 21}, {1, 1, 1}}).starts_with("row 3: a gap"));
  CHECK(said({{1, 10}, {1, 1}}).empty());
}
