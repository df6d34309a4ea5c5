// Surfaces whose heights are not Gaussian, from the command line.
#include <nlohmann/json.hpp>

#include "stats/sample/moments.hpp"
#include "tools/heights_runs.hpp"

using namespace asperity;
using namespace asperity::test;

// 60000 heights of lengths 6 and 4 samples are worth some 1500: Ssk and Sku scatter by 0.1 and 0.6 (the
// moments of a Gaussian by half of that), Sq by 2 %.
TEST_CASE("a surface has the skewness and kurtosis asked for, and says what to expect",
          "[heights][statistics]") {
  require("asperity-generate" + grid + common + shaped + " --seed 3 --add kernel -o s.nc");
  const Moments m = moments(heights("s.nc"));
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
  const std::string draw = "asperity-generate --seed 5" + grid;
  require(draw + common + shaped + " -o one.nc");
  require("asperity-kernel" + common + shaped + " --spacing 10um | " + draw + " --add kernel -o two.nc");
  require(draw + " --kernel two.nc -o three.nc");
  CHECK((heights("one.nc") == heights("two.nc")).all());
  CHECK((heights("one.nc") == heights("three.nc")).all());
  // Another rms height stretches the heights and the correlation, not the kernel.
  require(draw + " --kernel two.nc --rq 0.8um -o four.nc");
  CHECK(((heights("four.nc") - 2 * heights("one.nc")).abs() <= 1e-20).all());
}

TEST_CASE("shaped surfaces depend neither on the memory nor on the threads, to the last bit",
          "[heights][law]") {
  for (const std::string way : {"", " --skewness -0.3 --kurtosis 3.4 --method filter"}) {
    const std::string draw = "asperity-generate --shape 1500x40 --size 15mm,0.4mm --seed 7" + common +
                             (way.empty() ? shaped : way);
    require(draw + " -o whole.nc");
    require(draw + " --threads 5 --memory 1100kB -o other.nc");
    CHECK((heights("whole.nc") == heights("other.nc")).all());
  }
}

TEST_CASE("a Gaussian pair of moments draws the Gaussian surface, by either way", "[heights][exact]") {
  const std::string draw = "asperity-generate --seed 5" + grid + common;
  require(draw + " -o gaussian.nc");
  for (const std::string way : {"", " --method filter"}) {
    require(draw + " --skewness 0 --kurtosis 3" + way + " -o same.nc");
    CHECK((heights("gaussian.nc") == heights("same.nc")).all());
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
  require("asperity-generate" + grid + common + shaped + " --seed 3 -o s.nc");
  for (const std::string correlation : {"auto", "estimate"}) {
    const Outcome run = shell("asperity-stats s.nc --parameters height --json --correlation " + correlation);
    INFO(run.error);
    const auto rows = nlohmann::json::parse(run.out);
    CAPTURE(correlation, run.out);
    CHECK(rows["Sku"]["standard_error"].get<double>() > 0.2);
    CHECK(rows["Ssk"]["standard_error"].get<double>() > 0.035);
    CHECK(rows["Sku"]["interval_95"][0].get<double>() <= 6);
    CHECK(rows["Sku"]["interval_95"][1].get<double>() >= 6);
  }
}

// The filtered noise's skewness and kurtosis are exact in the mean; the scatter as above.
TEST_CASE("filtered noise gives skewness and kurtosis where the kernel leaves them, and says what to expect",
          "[heights][statistics]") {
  require("asperity-generate" + grid +
          " --rq 0.4um --length 3px --seed 3 --method filter --skewness -0.6"
          " --kurtosis 3.9 -o s.nc");
  const Moments m = moments(heights("s.nc"));
  CHECK(std::abs(m.ssk + 0.6) <= 0.2);
  CHECK(std::abs(m.sku - 3.9) <= 0.6);
  CHECK(std::abs(attribute("s.nc", "generate_skewness_expected") + 0.6) <= 1e-9);
  CHECK(std::abs(attribute("s.nc", "generate_kurtosis_expected") - 3.9) <= 1e-9);
  CHECK(read_dataset("s.nc").attributes.text("generate_heights") == "filter");
}

TEST_CASE("a Gaussian kernel from a pipe is drawn with filtered noise, and refused a translation",
          "[heights][contract]") {
  require("asperity-kernel" + common + " --spacing 10um -o gaussian.nc");
  require("asperity-generate" + grid +
          " --kernel gaussian.nc --method filter --skewness -0.1 --kurtosis 3.1 -o s.nc");
  refused("asperity-generate" + grid + " --kernel gaussian.nc" + shaped, 2,
          {"--skewness", "asperity-kernel"});
  require("asperity-kernel" + common + shaped + " --spacing 10um -o shaped.nc");
  refused("asperity-generate" + grid + " --kernel shaped.nc --method filter" + shaped, 2,
          {"--method", "S_B"});
}

TEST_CASE("moments that there are not are refused with their bound, or changed as --infeasible says",
          "[heights][contract]") {
  const std::string draw = "asperity-generate" + grid + common;
  refused(draw + " --skewness 2 --kurtosis 4.5", 2, {"--kurtosis", "4.5", "5"});
  refused(draw + " --skewness 100 --kurtosis 1e5", 2, {"--skewness", "100", "50"});
  refused(draw + " --skewness nan", 2, {"--skewness"});
  refused(draw + " --kurtosis inf", 2, {"--kurtosis"});
  refused(draw + " --method filter --skewness 0 --kurtosis 1.8", 2,
          {"--kurtosis", "1.8", "the least kurtosis"});
  refused(draw + " --method filter", 2, {"--method", "--skewness"});
  CHECK_THAT(shell(draw + " --skewness 2 --kurtosis 4.5 --infeasible nearest -o s.nc").error,
             ContainsSubstring("at skewness 2 this method cannot give the kurtosis 4.5"));
  const double kurtosis = attribute("s.nc", "generate_kurtosis_expected");
  for (const std::string bound : {"--skewness 0 --kurtosis 1e4", "--skewness -50 --kurtosis 1e4"})
    require(draw + " " + bound + " -o bound.nc");
  CHECK(kurtosis > 5);
  CHECK(kurtosis < 5.5);
}

// A skewness alone kept the kurtosis of 3: at -1 the heights were cut at a ceiling of 1.09 Sq, and densest
// there.
TEST_CASE("a skewness alone brings the kurtosis of the gamma family, a kurtosis alone no skewness",
          "[heights][contract]") {
  const std::string draw = "asperity-generate" + grid + common + " --seed 3 -o s.nc ";
  const auto expected = [](const char* moment) {
    return attribute("s.nc", std::string("generate_") + moment + "_expected");
  };
  require(draw + "--skewness -1");
  CHECK(std::abs(expected("skewness") + 1) <= 1e-10);
  CHECK(std::abs(expected("kurtosis") - 4.5) <= 1e-10);
  CHECK(heights("s.nc").maxCoeff() >= 1.5 * 0.4e-6);
  require(draw + "--kurtosis 5");
  CHECK(expected("skewness") == 0);
  CHECK(std::abs(expected("kurtosis") - 5) <= 1e-10);
  require("ASPERITY_GENERATE_SKEWNESS=-0.4 " + draw + "--method filter");
  CHECK(std::abs(expected("kurtosis") - 3.24) <= 1e-9);
  require(draw + "-q --skewness -1 --kurtosis 3");
  CHECK(std::abs(expected("kurtosis") - 3) <= 1e-10);
  refused("asperity-generate" + grid + common + " --skewness 100", 2, {"--skewness", "50"});
}

TEST_CASE(
    "heights that end within 3 Sq are said in one line, with the bound, and warned of where they crowd there",
    "[heights][contract]") {
  const std::string draw =
      "asperity-generate --shape 8x8 --size 1mm --rq 0.4um --length 2px --seed 3 -o s.nc ";
  const auto said = [&](const std::string& options) {
    const Outcome run = shell(draw + options);
    CAPTURE(options, run.error);
    CHECK(run.exit == 0);
    CHECK(lines(run.error) <= 1);
    return run.error;
  };
  CHECK(said("--skewness -0.5").empty());
  CHECK(said("--skewness -0.5 --kurtosis 4").empty());
  CHECK_THAT(said("--skewness -1"),
             ContainsSubstring("asperity-generate: heights are bounded at +2.44 Sq (976nm)"));
  CHECK_THAT(said("--skewness 1"), ContainsSubstring("bounded at -2.44 Sq (-976nm)"));
  CHECK(said("-q --skewness -1").empty());
  const std::string cut = said("-q --skewness -1 --kurtosis 3");
  CHECK_THAT(cut, ContainsSubstring("warning: heights are bounded at -2.96 Sq (-1.19um) and +1.09 Sq "
                                    "(435nm), Johnson's S_B; their density is J"));
  CHECK_THAT(cut, ContainsSubstring("largest 0.053 Sq from its upper end"));
  CHECK_THAT(said("-q --skewness 1 --kurtosis 3"), ContainsSubstring("lower end"));
  CHECK_THAT(said("-q --kurtosis 1.7"), ContainsSubstring("two peaks, at -1.5 and +1.5 Sq"));
  CHECK_THAT(shell("asperity-kernel -q --length 2px --skewness -1 --kurtosis 3 -o k.nc").error,
             ContainsSubstring("and +1.09 Sq, Johnson's S_B"));
}

TEST_CASE("a correlation that skewed heights cannot have is refused, or changed with a warning",
          "[heights][contract]") {
  const std::string draw = "asperity-generate" + grid +
                           " --rq 0.4um --model exponential-cosine --length 120px,40px --wavelength 20px"
                           " --skewness -2 --kurtosis 10 --lags 20x20 -q";
  refused(draw, 2, {"--marginal", "correlate no lower than -0.71"});
  const Outcome run = shell(draw + " --infeasible nearest --seed 1 -o s.nc");
  CAPTURE(run.error);
  CHECK(run.exit == 3);
  CHECK_THAT(run.error, ContainsSubstring("exceeds --acf-tolerance"));
  CHECK(attribute("s.nc", "generate_acf_error_expected") > 0.02);
}

// The twin is 16 times the size of the measured surface, whose own heights tell their moments to some 0.2.
