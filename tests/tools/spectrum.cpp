// Surfaces of a prescribed spectrum, and of a prescribed slope.
#include <array>
#include <functional>
#include <numbers>
#include <utility>

#include "core/words.hpp"
#include "stats/hybrid/slopes.hpp"
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// The mean of Sdq² over surfaces, and its standard error by their spread.
std::pair<double, double> mean_square_slope(const std::string& options, int count) {
  require("asperity-generate -q --seed 5 " + options + " --count " + std::to_string(count) +
          " -o slope_%d.nc");
  double sum = 0, squares = 0;
  for (int n = 0; n < count; ++n) {
    const Dataset data = read_dataset("slope_" + std::to_string(n) + ".nc");
    const double s = std::pow(slope_parameters(field_of(data, "heights"), grid_of(data)).sdq, 2);
    sum += s, squares += s * s;
  }
  const double mean = sum / count;
  return {mean, std::sqrt((squares / count - mean * mean) / (count - 1))};
}

// Rows of a density at wave numbers in rad/um.
std::string table(const std::string& header, double first, double last, double ratio,
                  const std::function<double(double)>& density) {
  std::string out = header + "\n";
  for (double q = first; q < last * ratio; q *= ratio)
    out += std::to_string(q) + " " + shortest(density(std::stod(std::to_string(q)))) + "\n";
  return out;
}

Field target_of(const std::string& options) {
  require("asperity-kernel -q " + options + " -o target.nc");
  return table_of(read_dataset("target.nc"), "acf_target", "m2");
}

}  // namespace

// The mean of 50 stays within 4 of its standard errors.
TEST_CASE("the ensemble has the rms slope that was prescribed, as asperity-stats measures it",
          "[slope][statistics]") {
  for (const char* options :
       {"--shape 64x48 --size 64um,96um --model gaussian --length 8um",
        "--shape 64x48 --size 64um,96um --model exponential --length 8um",
        "--shape 64x64 --size 64um --periodic --model self-affine --rolloff 30um --cutoff 5um",
        "--shape 48x48 --size 64um --model matern --length 9um --skewness -1 --kurtosis 6",
        "--shape 48x48 --size 64um --model matern --length 9um --method filter --skewness -0.5 --kurtosis "
        "4"}) {
    const auto [mean, error] = mean_square_slope(std::string(options) + " --rms-slope 0.2", 50);
    CAPTURE(options, mean, error);
    CHECK(std::abs(mean - 0.04) <= 4 * error);
    CHECK(error <= 0.03 * 0.04);
  }
}

// (1) of tools/surface/kernel_options.hpp, of the correlation on record.
TEST_CASE("the height follows from the slope by the correlation of neighbours, drawn from a kernel too",
          "[slope][exact]") {
  const auto slope_on_record = [](const std::string& name) {
    const Dataset data = read_dataset(name);
    const Field R = table_of(data, "acf_achieved", "m2");
    const Index zero = R.cols() / 2;
    return std::sqrt(2 * (R(0, zero) - R(1, zero)) + (R(0, zero) - R(0, zero + 1)) / 2) / 1e-6;
  };
  require("asperity-kernel -q --length 9um,5um --spacing 1um,2um --rms-slope 0.3 -o own.nc");
  CHECK(relative_error(slope_on_record("own.nc"), 0.3) <= 1e-13);
  require("asperity-kernel -q --length 9px,2.5px -o unit.nc");
  const std::string draw = "asperity-generate -q --shape 32x24 --size 32um,48um --seed 1 --add kernel ";
  require(draw + "--kernel unit.nc --rms-slope 0.3 -o drawn.nc");
  CHECK(relative_error(slope_on_record("drawn.nc"), 0.3) <= 1e-13);
  CHECK(attribute("drawn.nc", "kernel_rms_slope") == 0.3);
  require(draw + "--kernel own.nc --rq 1um -o high.nc");
  CHECK(attributes_in("high.nc").find("kernel_rms_slope") == nullptr);
  require(draw + "--kernel own.nc --exact-rq -o exact.nc");
  CHECK(relative_error(std::sqrt(field_in("exact.nc").square().mean()), attribute("own.nc", "kernel_rms")) <=
        1e-12);
}

// Σ R cos over the period is N M times the power C/(Lx Ly) of a wave, to the rounding of 432 terms; C is 3 um4 up to 1 rad/um,
// then falls as q^-3.
TEST_CASE("each wave of a periodic surface has the density of the table", "[psd][exact]") {
  write_text("c.txt", "# q [rad/um] psd [um4]\n0.1 3\n1 3\n10 3e-3\n");
  const Field R = target_of("--psd c.txt --periodic --shape 24x18 --size 24um,27um");
  const Index middle = R.cols() / 2;
  const double turn = 2 * std::numbers::pi;
  for (const auto& [j, k] : {std::pair{1, 0}, {0, 1}, {3, 2}, {7, 5}, {11, 8}, {0, 0}}) {
    double sum = 0;
    for (Index p = 0; p < 24; ++p)
      for (Index q = 0; q < 18; ++q) {
        const Index row = std::min(p, 24 - p), column = (p > 12 ? 18 - q : q) % 18;
        const double r = R(row, middle + (column > 9 ? column - 18 : column));
        sum += r * std::cos(turn * (static_cast<double>(j * p) / 24 + static_cast<double>(k * q) / 18));
      }
    const double wave = turn * std::hypot(j / 24.0, k / 27.0),
                 c = wave == 0 ? 0 : 3e-24 * std::min(1.0, std::pow(wave, -3));
    CAPTURE(j, k);
    CHECK(std::abs(sum / 432 - c / (24e-6 * 27e-6)) <= 1e-12 * R(0, middle));
  }
}

// C of exp(-(r/4 um)^2) is 16 pi um2 exp(-(2 q um)^2) of the variance, 0.25 um2. The mean is no wave of the torus and takes its
// power from all lags; a chord of ln C over a step of 0.02 in ln q is off by 0.02²/8 times its second derivative, 16 q²
// um², below 1e-3 up to q = 1.1/um, where C is 8e-3.
TEST_CASE("a surface that is not periodic has the transform of the spectrum at all of its lags",
          "[psd][law]") {
  write_text("g.txt", table("# wave_number [rad/um] psd [um4]", 0.01, 3, 1.02,
                            [](double q) { return 4 * std::numbers::pi * std::exp(-4 * q * q); }));
  const Field R = target_of("--psd g.txt --shape 60x50 --spacing 1um --rq 1um");
  const Dataset data = read_dataset("target.nc");
  const std::vector<double> torus = numbers(*data.attributes.find("kernel_period"));
  CHECK(numbers(*data.attributes.find("kernel_corner")) == std::vector<double>{60, 50});
  CHECK((torus[0] >= 120 && torus[1] >= 100));
  const double mean = 16 * std::numbers::pi / (torus[0] * torus[1]);
  for (Index p = 0; p <= 60; ++p)
    for (Index q = -50; q <= 50; ++q) {
      const double exact = (std::exp(-static_cast<double>(p * p + q * q) / 16) - mean) / (1 - mean);
      CAPTURE(p, q);
      REQUIRE(std::abs(R(p, R.cols() / 2 + q) * 1e12 - exact) <= 1e-3);
    }
  CHECK(attribute("target.nc", "kernel_error") <= 1e-13);
  require("asperity-generate -q --psd g.txt --shape 60x50 --size 60um,50um --seed 4 -o own.nc");
  CHECK(relative_error(attribute("own.nc", "kernel_rms"), 0.5e-6 * std::sqrt(1 - mean)) <= 1e-3);
}

TEST_CASE("one spectrum in any unit, header and order of its columns is one target", "[psd][exact]") {
  const std::string options = " --periodic --shape 20x16 --spacing 1um";
  const auto law = [](double q) { return std::pow(q, -3); };
  write_text("a.txt", table("# q [rad/um] psd [um4]", 0.25, 4, 2, law));
  const Field R = target_of("--psd a.txt" + options);
  write_text("b.csv",
             "no, C [nm^4], wave_number [rad mm-1]\n1, 64e12, 250\n2, 8e12, 500\n3, 1e12, 1000\n"
             "4, 0.125e12, 2000\n5, 0.015625e12, 4000\n");
  const auto cycles = [](const std::string& head, double scale) {
    std::string out = head + "\n";
    for (double q : {0.25, 0.5, 1.0, 2.0, 4.0})
      out += shortest(scale * q / (2 * std::numbers::pi)) + "\t" + shortest(std::pow(q, -3)) + "\n";
    return out;
  };
  write_text("f.tsv", cycles("# frequency [um-1]\tpsd [um4]", 1));
  write_text("l.tsv", cycles("# wave_number [cycles/mm]\tpsd [um4]", 1000));
  write_text(
      "j.json",
      R"({"psd": {"unit": "um4", "values": [64, 8, 1, 0.125, 0.015625]}, "no_error": {"unit": null, "values": []},
                 "wave_number": {"unit": "rad m-1", "values": [2.5e5, 5e5, 1e6, 2e6, 4e6]}})");
  for (const char* file : {"b.csv", "f.tsv", "l.tsv", "j.json"}) {
    CAPTURE(file);
    CHECK(greatest_difference(target_of(std::string("--psd ") + file + options), R) <=
          1e-13 * R(0, R.cols() / 2));
  }
  require("asperity-kernel -q --psd - < a.txt -o stdin.nc" + options);
  CHECK(same_bits(table_of(read_dataset("stdin.nc"), "acf_target", "m2"), R));
}

// C1 = 2l/(1 + (lq)²) and C = 2πl²(1 + (lq)²)^-3/2 of exp(-r/l): (3) of acf/radial_spectrum.hpp is within ½ (ln ratio)² = 2 %.
TEST_CASE("profiles of an isotropic surface give its autocorrelation", "[psd][law]") {
  const double l = 5;
  write_text("c.txt", table("# q [rad/um] psd [um4]", 0.02, 3, 1.2, [=](double q) {
               return 2 * std::numbers::pi * l * l * std::pow(1 + l * l * q * q, -1.5);
             }));
  write_text("c1.txt", table("# q [rad/um] psd [um3]", 0.02, 3, 1.2,
                             [=](double q) { return 2 * l / (1 + l * l * q * q); }));
  const std::string options = " --periodic --shape 128x96 --spacing 1um";
  const Field C = target_of("--psd c.txt" + options), C1 = target_of("--psd c1.txt" + options);
  CHECK(greatest_difference(C, C1) <= 0.02 * C(0, C.cols() / 2));
}

// The rings of 30 surfaces against C at their wave numbers: within 4 standard errors, and 3 % for C that is curved over a ring; their rms height, with corners that no ring has, within 2 %.
TEST_CASE("what asperity-psd measures of the surfaces is the spectrum that it measured of another",
          "[psd][statistics]") {
  require(
      "asperity-generate -q --shape 96x96 --size 96um --periodic --rq 1um --model matern --length 12um "
      "--seed 3 -o map.nc");
  require("asperity-psd -q map.nc --result radial -o radial.tsv");
  require(
      "asperity-generate -q --shape 96x96 --size 96um --periodic --psd radial.tsv --seed 5 --count 30 -o "
      "like_%02d.nc");
  CHECK(relative_error(attribute("like_00.nc", "kernel_rms"),
                       std::sqrt(field_in("map.nc").square().mean())) <= 0.02);
  const Printed asked = printed("cat radial.tsv"),
                found = printed("asperity-psd -q like_*.nc --result radial");
  for (std::size_t i = 1; i + 1 < found["psd"].size(); ++i) {
    CAPTURE(i);
    const double c = asked["psd"][i], mean = found["psd"][i];
    CHECK(std::abs(mean - c) <= 4 * found["standard_error"][i] + 0.03 * c);
  }
}

TEST_CASE("heights that are not Gaussian have the autocorrelation of the spectrum", "[psd][law]") {
  write_text("c.txt", "# q [rad/um] psd [um4]\n0.1 3\n0.6 3\n6 3e-4\n");
  for (const char* way : {"", " --periodic"}) {
    require(
        "asperity-generate -q --psd c.txt --skewness -0.7 --shape 48x48 --size 48um --add kernel -o "
        "skewed.nc" +
        std::string(way));
    CHECK(attribute("skewed.nc", "kernel_error") <= 1e-3);
    CHECK(attribute("skewed.nc", "kernel_skewness") == -0.7);
  }
}
