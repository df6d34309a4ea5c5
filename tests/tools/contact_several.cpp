// asperity-contact on several surfaces: rows, means, and what happens to one that fails.
#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "contact_runs.hpp"

using namespace asperity;
using namespace asperity::test;
using Json = nlohmann::json;

namespace {

constexpr std::size_t members = 3;
const std::string press = "asperity-contact -q --young 208GPa --poisson 0.3 ";

// c_0.nc, c_1.nc, c_2.nc: oblong, with dx ≠ dy, periodic.
void draw() {
  static const bool drawn =
      shell(
          "asperity-generate -q --periodic --shape 32x24 --size 1mm,0.5mm --rq 0.4um --model gaussian --length 250um "
          "--seed 1 --count 3 -o c_%d.nc")
          .exit == 0;
  REQUIRE(drawn);
}

std::vector<double> column(const Json& table, const std::string& name) {
  std::vector<double> out;
  for (const Json& value : table.at(name)["values"])
    out.push_back(value.is_null() ? NAN : value.get<double>());
  return out;
}

}  // namespace

// Solutions that share their influence coefficients are the same to the last bit: the same sums.
TEST_CASE("each of several surfaces has the row of its own contact, and the mean is that of the rows",
          "[contact][several][law]") {
  draw();
  const std::string load = press + "--load 60N --add contact_stiffness,contact_ratios ";
  const Json all = Json::parse(require(load + "'c_?.nc' --json").out);
  const Json& names = all["surface"]["values"];
  CHECK(names == Json({"c_0.nc", "c_1.nc", "c_2.nc", "mean", "standard_error"}));
  for (const std::string name :
       {"load", "approach", "max_pressure", "area", "mean_gap", "stiffness", "kappa"}) {
    double sum = 0, squares = 0;
    const std::vector<double> rows = column(all, name);
    for (std::size_t k = 0; k < members; ++k) {
      const double own = attributes(load + "c_" + std::to_string(k) + ".nc").number("contact_" + name, NAN);
      CAPTURE(name, k);
      CHECK(rows[k] == own);
      sum += own;
    }
    for (std::size_t k = 0; k < members; ++k) squares += std::pow(rows[k] - sum / members, 2);
    const double error = std::sqrt(squares / (members - 1) / members);
    CAPTURE(name);
    CHECK(relative_error(rows[members], sum / members) <= 10 * epsilon);
    CHECK(std::abs(rows[members + 1] - error) <= 1e-12 * std::abs(error) + 10 * epsilon * std::abs(sum));
  }
  CHECK(column(all, "converged")[1] == 1);
  CHECK(std::isnan(column(all, "converged")[members]));
  CHECK(!all.contains("hertz_pressure"));
}

TEST_CASE("sweeps of several surfaces are averaged at each load", "[contact][several][law]") {
  draw();
  const std::string sweep = press + "--sweep 20N:80N:3 --json ";
  const Json all = Json::parse(require(sweep + "'c_?.nc'").out);
  for (const std::string name : {"approach", "area", "stiffness", "max_pressure"})
    for (std::size_t l = 0; l < 3; ++l) {
      std::vector<double> values;
      for (std::size_t k = 0; k < members; ++k)
        values.push_back(column(Json::parse(require(sweep + "c_" + std::to_string(k) + ".nc").out), name)[l]);
      const double mean = (values[0] + values[1] + values[2]) / 3;
      const double error = std::sqrt(
          (std::pow(values[0] - mean, 2) + std::pow(values[1] - mean, 2) + std::pow(values[2] - mean, 2)) /
          6);
      CAPTURE(name, l);
      CHECK(relative_error(column(all, name)[l], mean) <= 10 * epsilon);
      CHECK(relative_error(column(all, name + "_standard_error")[l], error) <= 1e-9);
      CHECK(column(all, "surfaces")[l] == 3);
    }
  CHECK(relative_error(column(all, "load")[1], 40) <= 1e-9);
}

TEST_CASE("with --each the dataset of each surface is written, as it is for one",
          "[contact][several][contract]") {
  draw();
  const std::string load = press + "--load 60N --limit-pressure 3GPa --add heights_residual ";
  require("ls c_0.nc c_1.nc c_2.nc | " + load + "--files-from - --each each_%d.nc -o rows.tsv");
  for (const int k : {0, 1, 2}) {
    require(load + "c_" + std::to_string(k) + ".nc -o one.nc");
    const Dataset one = read_dataset("one.nc"), each = read_dataset("each_" + std::to_string(k + 1) + ".nc");
    for (const char* name : {"heights", "pressure", "gap", "heights_residual"})
      CHECK(each.at(name).values == one.at(name).values);
  }
}

TEST_CASE("a surface that fails is a row without a result, and not in the mean",
          "[contact][several][contract]") {
  draw();
  require("head -c 3000 c_1.nc > cut.nc");
  Dataset data = read_dataset("c_1.nc");
  std::get<std::vector<double>>(data.find("heights")->values)[5] = INFINITY;
  write_dataset(data, "infinite.nc");
  const Json two = Json::parse(require(press + "--load 60N c_0.nc c_2.nc --json").out);
  for (const std::string bad : {"cut.nc", "infinite.nc"}) {
    const Outcome run = shell(press + "--load 60N c_0.nc " + bad + " c_2.nc --json");
    CAPTURE(run.error);
    CHECK(run.exit == 4);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring("warning: " + bad + ": "));
    const Json all = Json::parse(run.out);
    CHECK(std::isnan(column(all, "area")[1]));
    CHECK(column(all, "converged")[1] == 0);
    CHECK(column(all, "area")[3] == column(two, "area")[2]);
    CHECK(column(all, "area")[4] == column(two, "area")[3]);
    CHECK(shell(press + "--sweep 20N,60N c_0.nc " + bad + " c_2.nc").exit == 4);
  }
  const Outcome untouched =
      shell(press + "--approach 1nm 'c_?.nc'");  // the surfaces' peaks are higher or not
  CHECK((untouched.exit == 0 || untouched.exit == 2));
  const Outcome stopped = shell(press + "--load 60N --max-convolutions 1 'c_?.nc' --json");
  CHECK(stopped.exit == 3);
  CHECK(lines(stopped.error) == 2);  // the first in full, and two more
  const Json none = Json::parse(stopped.out);
  CHECK(column(none, "converged")[0] == 0);
  CHECK(column(none, "area")[0] > 0);
  CHECK(std::isnan(column(none, "area")[members]));
}

TEST_CASE("what several surfaces do not allow is refused before the work", "[contact][several][contract]") {
  draw();
  require(
      "asperity-generate -q --periodic --shape 32x32 --size 1mm --rq 0.4um --model gaussian --length 250um --seed 1 -o "
      "other.nc");
  for (const auto& [options, code, words] :
       {std::tuple{"--load 60N --report r.json", 2, "--report belongs to one contact"},
        {"--sweep 20N,60N --each e_%d.nc", 2, "--each"},
        {"--load 60N --each c_%d.nc", 2, "is an input of this run"},
        {"--load 60N --limit-pressure 3GPa --add heights_residual", 2, "needs --each"},
        {"--load 60N -o table.nc", 2, "--output"},
        {"--load 60N c_1.nc", 2, "'c_1.nc' is given twice"},
        {"--load 60N other.nc", 4, "other.nc: its grid, 32x32 cells"},
        {"--load 60N absent.nc", 1, "absent.nc: No such file"}}) {
    const Outcome run = shell(press + "c_0.nc c_1.nc c_2.nc " + options);
    CAPTURE(options, run.error);
    CHECK(run.exit == code);
    CHECK((run.out.empty() && lines(run.error) == 1));
    CHECK_THAT(run.error, ContainsSubstring(words));
  }
  CHECK_THAT(shell(press + "c_0.nc --load 60N --json").error, ContainsSubstring("or of several surfaces"));
  CHECK_THAT(shell(press + "c_0.nc --load 60N --each e_%d.nc").error,
             ContainsSubstring("--each needs --sweep or"));
}
