// Surfaces of a prescribed spectrum, and of a prescribed slope.
#include <array>
#include <utility>

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

// (1) of tools/surface/height_options.hpp, of the correlation on record.
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
