// Figures of surfaces of one row or one point.
#include <cmath>
#include <cstdint>
#include <limits>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"
#include "tools/plot/gnuplot.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Heights, and stresses at three depths.
void write_scene(Shape shape) {
  const Grid grid{shape, 1e-6, 1e-6};
  Dataset data;
  set_grid(data, grid);
  set_field(data, "heights", 1e-7 * random_field(shape, 1), {"m", "height"});
  set_depths(data, {0, 1e-6, 3e-6});
  set_volume(data, "von_mises", std::vector<double>(static_cast<std::size_t>(3 * shape.cells()), 1e6),
             {"Pa", "von Mises stress"});
  write_dataset(data, "row.nc");
}

}  // namespace

// Profiles along both sides were drawn or none, and a section stood at y = 0 whatever the surface.
TEST_CASE("a row of points is drawn along the row, whichever way it runs", "[plot][contract]") {
  for (const Shape shape : {Shape{1, 60}, Shape{60, 1}}) {
    write_scene(shape);
    const std::string along = shape.nx > 1 ? "x" : "y", across = shape.nx > 1 ? "y" : "x";
    for (const char* kind : {"profile", "section", "von-mises"}) {
      const Outcome run =
          shell(std::string("asperity-plot row.nc -o a.svg --kind ") + kind + " && cat a.svg");
      CAPTURE(shape.nx, kind, run.error);
      CHECK(run.exit == 0);
      CHECK(run.out.find("<text>" + along + " [") != run.out.npos);
      CHECK(run.out.find("<text>" + across + " [") == run.out.npos);
    }
    for (const char* kind : {"profile", "section"}) {
      const Outcome no =
          shell("asperity-plot row.nc -o a.svg --section " + along + "=0 --kind " + std::string(kind));
      CAPTURE(shape.nx, kind, no.error);
      CHECK((no.exit == 4 && lines(no.error) == 1));
      CHECK(no.error.find("needs at least two points, found 1") != no.error.npos);
    }
  }
}

// Colours in one line of cells, stretched to a band, said little; gnuplot leaves such an image out besides.
TEST_CASE("a map of a row or a column is drawn as its profile, one of a point or of two rows as a map",
          "[plot][law]") {
  for (const Shape shape : {Shape{1, 60}, Shape{60, 1}, Shape{2, 1}, Shape{1, 1}, Shape{2, 60}}) {
    write_scene(shape);
    const Outcome run = shell("asperity-plot row.nc -o a.svg --kind map && cat a.svg");
    CAPTURE(shape.nx, shape.ny, run.error);
    CHECK((run.exit == 0 && run.error.empty()));
    const bool row = std::min(shape.nx, shape.ny) == 1 && shape.cells() > 1;
    CHECK((run.out.find("<image") == run.out.npos) == row);
    CHECK((run.out.find("<text>height [") != run.out.npos));
  }
  const plot::Layer row = plot::raster(Field::Constant(1, 2, 3.0), {1, 10, 4, 2}, "with image");
  CHECK(row.command.find("array=(2,2)") != row.command.npos);
  CHECK(row.command.find("origin=(0,10) dx=2 dy=2") != row.command.npos);
  CHECK(row.numbers == std::vector<double>(4, 3.0));
}

// Thinned like the longer side, two rows became one, of which nothing is drawn.
TEST_CASE("a surface of two long rows is drawn in perspective, and one of a row refused",
          "[plot][contract]") {
  write_scene({2, 600});
  const Outcome run = shell("asperity-plot row.nc -o a.svg --kind surface && cat a.svg");
  CHECK(run.exit == 0);
  std::size_t polygons = 0;
  for (auto at = run.out.find("<polygon"); at != run.out.npos; at = run.out.find("<polygon", at + 1))
    ++polygons;
  CHECK(polygons >= 100);
  for (const Shape shape : {Shape{1, 60}, Shape{60, 1}, Shape{1, 1}}) {
    write_scene(shape);
    const Outcome no = shell("asperity-plot row.nc -o a.svg --kind surface");
    CHECK((no.exit == 4 && lines(no.error) == 1));
    CHECK(no.error.find("heights: a perspective view needs at least 2 x 2 points") != no.error.npos);
  }
}

TEST_CASE("of a single point maps are drawn, and profiles and sections refused by name", "[plot][contract]") {
  write_scene({1, 1});
  CHECK(shell("asperity-plot row.nc --kind map -o a.svg").exit == 0);
  for (const char* kind : {"profile", "section"}) {
    const Outcome no = shell(std::string("asperity-plot row.nc -o a.svg --kind ") + kind);
    CAPTURE(no.error);
    CHECK((no.exit == 4 && lines(no.error) == 1));
    CHECK(no.error.find("needs at least two points, found 1") != no.error.npos);
  }
}

// Where no two points are neighbours, axes without a curve were drawn.
TEST_CASE("a picture in which nothing would be drawn is refused, with what to do", "[plot][contract]") {
  const Shape shape{32, 32};
  const double missing = std::numeric_limits<double>::quiet_NaN();
  const Field whole = 1e-6 * random_field(shape, 1);
  auto refused = [&](const Field& heights, const std::string& kind, const std::string& words) {
    Dataset data;
    set_grid(data, {shape, 1e-6, 1e-6});
    set_field(data, "heights", heights.isFinite().select(heights, 0), {"m", "height"});
    std::vector<std::int8_t> mask;
    for (const double z : heights.reshaped<Eigen::RowMajor>()) mask.push_back(std::isnan(z) ? 1 : 0);
    set_flags(data, "mask", mask, "missing points", "measured missing");
    write_dataset(data, "holes.nc");
    const Outcome run = shell("asperity-plot holes.nc -o a.svg --kind " + kind);
    CAPTURE(kind, run.error);
    CHECK((run.exit == 4 && lines(run.error) == 1));
    CHECK(run.error.find(words) != run.error.npos);
  };
  Field row = Field::Constant(32, 32, missing), two = row, cut = whole;
  row.col(7) = whole.col(7);
  two(5, 7) = 1e-6, two(20, 9) = 2e-6;
  cut.middleCols(15, 2) = missing;
  refused(row, "surface", "heights: a perspective view needs four neighbouring points");
  refused(two, "surface", "draw a map");
  refused(cut, "profile", "no two neighbouring points are there at y =");
  refused(two, "acf", "known at no two neighbouring lags");
  CHECK(shell("asperity-plot holes.nc -o a.svg --kind map").exit == 0);
}
