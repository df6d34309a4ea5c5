// asperity-filter --refine, as it is typed; the interpolation itself is tested in transform/refinement.cpp.
#include "dataset/layout.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string draw =
    "asperity-generate -q --shape 24x16 --size 3mm,1mm --rq 0.4um --length 4px --seed 7 ";

Field heights_in(const std::string& name) { return field_of(read_dataset(name), "heights"); }

}  // namespace

TEST_CASE("the option --refine keeps the points of a periodic surface and its period, and may be repeated",
          "[refine][exact]") {
  require(draw + "--periodic -o s.nc; asperity-filter -q s.nc --refine 5x3 -o fine.nc");
  const Field z = heights_in("s.nc"), fine = heights_in("fine.nc");
  const Grid coarse = grid_of(read_dataset("s.nc")), grid = grid_of(read_dataset("fine.nc"));
  CHECK(grid.shape == Shape{120, 48});
  CHECK(grid.periodic.both());
  CHECK(relative_error(grid.dx, coarse.dx / 5) <= 1e-12);
  CHECK(relative_error(grid.dy, coarse.dy / 3) <= 1e-12);
  for (Index i = 0; i < 24; ++i)
    for (Index j = 0; j < 16; ++j)
      CHECK(std::abs(fine(5 * i + 2, 3 * j + 1) - z(i, j)) <= 100 * epsilon * 1e-6);
  // What lies between is by the same waves, at once or in two steps.
  require(
      "asperity-filter -q s.nc --refine 2 | asperity-filter -q --refine 2 -o twice.nc; "
      "asperity-filter -q s.nc --refine 4 -o once.nc");
  CHECK((heights_in("twice.nc") - heights_in("once.nc")).abs().maxCoeff() <= 100 * epsilon * 1e-6);
  CHECK_THAT(read_dataset("once.nc").attributes.text("history"), ContainsSubstring("--refine 4"));
}

TEST_CASE("the option --refine keeps the coordinates of a surface that is not periodic", "[refine][exact]") {
  require(draw + "-o s.nc; asperity-filter -q s.nc --refine 3x5 -o fine.nc");
  const Field z = heights_in("s.nc"), fine = heights_in("fine.nc");
  const Grid coarse = grid_of(read_dataset("s.nc")), grid = grid_of(read_dataset("fine.nc"));
  CHECK(grid.shape == Shape{72, 80});
  CHECK_FALSE(grid.periodic.any());
  for (Index i = 0; i < 24; ++i) CHECK(std::abs(grid.x(3 * i + 1) - coarse.x(i)) <= 1e-15);
  for (Index i = 0; i < 24; ++i)
    for (Index j = 0; j < 16; ++j)
      CHECK(std::abs(fine(3 * i + 1, 5 * j + 2) - z(i, j)) <= 100 * epsilon * 1e-6);
}

TEST_CASE(
    "the option --refine drops the results of the former grid and says so, and --refine 1 changes nothing",
    "[refine][contract]") {
  require(draw +
          "--periodic --add kernel | asperity-contact -q --young 200GPa --poisson 0.3 --load 10N -o c.nc");
  const Outcome run = require("asperity-filter c.nc --refine 2 -o fine.nc");
  CHECK_THAT(run.error, ContainsSubstring("dropped results of the former map"));
  const Dataset fine = read_dataset("fine.nc");
  for (const char* gone : {"pressure", "gap", "kernel", "acf_target"}) CHECK_FALSE(fine.has(gone));
  CHECK(fine.attributes.find("contact_load") == nullptr);
  CHECK(require("asperity-filter c.nc --refine 1 -o same.nc").error.empty());
  CHECK(read_dataset("same.nc").has("pressure"));
  // The order is crop, then refine; a part of a period is not periodic.
  require("asperity-filter -q c.nc --crop 0:5,0:1 --refine 2 -o part.nc");
  CHECK(grid_of(read_dataset("part.nc")).shape == Shape{10, 2});
}

TEST_CASE("a period that is thinned without a rest remains one", "[refine][contract]") {
  require(draw +
          "--periodic -o s.nc; asperity-filter -q s.nc --refine 3 | asperity-filter -q --decimate 3x3 -o "
          "back.nc; asperity-filter -q s.nc --decimate 5x1 -o cut.nc");
  CHECK(shape_of(heights_in("back.nc")) == shape_of(heights_in("s.nc")));
  CHECK(grid_of(read_dataset("back.nc")).periodic.both());
  CHECK(grid_of(read_dataset("cut.nc")).periodic == Periodic(false, true));
}

TEST_CASE("what --refine cannot do is one line and exit 2", "[refine][contract]") {
  require(draw +
          "-o s.nc; printf '0 1 2\\n3 nan 5\\n6 7 8\\n' > holes.txt; asperity-convert -q holes.txt --size "
          "1mm -o holes.nc");
  for (const auto& [options, words] :
       {std::pair("s.nc --refine 0", "--refine"),
        {"s.nc --refine -2", "--refine"},
        {"s.nc --refine 2.5", "--refine"},
        {"s.nc --refine 2x", "--refine"},
        {"s.nc --refine x", "--refine"},
        {"s.nc --refine 5000", "--refine"},
        {"s.nc --refine 2x2x2", "--refine"},
        {"s.nc --refine 64 --memory 20MB", "a map of 1536x1024 points needs"},
        {"holes.nc --refine 2", "--refine: the map has missing points: fill them first"}}) {
    const Outcome run = shell("asperity-filter -o absent.nc " + std::string(options));
    CAPTURE(options, run.error);
    CHECK(run.exit == 2);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring(words));
  }
  CHECK(shell("ls absent.nc").exit != 0);
}
