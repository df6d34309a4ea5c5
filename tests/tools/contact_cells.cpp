// Which cells of a contact a distribution counts.
#include <numeric>

#include <nlohmann/json.hpp>

#include "tools/contact_runs.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

void press_flat() {
  require(
      "asperity-generate --shape 128x96 --size 1mm,0.75mm --rq 0.4um --length 8px --periodic --seed 3 "
      "| asperity-contact --load 40N -o pressed.nc" +
      elastic);
}

nlohmann::json table(const std::string& options) {
  return nlohmann::json::parse(require("asperity-pdf pressed.nc --json " + options).out);
}

}  // namespace

TEST_CASE("the distribution of the pressure counts the cells in contact, that of the gap the open ones",
          "[pdf-tool][contact][law]") {
  press_flat();
  const Dataset data = read_dataset("pressed.nc");
  const double load = 40, cell = 1e-3 * 0.75e-3 / (128 * 96);
  double cells = 0, counted = 0;
  for (const char* variable : {"pressure", "gap"}) {
    const auto json = table(std::string("--bins 200 --variable ") + variable);
    auto column = [&](const char* name) { return json[name]["values"].get<std::vector<double>>(); };
    const auto value = column(variable), count = column("count"), share = column("share"),
               density = column("density");
    const double width = value[1] - value[0];
    double sum = 0, all = 0, integral = 0, mean = 0;
    for (std::size_t k = 0; k < value.size(); ++k) {
      sum += count[k], all += share[k], integral += density[k] * width;
      mean += count[k] * value[k];
    }
    const Field state = field_of(data, "contact");
    const double expected =
        static_cast<double>(variable[0] == 'p' ? (state > 0).count() : (state == 0).count());
    CHECK(sum == expected);
    CHECK(relative_error(all, expected / (128 * 96)) <= 1e-12);
    CHECK(relative_error(integral, 1) <= 1e-12);
    // Half a width is the most that a value differs from its bin's centre.
    const double total =
        variable[0] == 'p' ? load / cell : data.attributes.number("contact_mean_gap", 0) * 128 * 96;
    CHECK(std::abs(mean - total) <= sum * width / 2);
    CHECK(json["standard_error"]["values"][20].get<double>() > 0);
    CHECK(json[variable]["unit"] == (variable[0] == 'p' ? "Pa" : "m"));
    cells = 128 * 96, counted += sum;
  }
  CHECK(counted == cells);
}

TEST_CASE("which cells are counted is told, and that asperity-stats averages all",
          "[pdf-tool][contact][contract]") {
  press_flat();
  const Attributes a = read_dataset("pressed.nc").attributes;
  const std::string in_contact =
      std::to_string(std::lround(a.number("contact_area", 0) / (1e-3 * 0.75e-3 / (128 * 96))));
  CHECK_THAT(shell("asperity-pdf pressed.nc --variable pressure").error,
             ContainsSubstring("pressure of the " + in_contact + " cells that are in contact; the other") &&
                 ContainsSubstring("% of 12288 cells are open, without pressure, and not counted"));
  CHECK_THAT(shell("asperity-pdf pressed.nc --variable gap").error, ContainsSubstring("cells that are open"));
  CHECK_THAT(shell("asperity-stats pressed.nc --variable pressure").error,
             ContainsSubstring("pressure of all 12288 cells, of which " + in_contact + " are in contact"));
  CHECK(shell("asperity-pdf pressed.nc").error.find("cells") == std::string::npos);
}

// "1 cells that are" was printed.
TEST_CASE("one cell in contact is spoken of as one", "[pdf-tool][contract]") {
  require("asperity-contact -q --smooth --shape 17x17 --size 1mm --radius 1mm --load 1mN -o one.nc" + elastic);
  CHECK_THAT(shell("asperity-pdf one.nc --variable pressure").error,
             ContainsSubstring("of the 1 cell that is in contact; the other 99.7 % of 289 cells"));
  CHECK_THAT(shell("asperity-stats one.nc --variable pressure").error,
             ContainsSubstring("of which 1 is in contact"));
}

TEST_CASE("a part of the cells has quantiles, and no form, filter, kernel or correlation",
          "[pdf-tool][contact][contract]") {
  press_flat();
  const auto json = table("--variable pressure --estimate quantiles --rows 9");
  const auto value = json["pressure"]["values"].get<std::vector<double>>();
  CHECK(std::ranges::is_sorted(value));
  CHECK(value.front() > 0);
  CHECK(json["standard_error"]["values"][4].get<double>() > 0);
  for (const char* option : {"--remove-form plane", "--lambda-c 0.2mm", "--lambda-s 50um",
                             "--correlation estimate", "--estimate kernel"}) {
    const Outcome run = shell(std::string("asperity-pdf pressed.nc --variable pressure ") + option);
    CAPTURE(option, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1));
  }
  CHECK_THAT(shell("asperity-pdf pressed.nc --variable pressure --bins 100000").error,
             ContainsSubstring("--bins: '100000' is above the number of points, 393"));
}

// Over ever so many surfaces the intervals cover 94 to 99 % (stats/uncertainty/share_error.hpp), and 1.96 errors, less
// than Student's t, some two per cent less: of 40, three standard errors of 92 % less, 31.
TEST_CASE("the errors of quantiles are those of contact after contact",
          "[pdf-tool][contact][statistics][slow]") {
  struct Medians {
    const char* variable;
    int least;
    std::vector<double> values = {}, errors = {};
  };
  Medians all[] = {{"pressure", 31}, {"gap", 31}};
  for (int seed = 0; seed < 40; ++seed) {
    require(
        "asperity-generate --shape 128x128 --size 1mm --rq 0.4um --length 8px --model gaussian --periodic "
        "--seed " +
        std::to_string(seed) + " | asperity-contact -q --load 100N --tolerance 1e-4 -o pressed.nc" + elastic);
    for (Medians& m : all) {
      const auto json = table(std::string("-q --estimate quantiles --rows 1 --variable ") + m.variable);
      m.values.push_back(json[m.variable]["values"][0]);
      m.errors.push_back(json["standard_error"]["values"][0]);
    }
  }
  for (const Medians& m : all) {
    const double mean = std::accumulate(m.values.begin(), m.values.end(), 0.0) / 40;
    int covered = 0;
    for (std::size_t k = 0; k < m.values.size(); ++k)
      covered += std::abs(m.values[k] - mean) <= 1.96 * m.errors[k];
    CAPTURE(m.variable);
    CHECK(covered >= m.least);
  }
}
