// Surfaces as they are drawn: heights that are not Gaussian, those of another surface, kernels made apart.
#include "stats/sample/moments.hpp"
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string measured_map = ASPERITY_TEST_DATA "/afm-64x64.nc";
const std::string common = " --rq 0.4um --length 6px,4px", shaped = " --skewness -1.3 --kurtosis 6";
const std::string large_grid = " --shape 300x200 --size 3mm,2mm --no-history";

}  // namespace

// 60000 heights of lengths 6 and 4 samples are worth some 1500: Ssk and Sku scatter by 0.1 and 0.6 (the
// moments of a Gaussian by half of that), Sq by 2 %.
TEST_CASE("a surface has the skewness and kurtosis asked for, and says what to expect",
          "[heights][statistics]") {
  require("asperity-generate" + large_grid + common + shaped + " --seed 3 --add kernel -o s.nc");
  const Moments m = moments(field_in("s.nc"));
  CHECK(std::abs(m.ssk + 1.3) <= 0.4);
  CHECK(std::abs(m.sku - 6) <= 2.4);
  CHECK(std::abs(m.sq / 0.4e-6 - 1) <= 0.1);
  CHECK(std::abs(attribute("s.nc", "generate_skewness_expected") + 1.3) <= 1e-10);
  CHECK(std::abs(attribute("s.nc", "generate_kurtosis_expected") - 6) <= 1e-10);
  CHECK(attribute("s.nc", "generate_acf_error_expected") <= 1e-3);
  CHECK(read_dataset("s.nc").attributes.text("generate_heights") == "translation");
  CHECK(read_dataset("s.nc").attributes.text("kernel_heights") == "S_B");
  CHECK(read_dataset("s.nc").at("kernel").attributes.text("units") == "1");
  CHECK(read_dataset("s.nc").at("acf_target").attributes.text("units") == "m2");
}

TEST_CASE(
    "a kernel from asperity-kernel draws the surface that one tool draws, from a pipe and after that too",
    "[heights][law]") {
  const std::string draw = "asperity-generate --seed 5" + large_grid;
  require(draw + common + shaped + " -o one.nc");
  require("asperity-kernel" + common + shaped + " --spacing 10um | " + draw + " --add kernel -o two.nc");
  require(draw + " --kernel two.nc -o three.nc");
  CHECK((field_in("one.nc") == field_in("two.nc")).all());
  CHECK((field_in("one.nc") == field_in("three.nc")).all());
  // Another rms height stretches the heights and the correlation, not the kernel.
  require(draw + " --kernel two.nc --rq 0.8um -o four.nc");
  CHECK(((field_in("four.nc") - 2 * field_in("one.nc")).abs() <= 1e-20).all());
}

TEST_CASE("shaped surfaces depend neither on the memory nor on the threads, to the last bit",
          "[heights][law]") {
  for (const std::string way : {"", " --skewness -0.3 --kurtosis 3.4 --method filter"}) {
    const std::string draw = "asperity-generate --shape 1500x40 --size 15mm,0.4mm --seed 7" + common +
                             (way.empty() ? shaped : way);
    require(draw + " -o whole.nc");
    require(draw + " --threads 5 --memory 1100kB -o other.nc");
    CHECK((field_in("whole.nc") == field_in("other.nc")).all());
  }
}

TEST_CASE("a Gaussian pair of moments draws the Gaussian surface, by either way", "[heights][exact]") {
  const std::string draw = "asperity-generate --seed 5" + large_grid + common;
  require(draw + " -o gaussian.nc");
  for (const std::string way : {"", " --method filter"}) {
    require(draw + " --skewness 0 --kurtosis 3" + way + " -o same.nc");
    CHECK((field_in("gaussian.nc") == field_in("same.nc")).all());
  }
}

TEST_CASE("an ensemble of shaped surfaces, and one of them, is validated against what it was drawn to have",
          "[heights][statistics]") {
  require("asperity-generate --shape 128x128 --size 1mm --rq 0.4um --length 5px --seed 4 --count 15" +
          shaped + " -o e_%02d.nc");
  const Outcome agrees = shell("asperity-validate e_*.nc -q");
  CAPTURE(agrees.out, agrees.error);
  CHECK(agrees.exit == 0);
  CHECK_THAT(agrees.out, ContainsSubstring("\t-1.3"));
  CHECK(shell("asperity-validate e_*.nc -q --skewness 0 --kurtosis 3").exit == 5);
  const Outcome single = shell("asperity-validate e_00.nc -q");
  CAPTURE(single.out, single.error);
  CHECK(single.exit == 0);
  CHECK(shell("asperity-validate e_00.nc -q --skewness 0 --kurtosis 3").exit == 5);
}

TEST_CASE("a skewness alone is validated with the kurtosis of the gamma family", "[heights][contract]") {
  require(
      "asperity-generate --shape 16x16 --size 1mm --rq 0.4um --length 3px --seed 4 --count 12 -o g_%02d.nc");
  const std::string validate = "asperity-validate g_*.nc -q ";
  CHECK_THAT(shell(validate + "--skewness -1").out, ContainsSubstring("Sku\t1\t4.5\t"));
  CHECK_THAT(shell(validate + "--skewness -1 --kurtosis 3.5").out, ContainsSubstring("Sku\t1\t3.5\t"));
  CHECK_THAT(shell(validate).out, ContainsSubstring("Sku\t1\t3\t"));
}

// A Gaussian's errors would be 0.018 and 0.029.
TEST_CASE("the standard errors of a shaped surface's moments are those of its distribution, drawn or evident",
          "[heights][law]") {
  require("asperity-generate" + large_grid + common + shaped + " --seed 3 -o s.nc");
  for (const std::string correlation : {"auto", "estimate"}) {
    const Printed rows = printed("asperity-stats s.nc --parameters height --correlation " + correlation);
    CAPTURE(correlation);
    CHECK(rows.at("Sku", "standard_error") > 0.2);
    CHECK(rows.at("Ssk", "standard_error") > 0.035);
    CHECK(rows.at("Sku", "low_95") <= 6);
    CHECK(rows.at("Sku", "high_95") >= 6);
  }
}

// The filtered noise's skewness and kurtosis are exact in the mean; the scatter as above.
TEST_CASE("filtered noise gives skewness and kurtosis where the kernel leaves them, and says what to expect",
          "[heights][statistics]") {
  require("asperity-generate" + large_grid +
          " --rq 0.4um --length 3px --seed 3 --method filter --skewness -0.6"
          " --kurtosis 3.9 -o s.nc");
  const Moments m = moments(field_in("s.nc"));
  CHECK(std::abs(m.ssk + 0.6) <= 0.2);
  CHECK(std::abs(m.sku - 3.9) <= 0.6);
  CHECK(std::abs(attribute("s.nc", "generate_skewness_expected") + 0.6) <= 1e-9);
  CHECK(std::abs(attribute("s.nc", "generate_kurtosis_expected") - 3.9) <= 1e-9);
  CHECK(read_dataset("s.nc").attributes.text("generate_heights") == "filter");
}

// A skewness alone kept the kurtosis of 3: at -1 the heights were cut at a ceiling of 1.09 Sq, and densest
// there.
TEST_CASE("a skewness alone brings the kurtosis of the gamma family, a kurtosis alone no skewness",
          "[heights][contract]") {
  const std::string draw = "asperity-generate" + large_grid + common + " --seed 3 -o s.nc ";
  const auto expected = [](const char* moment) {
    return attribute("s.nc", std::string("generate_") + moment + "_expected");
  };
  require(draw + "--skewness -1");
  CHECK(std::abs(expected("skewness") + 1) <= 1e-10);
  CHECK(std::abs(expected("kurtosis") - 4.5) <= 1e-10);
  CHECK(field_in("s.nc").maxCoeff() >= 1.5 * 0.4e-6);
  require(draw + "--kurtosis 5");
  CHECK(expected("skewness") == 0);
  CHECK(std::abs(expected("kurtosis") - 5) <= 1e-10);
  require("ASPERITY_GENERATE_SKEWNESS=-0.4 " + draw + "--method filter");
  CHECK(std::abs(expected("kurtosis") - 3.24) <= 1e-9);
  require(draw + "-q --skewness -1 --kurtosis 3");
  CHECK(std::abs(expected("kurtosis") - 3) <= 1e-10);
}

// ---- the heights of another surface: a dataset, a table of asperity-stats, a text ----

// The twin is 16 times the size of the measured surface, whose own heights tell their moments to some 0.2.
TEST_CASE(
    "one pipe draws twins of a measured surface, by its quantiles, by its moments, or by the heights of a "
    "file",
    "[heights][statistics][slow]") {
  require("asperity-acf " + measured_map + " --remove-form plane --biased --add acf_quantiles -o acf.nc");
  const double skewness = attribute("acf.nc", "acf_skewness"), kurtosis = attribute("acf.nc", "acf_kurtosis");
  for (const std::string marginal : {"measured", "johnson", measured_map.c_str()}) {
    CAPTURE(marginal);
    require("asperity-acf " + measured_map +
            " --remove-form plane --biased --add acf_quantiles | asperity-generate --acf - --shape 256x256 "
            "--seed 2 "
            "--marginal " +
            marginal + " -o twin.nc");
    CHECK(std::abs(attribute("twin.nc", "generate_skewness_expected") - skewness) <= 0.3);
    CHECK(std::abs(attribute("twin.nc", "generate_kurtosis_expected") - kurtosis) <= 1);
    const Moments m = moments(field_in("twin.nc"));
    CHECK(std::abs(m.sq / std::sqrt(attribute("acf.nc", "acf_variance")) - 1) <= 0.2);
    CHECK(std::abs(m.ssk - attribute("twin.nc", "generate_skewness_expected")) <= 0.5);
  }
}

TEST_CASE("the table of asperity-stats, text or JSON, gives a twin its skewness and kurtosis",
          "[heights][law]") {
  require("asperity-acf " + measured_map + " --remove-form plane --biased -o acf.nc");
  for (const std::string json : {"", " --json"}) {
    require("asperity-stats " + measured_map + " --remove-form plane" + json +
            " | asperity-generate --acf acf.nc --shape 64x64 --seed 2 --marginal - -o twin.nc");
    CHECK(relative_error(attribute("twin.nc", "generate_skewness_expected"),
                         attribute("acf.nc", "acf_skewness")) <= 1e-12);
    CHECK(relative_error(attribute("twin.nc", "generate_kurtosis_expected"),
                         attribute("acf.nc", "acf_kurtosis")) <= 1e-12);
  }
}

TEST_CASE("heights in a text file are a distribution", "[heights][contract]") {
  const std::string draw = "asperity-generate" + large_grid + common;
  require("seq 1 500 | awk 'BEGIN { print \"# um\" } { print log($1 / 500.5) }' > depths.txt");
  require(draw + " --marginal depths.txt --add kernel -o s.nc");
  CHECK(std::abs(attribute("s.nc", "generate_skewness_expected") + 2) <= 0.3);  // an exponential of valleys
  CHECK(read_dataset("s.nc").attributes.text("kernel_heights") == "measured");
  require("asperity-generate --kernel s.nc --no-history -o again.nc --seed " +
          std::to_string(static_cast<long>(attribute("s.nc", "generate_seed"))));
  CHECK((field_in("s.nc") == field_in("again.nc")).all());
}

// ---- kernels and files ----

TEST_CASE("a kernel made apart draws the same surface as one made on the way", "[pipeline][law]") {
  const std::string kernel = " --model gaussian --length 8px --rq 0.4um ",
                    draw = "asperity-generate --shape 32x32 --size 3mm --seed 7 --no-history ";
  require(draw + kernel + "-o direct.nc; asperity-kernel" + kernel + "| " + draw + "--kernel - -o piped.nc");
  const Field direct = field_in("direct.nc");
  // Scaling before or behind the sum: a rounding each of some thousand terms.
  CHECK(greatest_difference(direct, field_in("piped.nc")) <= 1e-12 * direct.abs().maxCoeff());
}

TEST_CASE("a surface that goes to a file as it is made tells its range and the seconds that it took",
          "[generate][exact]") {
  require(
      "asperity-generate --shape 1500x40 --size 15mm,0.4mm --rq 0.4um --length 4px --seed 7 --no-history "
      "--memory 1100kB --add noise -o strips.nc");
  for (const char* name : {"heights", "noise"}) {
    const Field field = field_in("strips.nc", name);
    CHECK(numbers(*read_dataset("strips.nc").at(name).attributes.find("actual_range")) ==
          std::vector<double>{field.minCoeff(), field.maxCoeff()});
  }
  CHECK(attribute("strips.nc", "generate_seconds") > 0);
}
