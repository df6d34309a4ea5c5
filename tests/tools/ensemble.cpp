// Surfaces of an ensemble must have grids over which a mean says something.
#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

std::string draw(const std::string& shape, const std::string& size, const std::string& name) {
  return "asperity-generate -q --add kernel --rq 0.4um --length 50um --seed 7 --shape " + shape + " --size " +
         size + " -o " + name + " && ";
}

}  // namespace

// Maps of 10 and 20 um spacing were averaged without a word: Sdq differs by the spacing alone.
TEST_CASE(
    "what depends on the spacing has no mean over different ones: refused, with the file and both grids",
    "[ensemble][contract]") {
  const std::string both = draw("32x32", "640um", "coarse.nc") + draw("32x32", "320um", "fine.nc");
  for (const std::string tool :
       {"asperity-stats --parameters hybrid", "asperity-stats --compare", "asperity-stats --profile x",
        "asperity-validate", "asperity-acf --max-lag 4x4"}) {
    const Outcome run = shell(both + tool + " coarse.nc fine.nc");
    CAPTURE(tool, run.error);
    CHECK(run.exit == 4);
    CHECK_THAT(run.error,
               ContainsSubstring("fine.nc: its grid, 32x32 cells on 320um x 320um, differs from that "
                                 "of coarse.nc, 32x32 cells on 640um x 640um"));
    CHECK(run.out.empty());
  }
}

TEST_CASE("surfaces of different sizes are averaged with one warning, and not tested together",
          "[ensemble][contract]") {
  const std::string all = draw("32x32", "640um", "a.nc") + draw("32x24", "640um,480um", "b.nc") +
                          draw("16x24", "320um,480um", "c.nc");
  const Outcome run = shell(all + "asperity-stats -q a.nc b.nc c.nc");
  CHECK(run.exit == 0);
  CHECK(lines(run.error) == 1);
  CHECK_THAT(run.error, ContainsSubstring("asperity-stats: warning: b.nc: its grid, 32x24 cells"));
  CHECK(shell("asperity-validate a.nc b.nc").exit == 4);
}

TEST_CASE("surfaces of one grid, or of one but for six digits, are averaged without a word",
          "[ensemble][contract]") {
  const Outcome run = shell(draw("32x32", "640um", "a.nc") + draw("32x32", "640.0001um", "b.nc") +
                            "asperity-stats -q a.nc b.nc");
  CHECK(run.exit == 0);
  CHECK(run.error.empty());
}

// As after ds.isel(x=slice(0, 16)) of xarray, which keeps the attribute: twice the spacing, half the slopes.
TEST_CASE("a length that is not that of the points is not taken, which every tool says and mends",
          "[ensemble][contract]") {
  REQUIRE(shell(draw("32x24", "640um,480um", "whole.nc") + "true").exit == 0);
  Dataset data = read_dataset("whole.nc");
  data.find("x")->attributes.set("length", 1.28e-3);
  write_dataset(data, "stale.nc");
  const std::string warning =
      "warning: stale.nc: x: attribute length 0.00128 replaced by that of its 32 points, 0.00064";
  const Outcome told = shell("asperity-stats -q stale.nc");
  CHECK_THAT(told.error, ContainsSubstring(warning));
  CHECK(told.out == shell("asperity-stats whole.nc").out);
  for (const std::string tool :
       {"asperity-acf stale.nc", "asperity-convert stale.nc", "asperity-filter stale.nc --scale 1",
        "asperity-generate --kernel stale.nc --seed 1"}) {
    const Outcome run = shell(tool + " > mended.nc");
    CAPTURE(tool, run.error);
    CHECK(run.exit == 0);
    CHECK_THAT(run.error, ContainsSubstring("attribute length 0.00128 replaced by that of its 32 points"));
    CHECK(std::abs(read_dataset("mended.nc").at("x").attributes.number("length", 0) / 640e-6 - 1) <= 1e-12);
    CHECK(shell("asperity-stats mended.nc").error.empty());
  }
}

// 500 surfaces had 500 warnings that differ in a number.
TEST_CASE("an ensemble of one has its number in the name of its file", "[ensemble][contract]") {
  require(
      "asperity-generate --shape 8x8 --size 1mm --rq 1um --length 2px --seed 1 --count 1 -o alone_%02d.nc");
  CHECK(shell("ls alone_*").out == shell("ls alone_0[01].nc").out);
}

// asperity-pdf reads each surface twice.
TEST_CASE("of warnings that differ in numbers alone the first is printed, one more too, further ones counted",
          "[ensemble][contract]") {
  require(
      "for k in 1 2 3; do asperity-generate -q --shape 48x48 --size 1mm --rq 0.4um --length 3px --seed $k | "
      "asperity-filter -q --outliers 2.$k --fill laplace -o filled_$k.nc; done");
  const auto warnings = [](const std::string& names) {
    std::string out = shell("asperity-pdf -q " + names).error;
    for (std::size_t at = 0; (at = out.find_first_of("0123456789.", at)) != out.npos;)
      out.erase(at, 1);  // names and shares have such
    return out;
  };
  const std::string filled =
                        "% of the points were filled; errors take them for measured, and are too small\n",
                    first = "asperity-pdf: warning: filled_nc:  " + filled;
  CHECK(warnings("filled_1.nc filled_2.nc") == first + first);
  CHECK(warnings("filled_1.nc filled_2.nc filled_3.nc") ==
        first + "asperity-pdf: warning:  more surfaces, up to filled_nc:  " + filled);
}
