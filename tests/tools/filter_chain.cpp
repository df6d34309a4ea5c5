// asperity-filter: the order of its steps, what the dataset keeps, and other grids of the same surface.
#include "stats/filter/form.hpp"
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string draw_map =
    "asperity-generate -q --shape 96x64 --size 96um,64um --rq 0.4um --length 6px --seed 7 -o drawn.nc; "
    "asperity-convert drawn.nc --no-history -o drawn.gsf && asperity-convert drawn.gsf -o map.nc;";
const std::string draw_oblong =
    "asperity-generate -q --shape 24x16 --size 3mm,1mm --rq 0.4um --length 4px --seed 7 ";

double form_degree(const std::string& file) { return attributes_in(file).number("filter_form_degree", 0); }

}  // namespace

// A crop of a levelled map is tilted again, by a correlated surface.
TEST_CASE("steps run in the order of the command line, and one may come again", "[filter][law]") {
  require(
      draw_map +
      "asperity-filter -q map.nc --crop 0:20,: --remove-form plane -o first.nc; asperity-filter -q map.nc "
      "--remove-form plane --crop 0:20,: -o last.nc; asperity-filter -q map.nc --remove-form plane --crop "
      "0:20,: --remove-form plane -o both.nc");
  const Field z = field_in("map.nc"), first = field_in("first.nc"), last = field_in("last.nc");
  const auto part = [](const Field& field) -> Field { return field.topRows(20); };
  CHECK(same_bits(first, remove_form(part(z), 1)));
  CHECK(same_bits(last, part(remove_form(z, 1))));
  CHECK(greatest_difference(first, last) > 1e-8);
  CHECK(greatest_difference(first, field_in("both.nc")) <= 1e3 * epsilon * 1e-6);
}

TEST_CASE("a second level changes round-off alone", "[filter][law]") {
  require(draw_map +
          "asperity-filter -q map.nc --remove-form 3 | asperity-filter -q --remove-form 3 -o twice.nc; "
          "asperity-filter -q map.nc --remove-form 3 -o once.nc");
  CHECK_THAT(attributes_in("twice.nc").text("history"),
             ContainsSubstring("remove-form 3: removed nothing but round-off; "));
  CHECK(greatest_difference(field_in("twice.nc"), field_in("once.nc")) <= 1e3 * epsilon * 1e-6);
}

// What is measured is what is written: one code for both. Errors too, for the dataset knows the form's degree.
// Ends of intervals are roots, found to some 1e-8 of themselves.
TEST_CASE("a filtered map measures as the raw one does with the same options, to round-off",
          "[filter][law][slow]") {
  require(draw_map);
  const std::string measure =
      "asperity-stats -q --errors theory --parameters height,material,hybrid,spatial ";
  for (const std::string steps :
       {"--remove-form plane", "--remove-form 3", "--remove-form plane --lambda-s 4um",
        "--remove-form plane --lambda-s 4um --lambda-c 40um", "--lambda-s 4um,spline --lambda-c 40um,robust",
        "--remove-form 2 --lambda-c 30um"}) {
    const Printed raw = printed(measure + steps + " map.nc"),
                  written = printed("asperity-filter -q map.nc " + steps + " | " + measure);
    REQUIRE(written.rows == raw.rows);
    for (const std::string column : {"value", "standard_error", "low_95", "high_95"})
      for (std::size_t k = 0; k < raw.rows.size(); ++k) {
        const double one = raw[column][k], other = written[column][k];
        CAPTURE(steps, column, raw.rows[k], one, other);
        if (raw.rows[k] != "mean")  // that of the form
          CHECK((one == other || std::abs(one - other) <= 1e-7 * std::abs(one) ||
                 (std::isnan(one) && std::isnan(other))));
      }
  }
}

// Errors of a variable that became the map were 14 times too small for the form of the heights, and a form of the
// whole stood for a part of it.
TEST_CASE("what a map has lost stays with it: a form, by its share, and measured points",
          "[filter][contract]") {
  require(draw_map + "asperity-filter -q map.nc --remove-form 6 -o form.nc");
  Dataset data = read_dataset("form.nc");
  set_field(data, "other", random_field({96, 64}, 1), {"V", "other"});
  write_dataset(data, "form.nc");
  for (const auto& [command, degree] : {std::pair{"filter -q form.nc --scale 1", 6},
                                        {"filter -q form.nc --variable other --scale 2", 0},
                                        {"convert -q form.nc --variable other", 0},
                                        {"convert -q form.nc --size 1mm", 6},
                                        {"filter -q form.nc --crop 0:48,0:32", 2},
                                        {"filter -q form.nc --lambda-c 8um", 0}}) {
    CAPTURE(command);
    require(std::string("asperity-") + command + " -o now.nc");
    CHECK(form_degree("now.nc") == degree);
  }
  Field z = field_in("map.nc");
  z.block(3, 4, 8, 12).setConstant(NAN);
  write_map(z, {{96, 64}, 1e-6, 1e-6}, "holes.nc");
  require(
      "asperity-filter -q holes.nc --fill laplace --scale 2 -o filled.nc; asperity-filter -q filled.nc "
      "--scale 2 -o again.nc");
  for (const std::string file : {"filled.nc", "again.nc"}) {
    CHECK(attribute(file, "filter_filled_share") == 1.0 / 64);
    CHECK_THAT(require("asperity-stats --errors theory " + file).error,
               ContainsSubstring("1.6 % of the points were filled; errors take them for measured"));
  }
}

// ---- other grids; the interpolation itself is tested in transform/refinement.cpp ----

TEST_CASE("the option --refine keeps the points of a periodic surface and its period, and may be repeated",
          "[refine][exact]") {
  require(draw_oblong +
          "--periodic -o s.nc; asperity-filter -q s.nc --refine 5x3 -o fine.nc; asperity-filter -q s.nc "
          "--refine 2 "
          "| asperity-filter -q --refine 2 -o twice.nc; asperity-filter -q s.nc --refine 4 -o once.nc");
  const Field z = field_in("s.nc"), fine = field_in("fine.nc");
  const Grid coarse = grid_of(read_dataset("s.nc")), grid = grid_of(read_dataset("fine.nc"));
  CHECK(grid.shape == Shape{120, 48});
  CHECK(grid.periodic.both());
  CHECK(relative_error(grid.dx, coarse.dx / 5) <= 1e-12);
  CHECK(relative_error(grid.dy, coarse.dy / 3) <= 1e-12);
  CHECK(greatest_difference(fine(Eigen::seqN(2, 24, 5), Eigen::seqN(1, 16, 3)), z) <= 100 * epsilon * 1e-6);
  // What lies between is by the same waves, at once or in two steps.
  CHECK(greatest_difference(field_in("twice.nc"), field_in("once.nc")) <= 100 * epsilon * 1e-6);
  CHECK_THAT(attributes_in("once.nc").text("history"), ContainsSubstring("--refine 4"));
}

TEST_CASE("the option --refine keeps the coordinates of a surface that is not periodic", "[refine][exact]") {
  require(draw_oblong + "-o s.nc; asperity-filter -q s.nc --refine 3x5 -o fine.nc");
  const Field z = field_in("s.nc"), fine = field_in("fine.nc");
  const Grid coarse = grid_of(read_dataset("s.nc")), grid = grid_of(read_dataset("fine.nc"));
  CHECK(grid.shape == Shape{72, 80});
  CHECK_FALSE(grid.periodic.any());
  for (Index i = 0; i < 24; ++i) CHECK(std::abs(grid.x(3 * i + 1) - coarse.x(i)) <= 1e-15);
  CHECK(greatest_difference(fine(Eigen::seqN(1, 24, 3), Eigen::seqN(2, 16, 5)), z) <= 100 * epsilon * 1e-6);
}

TEST_CASE(
    "the option --refine drops the results of the former grid and says so, and --refine 1 changes nothing",
    "[refine][contract]") {
  require(draw_oblong + "--periodic --add kernel | asperity-contact -q --load 10N -o c.nc" + steel);
  CHECK_THAT(require("asperity-filter c.nc --refine 2 -o fine.nc").error,
             ContainsSubstring("dropped results of the former map"));
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
  require(draw_oblong +
          "--periodic -o s.nc; asperity-filter -q s.nc --refine 3 | asperity-filter -q --decimate 3x3 -o "
          "back.nc; asperity-filter -q s.nc --decimate 5x1 -o cut.nc");
  CHECK(shape_of(field_in("back.nc")) == shape_of(field_in("s.nc")));
  CHECK(grid_of(read_dataset("back.nc")).periodic.both());
  CHECK(grid_of(read_dataset("cut.nc")).periodic == Periodic(false, true));
}
