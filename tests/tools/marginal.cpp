// Surfaces with the heights of another: a dataset, a table of asperity-stats, a text.
#include "stats/sample/moments.hpp"
#include "tools/heights_runs.hpp"

using namespace asperity;
using namespace asperity::test;

// The twin is 16 times the size of the measured surface, whose own heights tell their moments to some 0.2.
TEST_CASE(
    "one pipe draws twins of a measured surface, by its quantiles, by its moments, or by the heights of a "
    "file",
    "[heights][statistics][slow]") {
  require("asperity-acf " + measured + " --remove-form plane --biased --add acf_quantiles -o acf.nc");
  const double skewness = attribute("acf.nc", "acf_skewness"), kurtosis = attribute("acf.nc", "acf_kurtosis");
  for (const std::string marginal : {"measured", "johnson", measured.c_str()}) {
    CAPTURE(marginal);
    require("asperity-acf " + measured +
            " --remove-form plane --biased --add acf_quantiles | asperity-generate --acf - --shape 256x256 "
            "--seed 2 "
            "--marginal " +
            marginal + " -o twin.nc");
    CHECK(std::abs(attribute("twin.nc", "generate_skewness_expected") - skewness) <= 0.3);
    CHECK(std::abs(attribute("twin.nc", "generate_kurtosis_expected") - kurtosis) <= 1);
    const Moments m = moments(heights("twin.nc"));
    CHECK(std::abs(m.sq / std::sqrt(attribute("acf.nc", "acf_variance")) - 1) <= 0.2);
    CHECK(std::abs(m.ssk - attribute("twin.nc", "generate_skewness_expected")) <= 0.5);
  }
}

TEST_CASE("the table of asperity-stats, text or JSON, gives a twin its skewness and kurtosis",
          "[heights][law]") {
  require("asperity-acf " + measured + " --remove-form plane --biased -o acf.nc");
  for (const std::string json : {"", " --json"}) {
    require("asperity-stats " + measured + " --remove-form plane" + json +
            " | asperity-generate --acf acf.nc --shape 64x64 --seed 2 --marginal - -o twin.nc");
    CHECK(relative_error(attribute("twin.nc", "generate_skewness_expected"),
                         attribute("acf.nc", "acf_skewness")) <= 1e-12);
    CHECK(relative_error(attribute("twin.nc", "generate_kurtosis_expected"),
                         attribute("acf.nc", "acf_kurtosis")) <= 1e-12);
  }
  shell("echo '{\"Ssk\": 3' > broken.json");
  refused("asperity-generate --acf acf.nc --shape 64x64 --marginal broken.json", 4, {"marginal", "line 1"});
}

TEST_CASE("heights in a text file are a distribution, and what is none is refused", "[heights][contract]") {
  const std::string draw = "asperity-generate" + grid + common;
  require("seq 1 500 | awk 'BEGIN { print \"# um\" } { print log($1 / 500.5) }' > depths.txt");
  require(draw + " --marginal depths.txt --add kernel -o s.nc");
  CHECK(std::abs(attribute("s.nc", "generate_skewness_expected") + 2) <= 0.3);  // an exponential of valleys
  CHECK(read_dataset("s.nc").attributes.text("kernel_heights") == "measured");
  require("asperity-generate --kernel s.nc --no-history -o again.nc --seed " +
          std::to_string(static_cast<long>(attribute("s.nc", "generate_seed"))));
  CHECK((heights("s.nc") == heights("again.nc")).all());
  shell(
      "seq 1 50 > few.txt; echo 1 2 three > words.txt; yes 3 | head -300 > same.txt; seq 1 500 | awk '{ "
      "print $1, sin($1) }' > xz.txt");
  refused(draw + " --marginal xz.txt", 4, {"marginal", "which columns are x, y and z"});
  refused(draw + " --marginal few.txt", 4, {"marginal", "50"});
  refused(draw + " --marginal words.txt", 4, {"marginal", "line 1"});
  refused(draw + " --marginal same.txt", 4, {"marginal", "are equal"});
  refused(draw + " --marginal nowhere.txt", 1, {"nowhere.txt"});
  refused(draw + " --marginal measured", 2, {"--marginal", "acf_quantiles"});
  refused(draw + " --marginal johnson", 2, {"--marginal", "--skewness"});
  refused(draw + " --marginal gaussian --kurtosis 4", 2, {"--kurtosis", "gaussian"});
  refused(draw + " --marginal depths.txt --method filter", 2, {"--marginal", "filter"});
}
