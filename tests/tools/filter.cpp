// asperity-filter: what each step does and tells. The operators themselves are tested in tests/stats.
#include <numbers>
#include <utility>

#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "tools/maps.hpp"

using namespace asperity;
using namespace asperity::test;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

// Heights of some µm on 32 × 24 points of 2 µm × 3 µm.
const Grid grid{{32, 24}, 2e-6, 3e-6};

Field rough() { return 1e-6 * random_field(grid.shape, 5); }

std::string filtered(const std::string& steps, const std::string& name = "out.nc") {
  require("asperity-filter -q map.nc " + steps + " -o " + name);
  return last_run(name);
}

}  // namespace

// A plane a + bx + cy has the rms √(b² var x + c² var y) about its mean, where var of n points a step apart is
// (n² - 1)/12: √(0.2² · 85.25 + 0.06² · 47.92) µm. A checkerboard of ±0.1 µm has no plane.
TEST_CASE("history tells the rms and the mean of a form that was removed, and what is left",
          "[filter][exact]") {
  const Field plane = sample(grid, [](double x, double y) { return 4e-6 + 0.1 * x - 0.02 * y; });
  const Field checks = Field::NullaryExpr(
      grid.shape.nx, grid.shape.ny, [](Index i, Index j) { return (i / 2 + j / 2) % 2 == 0 ? 1e-7 : -1e-7; });
  write_map(plane + checks, grid, "map.nc");
  CHECK_THAT(
      filtered("--remove-form plane"),
      EndsWith("\n  1. remove-form plane: removed 1.893um rms about a mean of 4um; 100nm rms is left"));
  CHECK(same_bits(heights_in("out.nc"), remove_form(heights_in("map.nc"), 1)));
  CHECK(read_dataset("out.nc").attributes.number("filter_form_degree", 0) == 1);
}

// Ripples of 1 nm leave an error of R of about 10 R² σ/(L² √N) = 0.6 nm/5 mm; the axis is at most a quarter off.
TEST_CASE("history tells the radius of a ball or of a bowl that was removed, and the axis of a cylinder",
          "[filter][exact]") {
  const Grid square{{64, 48}, 1e-5, 1e-5};
  const double r = 5e-3, turn = std::numbers::pi / 6;
  const Field ripples =
      sample(square, [](double x, double y) { return 1e-9 * std::sin(3e5 * x) * std::cos(2e5 * y); });
  const auto cap = [&](double d) { return std::sqrt(r * r - d * d) - r; };
  write_map(ripples + sample(square, [&](double x, double y) { return cap(std::hypot(x, y)); }), square,
            "map.nc");
  CHECK_THAT(filtered("--remove-form sphere"),
             ContainsSubstring("1. remove-form sphere: a dome of radius 5mm; removed "));
  CHECK(heights_in("out.nc").abs().maxCoeff() <= 2e-9);
  CHECK(read_dataset("out.nc").attributes.number("filter_form_degree", 0) == 2);
  const Field across =
      sample(square, [&](double x, double y) { return -cap(y * std::cos(turn) - x * std::sin(turn)); });
  write_map(ripples + across, square, "map.nc");
  CHECK_THAT(filtered("--remove-form cylinder"),
             ContainsSubstring("1. remove-form cylinder: a bowl of radius 5mm, axis at 30deg; removed "));
  CHECK(heights_in("out.nc").abs().maxCoeff() <= 2e-9);
  // The same surface by asperity-stats.
  const auto sq = [](const std::string& line) { return shell(line + " --json | jq .Sq.value").out; };
  CHECK(std::stod(sq("asperity-stats -q map.nc --errors none --remove-form cylinder")) ==
        Catch::Detail::Approx(std::stod(sq("asperity-stats -q out.nc --errors none"))).epsilon(1e-9));
}

TEST_CASE("the steps of waves are the library's filters, and keep the waves on their side",
          "[filter][exact]") {
  write_map(rough(), grid, "map.nc");
  const Field z = heights_in("map.nc"),
              long_waves = gaussian_mean_surface(z, grid_of(read_dataset("map.nc")), 20e-6);
  CHECK_THAT(filtered("--lambda-s 20um"), ContainsSubstring("\n  1. lambda-s 20um: removed "));
  // Heights of some µm; transforms in another program may add in another order.
  const double round_off = 100 * epsilon * 4e-6;
  CHECK((heights_in("out.nc") - long_waves).abs().maxCoeff() <= round_off);
  filtered("--lambda-c 20um");
  CHECK((heights_in("out.nc") - (z - long_waves)).abs().maxCoeff() <= round_off);
  filtered("--lambda-c 20um,gaussian", "same.nc");
  CHECK(same_bits(heights_in("out.nc"), heights_in("same.nc")));
}

TEST_CASE("a map is cut, then thinned, with the spacing that follows", "[filter][exact]") {
  write_map(rough(), grid, "map.nc");
  CHECK_THAT(filtered("--crop 1:6,:3 --decimate 2x1"),
             ContainsSubstring("\n  1. crop 1:6,:3: now 5x3 cells on 10um x 9um") &&
                 ContainsSubstring("\n  2. decimate 2x1: now 3x3 cells on 12um x 9um"));
  const Field z = heights_in("map.nc");
  CHECK(same_bits(heights_in("out.nc"), z(Eigen::seqN(1, 3, 2), Eigen::seqN(0, 3))));
  const Grid cut = grid_of(read_dataset("out.nc"));
  CHECK(relative_error(cut.dx, 4e-6) <= 4 * epsilon);
  CHECK(relative_error(cut.dy, 3e-6) <= 4 * epsilon);
}

// About one missing point of a plane the membrane is the plane itself, 31; the others sum to 24 · 26.5 - 31.
TEST_CASE("a missing point is filled by a membrane, the mean or the least height", "[filter][exact]") {
  Field z = Field::NullaryExpr(6, 4, [](Index i, Index j) { return 1e-6 * static_cast<double>(10 * i + j); });
  z(3, 1) = NAN;
  write_map(z, {{6, 4}, 1e-6, 2e-6}, "map.nc");
  auto value = [](const std::string& how) {
    CHECK_THAT(filtered("--fill " + how), ContainsSubstring("fill " + how + ": filled 1 of 24 points"));
    CHECK(!read_dataset("out.nc").has("mask"));
    return heights_in("out.nc")(3, 1) / 1e-6;
  };
  CHECK(std::abs(value("laplace") - 31) <= 1e-12);
  CHECK(std::abs(value("mean") - (24 * 26.5 - 31) / 23) <= 1e-12);
  CHECK(value("least") == 0);
}

TEST_CASE("decimation by one number thins both axes", "[filter][exact]") {
  write_map(rough(), grid, "map.nc");
  filtered("--decimate 3", "one.nc");
  filtered("--decimate 3x3", "two.nc");
  CHECK(same_bits(heights_in("one.nc"), heights_in("two.nc")));
}

// The ball of a quarter of the map on a plane, and a taper: neither is what it seems.
TEST_CASE("a step that leaves more than it removes, or fades heights, says so", "[filter][contract]") {
  const Grid square{{64, 64}, 1e-6, 1e-6};
  const Field ball =
      sample(square, [](double x, double y) { return std::sqrt(std::max(0.0, 400e-12 - x * x - y * y)); });
  write_map(ball, square, "map.nc");
  CHECK_THAT(require("asperity-filter map.nc --remove-form sphere -o out.nc").error,
             ContainsSubstring("no more was removed than is left: --crop the map to the sphere"));
  CHECK_THAT(require("asperity-filter map.nc --crop 24:40,24:40 --remove-form sphere -o out.nc").error,
             !ContainsSubstring("--crop the map"));
  CHECK_THAT(require("asperity-filter map.nc --make-periodic x,taper=9um -o out.nc").error,
             ContainsSubstring("errors of parameters are too large"));
}

TEST_CASE("outliers become missing and are counted, and other points stay as they are", "[filter][exact]") {
  Field z = rough();
  for (const auto& [i, j] : {std::pair<Index, Index>{4, 5}, {20, 11}, {0, 13}}) z(i, j) = 1e-3;
  write_map(z, grid, "map.nc");
  const std::string told =
      "outliers 20: 3 of 768 points (0.39 %) made missing: they stand out from all sides by more than 20 "
      "standard deviations of the surface there (";
  CHECK_THAT(filtered("--outliers 20"), ContainsSubstring(told));
  z = (z == 1e-3).select(NAN, z);
  CHECK(same_bits(heights_in("out.nc"), z));
  CHECK_THAT(filtered("--outliers 20,7px --fill laplace"),
             ContainsSubstring("2. fill laplace: filled 3 of 768"));
  CHECK_FALSE(heights_in("out.nc").hasNaN());
  const std::string line = "asperity-filter map.nc --outliers 20 --fill mean --scale 2 -o out.nc";
  const Outcome run = require(line);
  CHECK_THAT(run.error, StartsWith("asperity-filter: " + told) && ContainsSubstring("m over 1 point, ") &&
                            EndsWith("asperity-filter: fill mean: filled 3 of 768 points (0.39 %)\n"));
  CHECK(require(line + " -q").error.empty());
}

// Medians of windows took 5 to 13 % of the points of waves. What many points do is told with a doubt.
TEST_CASE("a smooth map without outliers keeps its points, a spiky one is told to be so",
          "[filter][contract]") {
  const Grid wide{{96, 96}, 1e-6, 1e-6};
  const Field waves = sample(wide, [](double x, double y) {
    return 1e-6 * (std::sin(2e5 * x) + std::cos(1.5e5 * y - 1e5 * x) + std::sin(1e5 * x + 1.7e5 * y));
  });
  write_map(waves, wide, "map.nc");
  CHECK_THAT(filtered("--outliers 5"), ContainsSubstring("0 of 9216 points made missing: none stands out"));
  CHECK(same_bits(heights_in("out.nc"), heights_in("map.nc")));
  // In steps: each tenth point lies one off.
  write_map(1e-6 * (0.55 * random_field(wide.shape, 7)).round(), wide, "map.nc");
  CHECK_THAT(filtered("--outliers 5"), ContainsSubstring("0 of 9216 points made missing"));
  write_map(1e-6 * (1.5 * random_field(wide.shape, 6)).tan(), wide, "map.nc");
  CHECK_THAT(filtered("--outliers 5"),
             ContainsSubstring("); or the surface itself is spiky: ") &&
                 ContainsSubstring(" % of all heights lie beyond 5 robust deviations"));
}

TEST_CASE("a quarter turn four times, two mirrors and two changes of sign are nothing, to the bit",
          "[filter][law]") {
  Field z = rough();
  z(3, 4) = NAN;
  write_map(z, grid, "map.nc");
  const Field before = heights_in("map.nc");
  for (const char* steps :
       {"--rotate 90deg --rotate 90deg --rotate 180deg", "--mirror both --mirror x --mirror y",
        "--scale -1 --scale -1", "--scale 4 --scale 0.25"}) {
    CAPTURE(steps);
    filtered(steps);
    CHECK(same_bits(heights_in("out.nc"), before));
  }
  CHECK_THAT(filtered("--mirror x"), ContainsSubstring("mirror x: x reversed"));
  CHECK(same_bits(heights_in("out.nc"), before.colwise().reverse()));
  filtered("--scale -2");
  CHECK(same_bits(heights_in("out.nc"), -2 * before));
}

// Steps of the ball's opening and closing lie on either side of the heights.
TEST_CASE("a closing raises, an opening lowers, and the history tells how many points moved",
          "[filter][law]") {
  write_map(rough(), grid, "map.nc");
  const Field z = heights_in("map.nc");
  CHECK_THAT(filtered("--closing 50um"), ContainsSubstring("closing 50um: moved "));
  CHECK((heights_in("out.nc") >= z - 1e-18).all());
  filtered("--opening 50um");
  CHECK((heights_in("out.nc") <= z + 1e-18).all());
  filtered("--closing 50um --scale -1 --opening 50um --scale -1", "turned.nc");
  filtered("--closing 50um", "once.nc");
  CHECK((heights_in("turned.nc") - heights_in("once.nc")).abs().maxCoeff() <= 1e-18 + 50e-6 * 4 * epsilon);
}

TEST_CASE("an axis that is made periodic is marked, and the jump at its seam is told", "[filter][exact]") {
  write_map(sample(grid, [](double x, double) { return 0.1 * x; }), grid, "map.nc");
  const Outcome run = require("asperity-filter map.nc --make-periodic x -o out.nc");
  // 31 steps of 0.2 µm.
  CHECK_THAT(run.error,
             ContainsSubstring("make-periodic x: the jump at the seam of x is 6.2um rms and 6.2um at "
                               "most, steps inside 200nm rms"));
  const Grid marked = grid_of(read_dataset("out.nc"));
  CHECK((marked.periodic.x && !marked.periodic.y));
  CHECK(same_bits(heights_in("out.nc"), heights_in("map.nc")));
  CHECK_THAT(filtered("--make-periodic both,tilt"), ContainsSubstring("now the jump at the seam of x is "));
  CHECK(heights_in("out.nc").abs().maxCoeff() <= 4e-6);
  CHECK(grid_of(read_dataset("out.nc")).periodic.both());
}

TEST_CASE("what a step cannot take is one line, exit 2 and no output", "[filter][contract]") {
  Field z = rough();
  write_map(z, grid, "map.nc");
  z(1, 1) = NAN;
  write_map(z, grid, "holes.nc");
  const std::pair<const char*, const char*> cases[] = {
      {"map.nc", "asperity-filter: --steps are missing: give one or more"},
      {"map.nc --crop 3:2,0:1", "asperity-filter: --crop: '3:2' is not a range A:B with 0 <= A < B <= 32"},
      {"map.nc --crop 0:33,0:1", "asperity-filter: --crop: '0:33' is not a range"},
      {"map.nc --crop 0:2", "asperity-filter: --crop: '0:2' is not of the form A:B,C:D"},
      {"map.nc --crop x:2,0:1", "asperity-filter: --crop: 'x:2' is not a range A:B of points"},
      {"map.nc --decimate 0x1", "asperity-filter: --decimate: "},
      {"map.nc --decimate 33x1", "asperity-filter: --decimate: '33x1' is more than the map has points"},
      {"map.nc --crop 0:1,: --remove-form sphere",
       "asperity-filter: --remove-form: 'sphere': a profile does not determine it"},
      {"map.nc --remove-form ball", "asperity-filter: --remove-form: 'ball' is not mean, plane"},
      {"map.nc --remove-form 21", "asperity-filter: --remove-form: '21' is not a degree from 0 to 20"},
      {"map.nc --lambda-c 8", "asperity-filter: --lambda-c: '8' has no unit"},
      {"map.nc --lambda-c 8um,best", "asperity-filter: --lambda-c: 'best' is none of gaussian|robust|spline"},
      {"map.nc --lambda-c 1mm", "asperity-filter: --lambda-c: 1mm is longer than the field, 72um"},
      {"map.nc --lambda-c 1um", "asperity-filter: --lambda-c: '1e-06 m' is below two samples along x"},
      {"map.nc --lambda-s 30um --lambda-c 20um",
       "asperity-filter: --lambda-s: 30um is not below --lambda-c 20um"},
      {"map.nc --fill none", "asperity-filter: --fill: 'none' is none of laplace|mean|least"},
      {"map.nc --median 4px", "asperity-filter: --median: '4px' is not an odd number of points"},
      {"map.nc --outliers 0", "asperity-filter: --outliers: '0' does not begin with a number"},
      {"map.nc --scale 0", "asperity-filter: --scale: '0' is not a number besides 0"},
      {"map.nc --rotate 30", "asperity-filter: --rotate: '30' needs a unit"},
      {"map.nc --mirror z", "asperity-filter: --mirror: 'z' is none of x|y|both"},
      {"map.nc --make-periodic x,glue", "asperity-filter: --make-periodic: 'glue' is neither tilt nor"},
      {"map.nc --closing -1um", "asperity-filter: --closing: '-1um' is not a positive length"},
      {"holes.nc --refine 2", "asperity-filter: --refine: the map has missing points: fill them first"},
      {"holes.nc --spacing 4um", "asperity-filter: --spacing: the map has missing points: fill them first"},
  };
  for (const auto& [arguments, expected] : cases) {
    const Outcome run = shell("rm -f no.nc; asperity-filter " + std::string(arguments) +
                              " -o no.nc; code=$?; test ! -e no.nc && exit $code");
    CAPTURE(arguments, run.error);
    CHECK(run.exit == 2);
    CHECK_THAT(run.error, StartsWith(expected));
    CHECK(lines(run.error) == 1);
  }
}

TEST_CASE("a single profile is filtered whatever the width of its other axis", "[filter][exact]") {
  const Field z = Field::NullaryExpr(200, 1, [](Index i, Index) { return 1e-6 * std::sin(0.7 * double(i)); });
  for (const double width : {1e-6, 1e-3}) {
    write_map(z, {{200, 1}, 1e-6, width}, "profile.nc");
    REQUIRE(shell("asperity-filter profile.nc --lambda-c 20um -o f.nc").exit == 0);
    // Spacings come back from coordinates: to n ε of themselves, and so do weights.
    const Field expected = z - gaussian_mean_surface(z, Grid{{200, 1}, 1e-6, 1e-6}, 20e-6);
    CHECK((heights_in("f.nc") - expected).abs().maxCoeff() <= 1e3 * epsilon * 1e-6);
    CHECK(shell("asperity-filter profile.nc --lambda-c 0.5mm -o f.nc").exit == 2);
  }
}

TEST_CASE("values that are no lengths have neither balls nor spheres", "[filter][contract]") {
  write_dataset(dataset_of({.values = rough(), .spacing = {1e-6, 1e-6}, .units = "V"}), "volts.nc");
  for (const std::string step : {"--closing 3um", "--opening 3um", "--remove-form sphere"}) {
    const Outcome run = shell("asperity-filter volts.nc --variable values " + step + " -o no.nc");
    CAPTURE(step, run.error);
    CHECK(run.exit == 4);
    CHECK_THAT(run.error, ContainsSubstring("not a length"));
  }
  CHECK(shell("asperity-filter volts.nc --variable values --remove-form plane -o f.nc").exit == 0);
}
