// asperity-contact and asperity-stress on several surfaces: rows, means, and what happens to one that fails.
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr std::size_t members = 3;
const std::string press_each = "asperity-contact -q" + steel;

// c_1.nc, c_2.nc, c_3.nc: oblong, with dx ≠ dy, periodic.
void draw_members(const std::string& length) {
  require("asperity-generate -q --periodic --shape 32x24 --size 1mm,0.5mm --rq 0.4um " + length +
          " --seed 1 --first 1 --count 3 -o c_%d.nc");
}

// And their contacts, p_1.nc, p_2.nc, p_3.nc.
void press_members() {
  draw_members("--length 100um");
  require(press_each + "--load 60N 'c_?.nc' --each p_%d.nc -o contacts.tsv");
}

std::string member(char kind, std::size_t k) {
  return std::string(1, kind) + "_" + std::to_string(k + 1) + ".nc";
}

// Mean and standard error of three values, by two sums.
void check_mean(double mean, double error, const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double v : values) sum += v;
  for (const double v : values) squares += std::pow(v - sum / members, 2);
  const double expected = std::sqrt(squares / (members - 1) / members);
  CHECK(relative_error(mean, sum / members) <= 10 * epsilon);
  CHECK(std::abs(error - expected) <= 1e-9 * expected + 10 * epsilon * std::abs(sum));
}

// Solutions that share their influence coefficients are the same to the last bit: the same sums.
void check_rows(const std::string& command, char kind, const std::string& prefix,
                const std::vector<std::string>& names) {
  const Printed all = printed(command + "'" + kind + std::string("_?.nc'"));
  CHECK(all.rows == std::vector<std::string>{member(kind, 0), member(kind, 1), member(kind, 2), "mean",
                                             "standard_error", "spread"});
  for (std::size_t k = 0; k < members; ++k) {
    const Attributes own = attributes_of(command + member(kind, k));
    for (const std::string& name : names) {
      CAPTURE(name, k);
      CHECK(all[name][k] == own.number(prefix + name, NAN));
    }
  }
  for (const std::string& name : names) {
    CAPTURE(name);
    const auto& column = all[name];
    check_mean(column[members], column[members + 1], {column[0], column[1], column[2]});
    const double spread = std::sqrt(members) * column[members + 1];
    CHECK(std::abs(column[members + 2] - spread) <= 4 * epsilon * spread);
  }
}

// A table over the surfaces at each load or depth, whose errors are named.
void check_means(const std::string& command, char kind, const std::string& name, const std::string& error) {
  const Printed all = printed(command + "'" + kind + std::string("_?.nc'"));
  std::vector<std::vector<double>> own;
  for (std::size_t k = 0; k < members; ++k) own.push_back(printed(command + member(kind, k))[name]);
  for (std::size_t l = 0; l < 3; ++l) {
    CAPTURE(name, l);
    check_mean(all[name][l], all[error][l], {own[0][l], own[1][l], own[2][l]});
    CHECK(all["surfaces"][l] == members);
  }
}

}  // namespace

TEST_CASE("each of several surfaces has the row of its own contact, and the mean is that of the rows",
          "[contact][several][law]") {
  draw_members("--model gaussian --length 250um");
  const std::string load = press_each + "--load 60N --add contact_stiffness,contact_ratios ";
  check_rows(load, 'c', "contact_",
             {"load", "approach", "max_pressure", "area", "mean_gap", "stiffness", "kappa"});
  const Printed all = printed(load + "'c_?.nc'");
  CHECK(all["converged"][1] == 1);
  CHECK(std::isnan(all["converged"][members]));
  CHECK_FALSE(all.has("hertz_pressure"));
}

// Of none or all of three, Wilson's interval ends z²/(3 + z²) away, z = 1.96: z/(3 + z²) as an error.
TEST_CASE("a share of several surfaces has an error where all of them agree", "[contact][several][law]") {
  draw_members("--model gaussian --length 250um");
  const Printed all = printed(press_each + "--load 60N --add patches 'c_?.nc'");
  for (const char* name : {"percolates_x", "percolates_y"}) {
    const auto& column = all[name];
    const bool agree = column[0] == column[1] && column[1] == column[2];
    CAPTURE(name, column);
    CHECK((column[members] == 0 || column[members] == 1) == agree);
    if (agree) CHECK(relative_error(column[members + 1], 1.959964 / (3 + 3.841459)) <= 1e-6);
    CHECK(column[members + 1] > 0.2);
  }
}

TEST_CASE("sweeps of several surfaces are averaged at each load", "[contact][several][law]") {
  draw_members("--model gaussian --length 250um");
  const std::string sweep = press_each + "--sweep 20N:80N:3 ";
  for (const std::string name : {"approach", "area", "stiffness", "max_pressure"})
    check_means(sweep, 'c', name, name + "_standard_error");
  CHECK(relative_error(printed(sweep + "'c_?.nc'")["load"][1], 40) <= 1e-9);
}

TEST_CASE("with --each the dataset of each surface is written, as it is for one",
          "[contact][several][contract]") {
  draw_members("--model gaussian --length 250um");
  const std::string load = press_each + "--load 60N --limit-pressure 3GPa --add heights_residual ";
  require("ls c_?.nc | " + load + "--files-from - --each each_%d.nc -o rows.tsv");
  for (std::size_t k = 0; k < members; ++k) {
    require(load + member('c', k) + " -o one.nc");
    for (const char* name : {"heights", "pressure", "gap", "heights_residual"})
      CHECK(values_in("each_" + std::to_string(k + 1) + ".nc", name) == values_in("one.nc", name));
  }
}

TEST_CASE("a surface that fails is a row without a result, and not in the mean",
          "[contact][several][contract]") {
  draw_members("--model gaussian --length 250um");
  require("head -c 3000 c_2.nc > cut.nc");
  Dataset data = read_dataset("c_2.nc");
  std::get<std::vector<double>>(data.find("heights")->values)[5] = INFINITY;
  write_dataset(data, "infinite.nc");
  const Printed two = printed(press_each + "--load 60N c_1.nc c_3.nc");
  for (const std::string bad : {"cut.nc", "infinite.nc"}) {
    const Outcome run = shell(press_each + "--load 60N c_1.nc " + bad + " c_3.nc");
    CAPTURE(run.error);
    CHECK(run.exit == 4);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring("warning: " + bad + ": "));
    const Printed all(run.out);
    CHECK(std::isnan(all["area"][1]));
    CHECK(all["converged"][1] == 0);
    CHECK(all["area"][3] == two["area"][2]);
    CHECK(all["area"][4] == two["area"][3]);
    CHECK(shell(press_each + "--sweep 20N,60N c_1.nc " + bad + " c_3.nc").exit == 4);
  }
  const Outcome untouched = shell(press_each + "--approach 1nm 'c_?.nc'");  // peaks are higher or not
  CHECK((untouched.exit == 0 || untouched.exit == 2));
  const Outcome stopped = shell(press_each + "--load 60N --max-convolutions 1 'c_?.nc'");
  CHECK(stopped.exit == 3);
  CHECK(lines(stopped.error) == 2);  // the first in full, and two more
  const Printed none(stopped.out);
  CHECK(none["converged"][0] == 0);
  CHECK(none["area"][0] > 0);
  CHECK(std::isnan(none["area"][members]));
}

TEST_CASE("each of several surfaces has the row of its own largest stress, and the mean is that of the rows",
          "[stress][several][law]") {
  press_members();
  const std::string command = "asperity-stress -q --maximum --below 2px ";
  check_rows(command, 'p', "stress_", {"max_von_mises", "max_depth"});
  CHECK(std::isnan(printed(command + "'p_?.nc'")["max_x"][members]));  // places in a period have no mean
}

TEST_CASE("the maximum by depth is averaged over several surfaces", "[stress][several][law]") {
  press_members();
  check_means("asperity-stress -q --result maxima --of max_shear --depths 2px:0.2mm:3 ", 'p', "max_shear",
              "standard_error");
}

TEST_CASE("a surface without a stress is a row without numbers, and warnings are told once",
          "[stress][several][contract]") {
  press_members();
  const Outcome run = shell("asperity-stress -q --maximum p_1.nc c_1.nc p_2.nc p_3.nc");
  CHECK(run.exit == 4);
  CHECK_THAT(run.error, ContainsSubstring("warning: c_1.nc: pressure is missing"));
  const Printed all(run.out), three(shell("asperity-stress --maximum 'p_?.nc'").out);
  CHECK(std::isnan(all["max_von_mises"][1]));
  CHECK(all["max_von_mises"][4] == three["max_von_mises"][3]);
  // Maxima near the surface of so few cells are doubted, for all of them in two lines.
  const Outcome shallow = shell("asperity-stress -q --maximum 'p_?.nc'");
  CHECK(lines(shallow.error) == 2);
  CHECK_THAT(shallow.error,
             ContainsSubstring("2 more surfaces, up to p_3.nc: the largest von Mises stress lies"));
}
