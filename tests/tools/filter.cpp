// asperity-filter: what each step does and tells. The operators themselves are tested in tests/stats.
#include <numbers>
#include <utility>

#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

// Heights of some µm on 32 × 24 points of 2 µm × 3 µm.
const Grid map_grid{{32, 24}, 2e-6, 3e-6};

Field noise_map() { return 1e-6 * random_field(map_grid.shape, 5); }

// The first entry of the history, its steps a line each.
std::string last_run(const std::string& name) {
  const std::string all = attributes_in(name).text("history");
  std::size_t end = all.find('\n');
  while (end != all.npos && all.compare(end + 1, 1, " ") == 0) end = all.find('\n', end + 1);
  return all.substr(0, end);
}

std::string filtered(const std::string& steps, const std::string& name = "out.nc") {
  require("asperity-filter -q map.nc " + steps + " -o " + name);
  return last_run(name);
}

}  // namespace

// A plane a + bx + cy has the rms √(b² var x + c² var y) about its mean, where var of n points a step apart is
// (n² - 1)/12: √(0.2² · 85.25 + 0.06² · 47.92) µm. A checkerboard of ±0.1 µm has no plane.
TEST_CASE("history tells the rms and the mean of a form that was removed, and what is left",
          "[filter][exact]") {
  const Field plane = sample(map_grid, [](double x, double y) { return 4e-6 + 0.1 * x - 0.02 * y; });
  const Field checks = Field::NullaryExpr(map_grid.shape.nx, map_grid.shape.ny, [](Index i, Index j) {
    return (i / 2 + j / 2) % 2 == 0 ? 1e-7 : -1e-7;
  });
  write_map(plane + checks, map_grid, "map.nc");
  CHECK_THAT(
      filtered("--remove-form plane"),
      EndsWith("\n  1. remove-form plane: removed 1.893um rms about a mean of 4um; 100nm rms is left"));
  CHECK(same_bits(field_in("out.nc"), remove_form(field_in("map.nc"), 1)));
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
  CHECK(field_in("out.nc").abs().maxCoeff() <= 2e-9);
  CHECK(read_dataset("out.nc").attributes.number("filter_form_degree", 0) == 2);
  const Field across =
      sample(square, [&](double x, double y) { return -cap(y * std::cos(turn) - x * std::sin(turn)); });
  write_map(ripples + across, square, "map.nc");
  CHECK_THAT(filtered("--remove-form cylinder"),
             ContainsSubstring("1. remove-form cylinder: a bowl of radius 5mm, axis at 30deg; removed "));
  CHECK(field_in("out.nc").abs().maxCoeff() <= 2e-9);
  // The same surface by asperity-stats.
  const auto sq = [](const std::string& line) { return shell(line + " --json | jq .Sq.value").out; };
  CHECK(std::stod(sq("asperity-stats -q map.nc --errors none --remove-form cylinder")) ==
        Catch::Detail::Approx(std::stod(sq("asperity-stats -q out.nc --errors none"))).epsilon(1e-9));
}

TEST_CASE("the steps of waves are the library's filters, and keep the waves on their side",
          "[filter][exact]") {
  write_map(noise_map(), map_grid, "map.nc");
  const Field z = field_in("map.nc"),
              long_waves = gaussian_mean_surface(z, grid_of(read_dataset("map.nc")), 20e-6);
  CHECK_THAT(filtered("--lambda-s 20um"), ContainsSubstring("\n  1. lambda-s 20um: removed "));
  // Heights of some µm; transforms in another program may add in another order.
  const double round_off = 100 * epsilon * 4e-6;
  CHECK((field_in("out.nc") - long_waves).abs().maxCoeff() <= round_off);
  filtered("--lambda-c 20um");
  CHECK((field_in("out.nc") - (z - long_waves)).abs().maxCoeff() <= round_off);
  filtered("--lambda-c 20um,gaussian", "same.nc");
  CHECK(same_bits(field_in("out.nc"), field_in("same.nc")));
}

TEST_CASE("a map is cut, then thinned, with the spacing that follows", "[filter][exact]") {
  write_map(noise_map(), map_grid, "map.nc");
  CHECK_THAT(filtered("--crop 1:6,:3 --decimate 2x1"),
             ContainsSubstring("\n  1. crop 1:6,:3: now 5x3 cells on 10um x 9um") &&
                 ContainsSubstring("\n  2. decimate 2x1: now 3x3 cells on 12um x 9um"));
  const Field z = field_in("map.nc");
  CHECK(same_bits(field_in("out.nc"), z(Eigen::seqN(1, 3, 2), Eigen::seqN(0, 3))));
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
    return field_in("out.nc")(3, 1) / 1e-6;
  };
  CHECK(std::abs(value("laplace") - 31) <= 1e-12);
  CHECK(std::abs(value("mean") - (24 * 26.5 - 31) / 23) <= 1e-12);
  CHECK(value("least") == 0);
}

TEST_CASE("decimation by one number thins both axes", "[filter][exact]") {
  write_map(noise_map(), map_grid, "map.nc");
  filtered("--decimate 3", "one.nc");
  filtered("--decimate 3x3", "two.nc");
  CHECK(same_bits(field_in("one.nc"), field_in("two.nc")));
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
  Field z = noise_map();
  for (const auto& [i, j] : {std::pair<Index, Index>{4, 5}, {20, 11}, {0, 13}}) z(i, j) = 1e-3;
  write_map(z, map_grid, "map.nc");
  const std::string told =
      "outliers 20: 3 of 768 points (0.39 %) made missing: they stand out from all sides by more than 20 "
      "standard deviations of the surface there (";
  CHECK_THAT(filtered("--outliers 20"), ContainsSubstring(told));
  z = (z == 1e-3).select(NAN, z);
  CHECK(same_bits(field_in("out.nc"), z));
  CHECK_THAT(filtered("--outliers 20,7px --fill laplace"),
             ContainsSubstring("2. fill laplace: filled 3 of 768"));
  CHECK_FALSE(field_in("out.nc").hasNaN());
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
  CHECK(same_bits(field_in("out.nc"), field_in("map.nc")));
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
  Field z = noise_map();
  z(3, 4) = NAN;
  write_map(z, map_grid, "map.nc");
  const Field before = field_in("map.nc");
  for (const char* steps :
       {"--rotate 90deg --rotate 90deg --rotate 180deg", "--mirror both --mirror x --mirror y",
        "--scale -1 --scale -1", "--scale 4 --scale 0.25"}) {
    CAPTURE(steps);
    filtered(steps);
    CHECK(same_bits(field_in("out.nc"), before));
  }
  CHECK_THAT(filtered("--mirror x"), ContainsSubstring("mirror x: x reversed"));
  CHECK(same_bits(field_in("out.nc"), before.colwise().reverse()));
  filtered("--scale -2");
  CHECK(same_bits(field_in("out.nc"), -2 * before));
}

// Steps of the ball's opening and closing lie on either side of the heights.
TEST_CASE("a closing raises, an opening lowers, and the history tells how many points moved",
          "[filter][law]") {
  write_map(noise_map(), map_grid, "map.nc");
  const Field z = field_in("map.nc");
  CHECK_THAT(filtered("--closing 50um"), ContainsSubstring("closing 50um: moved "));
  CHECK((field_in("out.nc") >= z - 1e-18).all());
  filtered("--opening 50um");
  CHECK((field_in("out.nc") <= z + 1e-18).all());
  filtered("--closing 50um --scale -1 --opening 50um --scale -1", "turned.nc");
  filtered("--closing 50um", "once.nc");
  CHECK((field_in("turned.nc") - field_in("once.nc")).abs().maxCoeff() <= 1e-18 + 50e-6 * 4 * epsilon);
}

TEST_CASE("an axis that is made periodic is marked, and the jump at its seam is told", "[filter][exact]") {
  write_map(sample(map_grid, [](double x, double) { return 0.1 * x; }), map_grid, "map.nc");
  const Outcome run = require("asperity-filter map.nc --make-periodic x -o out.nc");
  // 31 steps of 0.2 µm.
  CHECK_THAT(run.error,
             ContainsSubstring("make-periodic x: the jump at the seam of x is 6.2um rms and 6.2um at "
                               "most, steps inside 200nm rms"));
  const Grid marked = grid_of(read_dataset("out.nc"));
  CHECK((marked.periodic.x && !marked.periodic.y));
  CHECK(same_bits(field_in("out.nc"), field_in("map.nc")));
  CHECK_THAT(filtered("--make-periodic both,tilt"), ContainsSubstring("now the jump at the seam of x is "));
  CHECK(field_in("out.nc").abs().maxCoeff() <= 4e-6);
  CHECK(grid_of(read_dataset("out.nc")).periodic.both());
}

TEST_CASE("a single profile is filtered whatever the width of its other axis", "[filter][exact]") {
  const Field z = Field::NullaryExpr(200, 1, [](Index i, Index) { return 1e-6 * std::sin(0.7 * double(i)); });
  for (const double width : {1e-6, 1e-3}) {
    write_map(z, {{200, 1}, 1e-6, width}, "profile.nc");
    REQUIRE(shell("asperity-filter profile.nc --lambda-c 20um -o f.nc").exit == 0);
    // Spacings come back from coordinates: to n ε of themselves, and so do weights.
    const Field expected = z - gaussian_mean_surface(z, Grid{{200, 1}, 1e-6, 1e-6}, 20e-6);
    CHECK((field_in("f.nc") - expected).abs().maxCoeff() <= 1e3 * epsilon * 1e-6);
    CHECK(shell("asperity-filter profile.nc --lambda-c 0.5mm -o f.nc").exit == 2);
  }
}
