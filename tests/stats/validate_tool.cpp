// asperity-validate on surfaces whose correlation is known.
#include <nlohmann/json.hpp>

#include "dataset/layout.hpp"
#include "fields.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;
using Json = nlohmann::json;

namespace {

const Shape validated_window{5, 3};

// e_0.nc … e_5.nc: `sq` of moving average over 5 × 3 points, with the target of 0.4 µm over those lags.
void write_ensemble(double sq, double spacing = 20e-6, double step = 0) {
  const Grid grid{{72, 64}, spacing, spacing, false};
  const LagField rho = triangular_correlation(validated_window);
  const Field target =
      Field::NullaryExpr(7, 9, [&](Index p, Index column) { return 0.16e-12 * rho(p, column - 4); });
  for (unsigned m = 0; m < 6; ++m) {
    Dataset data;
    set_grid(data, grid);
    Field z = sq * moving_average(grid.shape, validated_window, 50 + m);
    if (step > 0) z = step * (z / step).round();
    set_field(data, "heights", z, {"m", "heights"});
    set_table(data, "acf_target", target, {"p", 0, spacing, "m"}, {"q", -4, spacing, "m"},
              {"m2", "autocorrelation asked for"});
    write_dataset(data, "e_" + std::to_string(m) + ".nc");
  }
}

}  // namespace

TEST_CASE("asperity-validate answers 0 for the ensemble that was drawn and 5 for another height",
          "[validate-tool][statistics]") {
  write_ensemble(0.4e-6);
  const Outcome same = shell("asperity-validate e_*.nc -q");
  INFO(same.out << same.error);
  CHECK(same.exit == 0);
  CHECK(
      same.out.starts_with("# quantity\tunit\tprescribed [SI]\tmean [SI]\tstandard_error [SI]\tz [1]\tp "
                           "[1]\tverdict\nSq\tm\t4e-07"));
  CHECK(lines(same.out) == 9);
  CHECK_THAT(same.out, ContainsSubstring("\nlength") && ContainsSubstring("\t1\t1\t"));
  CHECK(same.out.find("differs") == std::string::npos);
  CHECK(shell("asperity-validate e_*.nc -q --rq 0.45um").exit == 5);
  CHECK_THAT(shell("asperity-validate --help").out, ContainsSubstring("5 the surfaces differ"));
  CHECK_THAT(shell("asperity-validate --man").out, ContainsSubstring("the surfaces differ"));

  write_ensemble(0.45e-6);
  const Outcome other = shell("asperity-validate e_*.nc --json -q");
  CHECK(other.exit == 5);
  const Json verdicts = Json::parse(other.out)["verdict"]["values"];
  CHECK(verdicts ==
        Json({"differs", "agrees", "agrees", "differs", "agrees", "agrees", "agrees", "differs"}));
}

TEST_CASE("asperity-validate reads a list of names or one dataset, to the same answer",
          "[validate-tool][contract]") {
  write_ensemble(0.4e-6);
  const std::string named = shell("asperity-validate e_*.nc -q").out;
  CHECK(shell("ls e_*.nc | asperity-validate -q --files-from -").out == named);
  const Outcome one = shell("asperity-validate e_3.nc -q");
  CHECK(one.exit == 0);
  CHECK(shell("asperity-validate -q < e_3.nc").out == one.out);
  CHECK(shell("asperity-validate e_*.nc -q --acf e_0.nc").out == named);
}

TEST_CASE(
    "one surface is enough, also where heights are not to be Gaussian, and the note tells of the simulated "
    "ones",
    "[validate-tool][statistics]") {
  write_ensemble(0.4e-6);
  const Outcome single = shell("asperity-validate e_0.nc --skewness 1 --kurtosis 5");
  CHECK(single.exit == 5);
  CHECK_THAT(single.error, ContainsSubstring("errors from 200 simulated surfaces"));
  CHECK_THAT(single.out, ContainsSubstring("\nSsk\t1\t1\t") && ContainsSubstring("\nSku\t1\t5\t"));
  CHECK_THAT(shell("asperity-validate e_0.nc").error,
             ContainsSubstring("errors from 200 simulated surfaces"));
  CHECK(shell("asperity-validate e_*.nc -q --skewness 1 --kurtosis 5").exit == 5);
  CHECK(shell("asperity-validate e_0.nc --errors spread").exit == 2);
}

TEST_CASE("asperity-validate leaves masked points out, and refuses another height all the same",
          "[validate-tool][statistics]") {
  for (const double sq : {0.4e-6, 0.45e-6}) {
    write_ensemble(sq);
    for (std::size_t m = 0; m < 6; ++m) {
      const std::string name = "e_" + std::to_string(m) + ".nc";
      Dataset data = read_dataset(name);
      std::vector<std::int8_t> mask(72 * 64, 0);
      for (std::size_t k = 100 * m; k < 100 * m + 700; ++k) mask[k] = 1;
      for (std::size_t k = 700; k < mask.size(); k += 13) mask[k] = 1;
      set_flags(data, "mask", mask, "missing points", "present missing");
      write_dataset(data, name);
    }
    const Outcome run = shell("asperity-validate e_*.nc -q");
    INFO(run.out << run.error);
    CHECK(run.exit == (sq == 0.4e-6 ? 0 : 5));
  }
}

TEST_CASE("asperity-validate refuses what it cannot judge in one line", "[validate-tool][contract]") {
  write_ensemble(0.4e-6);
  for (const char* wrong :
       {"--significance 0", "--significance 0.7", "--skewness 2 --kurtosis 4", "--kurtosis 0.5"}) {
    const Outcome run = shell(std::string("asperity-validate e_0.nc ") + wrong);
    CAPTURE(wrong, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1));
  }
  REQUIRE(shell("cp e_0.nc coarse.nc").exit == 0);
  write_ensemble(0.4e-6, 10e-6);
  const Outcome mixed = shell("asperity-validate e_0.nc coarse.nc");
  CHECK((mixed.exit == 4 && lines(mixed.error) == 1));
  const Outcome target = shell("asperity-validate e_0.nc --acf coarse.nc");
  CHECK((target.exit == 4 && target.error.find("apart") != std::string::npos));
  CHECK(shell("echo | asperity-validate --files-from -").exit == 2);
}

// Rounding adds s²/12 to R(0,0) alone: 8 % of it at steps of Sq, by which R at lag 1 was 14 standard errors
// off.
TEST_CASE("surfaces in steps agree with the prescription that they were drawn from",
          "[validate-tool][statistics]") {
  for (const double step : {0.2e-6, 0.4e-6}) {
    write_ensemble(0.4e-6, 20e-6, step);
    const Outcome run = shell("asperity-validate e_*.nc -q");
    INFO(run.out << run.error);
    CHECK(run.exit == 0);
  }
  write_ensemble(0.4e-6, 20e-6, 0.8e-6);
  const Outcome coarse = shell("asperity-validate e_*.nc -q");
  CHECK((coarse.exit == 4 && lines(coarse.error) == 1));
  CHECK_THAT(coarse.error, ContainsSubstring("steps of"));
}
