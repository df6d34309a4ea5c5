// asperity-acf, asperity-psd and asperity-pdf on a dataset whose correlation is known.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "drawn_surface.hpp"
#include "stats/spatial/pairs.hpp"

using namespace asperity;
using namespace asperity::test;
using Catch::Matchers::EndsWith;

TEST_CASE("asperity-acf prints both profiles from 1 on, with the target beside", "[acf-tool][contract]") {
  const Outcome run = run_on_surface("asperity-acf drawn.nc --result profiles --max-lag 20x15");
  REQUIRE(run.exit == 0);
  CHECK(run.out.starts_with(
      "# direction\tlag [m]\tacf [1]\tstandard_error [1]\tlow_95 [1]\thigh_95 [1]\ttarget [1]\n"
      "x\t0\t1\t0\t1\t1\t1\n"));
  CHECK(lines(run.out) == 1 + 21 + 16);
  const Json absolute = json_of("asperity-acf drawn.nc --result profiles --absolute --json");
  const double sq = json_of("asperity-stats drawn.nc --json")["Sq"]["value"];
  CHECK(absolute["acf"]["unit"] == "m2");
  CHECK(relative_error(absolute["acf"]["values"][0], sq * sq) <= 100 * epsilon);
}

// A triangle falls to 10 % at 7.2 and 4.5 samples; between 7 and 8 samples, where the target reaches zero,
// the interpolation is linear and exact. Student's t of seven degrees exceeds 5.4 in one of 1000 surfaces.
TEST_CASE("asperity-acf finds the 10 % lengths within a few of their standard errors",
          "[acf-tool][statistics]") {
  const Json lengths = json_of("asperity-acf drawn.nc --result lengths --json");
  CHECK(relative_error(lengths["target_length_10_x"]["value"], 7.2 * 20e-6) <= 10 * epsilon);
  CHECK(relative_error(lengths["target_length_10_y"]["value"], 4.5 * 30e-6) <= 10 * epsilon);
  for (const char* name : {"length_10_x", "length_10_y", "length_e_x", "length_e_y", "gamma_10", "gamma_e"}) {
    const double value = lengths[name]["value"], error = lengths[name]["standard_error"];
    CAPTURE(name, value, error);
    CHECK(std::abs(value - lengths[std::string("target_") + name]["value"].get<double>()) <= 5.4 * error);
  }
}

// The lay stands at 10 degrees; 1, the least ratio of lengths, was taken for the least direction [rad] too.
TEST_CASE("the ellipses of several surfaces lie as the lay of their kernel", "[acf-tool][statistics]") {
  REQUIRE(shell("asperity-generate --shape 96x96 --size 96um --rq 1um --length 17px,5px --angle 10deg "
                "--count 6 --seed 4 -q -o lay_%d.nc")
              .exit == 0);
  const Json all = json_of("asperity-acf -q --result lengths lay_?.nc --json");
  const auto found = [&](const std::string& quantity, const char* column) -> double {
    const Json& names = all["quantity"]["values"];
    return all[column]["values"].at(
        static_cast<std::size_t>(std::find(names.begin(), names.end(), quantity) - names.begin()));
  };
  for (const std::string name : {"ellipticity_10_direction", "ellipticity_e_direction"})
    CHECK(std::abs(found(name, "mean") - found("target_" + name, "mean")) <=
          4 * found(name, "standard_error"));
}

TEST_CASE("asperity-acf adds the ACF over both signs of the lag to the dataset and leaves the rest as it was",
          "[acf-tool][contract]") {
  for (const char* how : {"asperity-acf --max-lag 12x9 < drawn.nc | cat > with-acf.nc",
                          "asperity-acf drawn.nc --max-lag 12x9 -o with-acf.nc",
                          "asperity-acf --result dataset --max-lag 12x9 < drawn.nc > with-acf.nc"}) {
    CAPTURE(how);
    REQUIRE(run_on_surface(how).exit == 0);
    const Dataset before = read_dataset("drawn.nc"), after = read_dataset("with-acf.nc");
    for (const char* kept : {"heights", "acf_target", "p", "q"})
      CHECK(after.at(kept).values == before.at(kept).values);
    const Field acf = table_of(after, "acf");
    CHECK(shape_of(acf) == Shape{13, 19});
    CHECK(acf(0, 9) == 1);
    CHECK(numbers(after.at("lag_y").values).front() == Approx(-9 * 30e-6).epsilon(1e-14));
    CHECK(after.attributes.number("acf_length_10_x", 0) > 0);
  }
}

TEST_CASE("acf_variance is the square of Sq, whatever the ACF is scaled to, and of heights only",
          "[acf-tool][contract]") {
  const double sq = json_of("asperity-stats drawn.nc --json")["Sq"]["value"];
  for (const std::string scale : {"", " --absolute"}) {
    REQUIRE(run_on_surface("asperity-acf drawn.nc -o with-acf.nc" + scale).exit == 0);
    CHECK(relative_error(read_dataset("with-acf.nc").attributes.number("acf_variance", 0), sq * sq) <=
          100 * epsilon);
  }
  Dataset data = read_dataset("with-acf.nc");
  const Grid grid = grid_of(data);
  set_field(data, "pressure", sample(grid, [](double x, double y) { return 1e9 * (x * x + y); }),
            {"Pa", "pressure"});
  write_dataset(data, "pressed.nc");
  REQUIRE(shell("asperity-acf pressed.nc --variable pressure -q -o pressed-acf.nc").exit == 0);
  CHECK(read_dataset("pressed-acf.nc").attributes.find("acf_variance") == nullptr);
}

TEST_CASE("what asperity-acf and asperity-psd write is that of --result, on a terminal too",
          "[acf-tool][psd-tool][contract]") {
  write_dataset(drawn_surface(), "drawn.nc");
  for (const auto& [command, tables] :
       {std::pair{std::string("asperity-acf drawn.nc"), std::string("--result profiles or --result lengths")},
        {"asperity-psd drawn.nc", "--result profiles or --result radial or --result scales"}}) {
    CAPTURE(command);
    CHECK(shell(command + " | head -c 3").out == "CDF");
    const bool same =
        shell(command + " --no-history --result dataset").out == shell(command + " --no-history").out;
    CHECK(same);
    const Outcome json = shell(command + " --json"), named = shell(command + " --json -o profiles.json");
    CHECK((json.exit == 2 && named.exit == 2 && json.out.empty()));
    CHECK_THAT(json.error, EndsWith(": --json needs " + tables + ": a dataset is NetCDF\n"));
    CHECK(named.error == json.error);
    const std::string on_terminal = "script -qec '" + command;
    const Outcome binary = shell(on_terminal + "' /dev/null");
    CHECK(binary.exit == 2);
    CHECK_THAT(binary.out, ContainsSubstring("on a terminal") && ContainsSubstring(tables));
    CHECK_THAT(shell(on_terminal + " --result profiles' /dev/null").out, ContainsSubstring("standard_error"));
    CHECK(shell(command + " --result table").exit == 2);
    CHECK_THAT(shell(command + " -o table.tsv").error, ContainsSubstring(tables));
  }
}

TEST_CASE("asperity-acf --add refuses words for which the result has no place", "[acf-tool][contract]") {
  for (const auto& [options, needs] :
       {std::pair{"--add acf_quantiles --result profiles", "acf_quantiles needs --result dataset"},
        {"--add acf_quantiles --result lengths", "acf_quantiles needs --result dataset"},
        {"--add structure_function --result lengths", "structure_function needs --result dataset or"},
        {"--add structure", "'structure' is none of structure_function|acf_error|acf_quantiles"},
        {"--add acf_quantiles,acf_quantiles", "'acf_quantiles' is given twice"}}) {
    const Outcome run = run_on_surface(std::string("asperity-acf drawn.nc ") + options);
    CAPTURE(options);
    CHECK((run.exit == 2 && lines(run.error) == 1));
    CHECK_THAT(run.error, ContainsSubstring(std::string("--add: ") + needs));
  }
  for (const std::string option : {"--levels 0.5", "--direction 30deg"})
    CHECK_THAT(run_on_surface("asperity-acf drawn.nc --result profiles " + option).error,
               ContainsSubstring("needs --result dataset or --result lengths"));
  CHECK_THAT(run_on_surface("asperity-acf drawn.nc --result lengths --absolute").error,
             ContainsSubstring("--absolute needs --result dataset or --result profiles"));
}

TEST_CASE("asperity-acf measures lengths at any level and in any direction, and the ellipse of the contour",
          "[acf-tool][statistics]") {
  const Json lengths =
      json_of("asperity-acf drawn.nc --result lengths --json --levels 0.5,0.2 --direction 90deg");
  CHECK(lengths.contains("length_20_x"));
  CHECK_FALSE(lengths.contains("length_10_x"));
  CHECK(relative_error(lengths["target_length_50_x"]["value"], 4 * 20e-6) <= 10 * epsilon);
  CHECK(relative_error(lengths["length_50_direction"]["value"], lengths["length_50_y"]["value"]) <=
        10 * epsilon);
  // The window is 160 µm × 150 µm: nearly round.
  CHECK(std::abs(lengths["ellipticity_50"]["value"].get<double>() - 1) <= 0.3);
  for (const char* wrong : {"--levels 1.5", "--levels 10%", "--direction 1m"})
    CHECK(run_on_surface(std::string("asperity-acf drawn.nc --result lengths ") + wrong).exit == 2);
}

// S = 2(R(0,0) - R) over one and the same set of pairs; the sets at either end differ by the lag's share of
// points.
TEST_CASE("asperity-acf --add structure_function adds the structure function to the profiles and the dataset",
          "[acf-tool][contract]") {
  const Json table =
      json_of("asperity-acf drawn.nc --result profiles --add structure_function --absolute --json");
  const auto S = table["structure_function"]["values"].get<std::vector<double>>();
  const auto R = table["acf"]["values"].get<std::vector<double>>();
  CHECK(table["structure_function"]["unit"] == "m2");
  CHECK(S[0] == 0);
  CHECK(relative_error(S[1], 2 * (R[0] - R[1])) <= 0.1);
  REQUIRE(
      run_on_surface("asperity-acf drawn.nc --add structure_function --max-lag 12x9 -o with-acf.nc").exit ==
      0);
  CHECK(shape_of(table_of(read_dataset("with-acf.nc"), "structure_function")) == Shape{13, 19});
}

// The waves of an axis' lags are those of all lags, summed by transforms of other lengths: 1e-12 of R(0,0).
TEST_CASE("asperity-acf --add acf_error adds the errors that the profiles have", "[acf-tool][contract]") {
  for (const std::string options : {"", " --absolute", " --biased"}) {
    CAPTURE(options);
    REQUIRE(run_on_surface("asperity-acf drawn.nc --add acf_error --max-lag 12x9" + options +
                           " -o with-errors.nc")
                .exit == 0);
    const Field errors = table_of(read_dataset("with-errors.nc"), "acf_error");
    REQUIRE(shape_of(errors) == Shape{13, 19});
    const Json table = json_of("asperity-acf drawn.nc --result profiles --json --max-lag 12x9" + options);
    const auto printed = table["standard_error"]["values"].get<std::vector<double>>();
    REQUIRE(printed.size() == 13 + 10);
    const double largest = errors.maxCoeff();
    CHECK(largest > 0);
    for (Index p = 0; p <= 12; ++p)
      CHECK(std::abs(errors(p, 9) - printed[static_cast<std::size_t>(p)]) <= 1e-9 * largest);
    for (Index q = 0; q <= 9; ++q)
      CHECK(std::abs(errors(0, 9 + q) - printed[static_cast<std::size_t>(13 + q)]) <= 1e-9 * largest);
  }
  CHECK(run_on_surface("asperity-acf drawn.nc --add acf_error --result lengths").exit == 2);
}

TEST_CASE("asperity-psd adds a PSD whose sum is Sq squared, and prints rings or profiles",
          "[psd-tool][law]") {
  REQUIRE(run_on_surface("asperity-psd drawn.nc --window none -o with-psd.nc").exit == 0);
  const Dataset data = read_dataset("with-psd.nc");
  const Grid grid = grid_of(data);
  const Field psd = table_of(data, "psd");
  const double sum = psd.row(0).sum() + 2 * psd.bottomRows(psd.rows() - 1).sum();
  const double sq = json_of("asperity-stats drawn.nc --json")["Sq"]["value"];
  CHECK(relative_error(sum / (grid.size_x() * grid.size_y()), sq * sq) <= 100 * epsilon);
  CHECK(data.at("psd").attributes.text("units") == "m4");
  CHECK(data.attributes.text("psd_window") == "none");
  CHECK(data.attributes.number("psd_relative_error", 0) == 1);
  CHECK(data.attributes.number("psd_degrees_of_freedom", 0) == 2);
  CHECK(data.has("acf_target"));

  const Json rings = json_of("asperity-psd drawn.nc --result radial --json");
  CHECK(rings["psd"]["unit"] == "m4");
  const Json profiles = json_of("asperity-psd drawn.nc --result profiles --json");
  CHECK(profiles["psd"]["unit"] == "m3");
  CHECK(profiles["psd"]["values"].size() == 49 + 41);
  // The removed mean takes the longest waves; elsewhere there is a reason or an interval, and most have one.
  for (const Json& table : {rings, profiles}) {
    std::size_t known = 0;
    for (std::size_t i = 0; i < table["psd"]["values"].size(); ++i) {
      const double value = table["psd"]["values"][i];
      const Json &low = table["low_95"]["values"][i], &high = table["high_95"]["values"][i];
      const std::string why = table["no_error"]["values"][i];
      CHECK(low.is_null() == (why != "-"));
      CHECK((high.is_null() == low.is_null() &&
             table["standard_error"]["values"][i].is_null() == low.is_null()));
      if (low.is_null()) continue;
      CHECK((low.get<double>() < value && value < high.get<double>()));
      ++known;
    }
    CHECK(table["no_error"]["values"][0] == "form");
    CHECK(2 * known > table["psd"]["values"].size());
  }
  for (const char* wrong : {"--window wide", "--correlation drawn"})
    CHECK(run_on_surface(std::string("asperity-psd drawn.nc ") + wrong).exit == 2);
}

TEST_CASE("asperity-pdf counts every height once and integrates to one", "[pdf-tool][law]") {
  const Json table = json_of("asperity-pdf drawn.nc --bins 24 --json");
  const auto heights = table["height"]["values"].get<std::vector<double>>();
  double count = 0, integral = 0;
  for (double c : table["count"]["values"]) count += c;
  for (double d : table["density"]["values"]) integral += d * (heights[1] - heights[0]);
  CHECK(count == 7680);
  CHECK(integral == Approx(1).epsilon(1e-12));
  CHECK(table["density"]["unit"] == "m-1");
}

TEST_CASE("asperity-pdf's intervals hold what they are of, and none of a count or a density reaches below 0",
          "[pdf-tool][law]") {
  for (const auto& [estimate, value] :
       {std::pair{"histogram --bins 60", "count"}, {"kernel", "density"}, {"quantiles", "height"}}) {
    const Json table = json_of(std::string("asperity-pdf drawn.nc --json --estimate ") + estimate);
    for (std::size_t i = 0; i < table[value]["values"].size(); ++i) {
      const double of = table[value]["values"][i], low = table["low_95"]["values"][i],
                   high = table["high_95"]["values"][i];
      CAPTURE(estimate, i, low, of, high);
      CHECK((low <= of && of < high));
      if (value != std::string("height")) CHECK(low >= 0);
    }
  }
}

// The curve's steps are 1/8 of the bandwidth, its ends three bandwidths out: 2.7e-3 of the outermost heights
// of 7680.
TEST_CASE("asperity-pdf's kernel density integrates to one, and a wider kernel makes a lower peak",
          "[pdf-tool][law]") {
  auto peak = [](const std::string& options, double& integral) {
    const Json table = json_of("asperity-pdf drawn.nc --json --estimate kernel " + options);
    const auto heights = table["height"]["values"].get<std::vector<double>>();
    const auto density = table["density"]["values"].get<std::vector<double>>();
    integral = std::accumulate(density.begin(), density.end(), 0.0) * (heights[1] - heights[0]);
    return *std::max_element(density.begin(), density.end());
  };
  double narrow = 0, wide = 0;
  CHECK(peak("", narrow) > peak("--bandwidth 0.8 --rows 500", wide));
  CHECK(std::abs(narrow - 1) <= 1e-5);
  CHECK(std::abs(wide - 1) <= 1e-5);
}

// A sample of one value has no moments, and was refused.
TEST_CASE("asperity-pdf counts a part of one value in one bin, without an error", "[pdf-tool][contract]") {
  REQUIRE(run_on_surface("asperity-psd drawn.nc -o part.nc").exit == 0);
  Dataset data = read_dataset("part.nc");
  const Shape shape = grid_of(data).shape;
  Field pressure = Field::Zero(shape.nx, shape.ny);
  pressure.block(3, 4, 10, 6).setConstant(2e6);
  set_field(data, "pressure", pressure, {"Pa", "pressure"});
  write_dataset(data, "part.nc");
  const Json bins = json_of("asperity-pdf part.nc --json --variable pressure"),
             median =
                 json_of("asperity-pdf part.nc --json --variable pressure --estimate quantiles --rows 1");
  CHECK(bins["count"]["values"] == Json::array({60}));
  CHECK(bins["low_95"]["values"][0].is_null());
  CHECK(median["pressure"]["values"][0] == 2e6);
  CHECK(median["standard_error"]["values"][0].is_null());
}

TEST_CASE("asperity-pdf's quantiles rise, and their median is that of asperity-stats", "[pdf-tool][law]") {
  const Json table = json_of("asperity-pdf drawn.nc --json --estimate quantiles --rows 21");
  const auto heights = table["height"]["values"].get<std::vector<double>>();
  CHECK(heights.size() == 21);
  CHECK(std::is_sorted(heights.begin(), heights.end()));
  CHECK(table["share"]["values"][10] == 0.5);
  const Json median = json_of("asperity-stats drawn.nc --json --quantiles 0.5");
  CHECK(heights[10] == median["quantile_0.5"]["value"]);
  CHECK(table["standard_error"]["values"][10] == median["quantile_0.5"]["standard_error"]);
}

TEST_CASE("options of another estimate, or beyond its bounds, are refused by name", "[pdf-tool][contract]") {
  for (const auto& [options, name] : {std::pair{"--bandwidth 0.2", "--bandwidth"},
                                      {"--rows 9", "--rows"},
                                      {"--estimate kernel --bins 4", "--bins"},
                                      {"--estimate quantiles --bandwidth 1", "--bandwidth"},
                                      {"--estimate kernel --bandwidth 0", "--bandwidth"},
                                      {"--estimate kernel --bandwidth 1e-9", "--bandwidth"},
                                      {"--estimate kernel --rows 1", "--rows"},
                                      {"--estimate mode", "--estimate"}}) {
    const Outcome run = run_on_surface(std::string("asperity-pdf drawn.nc ") + options);
    CAPTURE(options, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1 && run.error.find(name) != std::string::npos));
  }
}
