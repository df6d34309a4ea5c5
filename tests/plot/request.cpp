// What asperity-plot is asked for: where a picture goes, what is refused, and fields that have little to
// show.
#include <cmath>

#include "plot/pictures.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("a picture goes to standard output when it is told its format", "[plot][contract]") {
  CHECK(shell("asperity-plot < " + scene() + " --kind map -o - --to png").out.substr(1, 3) == "PNG");
  CHECK(plot("--kind map -o -").exit == 2);
}

TEST_CASE("a wrong request gets one line and its exit code", "[plot][contract]") {
  const struct {
    const char* arguments;
    int exit;
    const char* word;
  } wrong[] = {{"--kind pie -o w.png", 2, "--kind"},
               {"--kind profile --columns 2 -o w.png", 2, "--columns"},
               {"--kind map --columns 0 -o w.png", 2, "--columns"},
               {"--kind map -o w.eps", 2, "--output"},
               {"--kind map", 2, "--output"},
               {"--kind map --variable depth -o w.png", 4, "depth"},
               {"--kind map --variable von_mises -o w.png", 4, "von_mises"},
               {"--kind map --x-range 5mm,6mm -o w.png", 2, "--x-range"},
               {"--kind map --x-range 6mm,5mm -o w.png", 2, "6mm, is not below the upper bound, 5mm"},
               {"--kind map -o w.png --to svg", 2, "--to: 'svg' contradicts"},
               {"--kind map -o w.png --to gif", 2, "--to: 'gif' is none of png|svg|pdf"},
               {"--kind map -o -", 2, "needs --to png, svg or pdf"},
               {"--kind map --range 1,2 -o w.png", 2, "--range"},
               {"--kind von-mises --section z=0 -o w.png", 2, "--section"},
               {"--kind von-mises --section y=1m -o w.png", 2, "--section"},
               {"--kind von-mises --above 2p0 -o w.png", 2, "--above"},
               {"--kind map --labels a,b -o w.png", 2, "--labels"},
               {"--kind map --title $'\\xff' -o w.png", 2, "--title"},
               {"- - --kind map -o w.png", 2, "plot: INPUT: standard input (-) can be given only once"},
               {"a b c d e f --kind map -o w.png", 2, "plot: INPUT: 7 inputs do not fit in one figure"},
               {"--kind map -o nowhere/w.png", 1, "nowhere"}};
  for (const auto& [arguments, exit, word] : wrong) {
    const Outcome run = plot(arguments);
    CAPTURE(arguments, run.error);
    CHECK(run.exit == exit);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring(word));
    CHECK_FALSE(std::filesystem::exists(scratch("w.png")));
  }
}

TEST_CASE("without gnuplot the tool says what to install and exits with 1", "[plot][contract]") {
  const Outcome run =
      shell("tool=$(command -v asperity-plot); PATH=/nowhere $tool " + scene() + " --kind map -o w.png");
  CHECK(run.exit == 1);
  CHECK(lines(run.error) == 1);
  CHECK_THAT(run.error, ContainsSubstring("gnuplot-nox"));
}

// gnuplot has no empty range of heights.
TEST_CASE("a field of one value is a plane in perspective, with a scale beside it", "[plot][contract]") {
  for (const double value : {0.0, -1.5e-6}) {
    Dataset flat;
    set_grid(flat, {{16, 12}, 1e-6, 1e-6});
    set_field(flat, "heights", Field::Constant(16, 12, value), {"m", "height"});
    write_dataset(flat, "flat.nc");
    const Outcome run = shell("asperity-plot flat.nc --kind surface -o flat.svg");
    CHECK(run.exit == 0);
    CHECK(run.error.empty());
    CHECK_THAT(words_of("flat.svg"), ContainsSubstring("height ["));
  }
}

TEST_CASE("missing points are hatched, which a legend says, and do not spoil the scale", "[plot][contract]") {
  scene();
  Dataset data = read_dataset("scene.nc");
  std::get<std::vector<double>>(data.find("heights")->values)[7] = std::nan("");
  write_dataset(data, "hole.nc");
  for (const std::string kind : {"map", "acf", "pdf", "abbott", "psd", "qq"}) {
    const Outcome run = shell("asperity-plot hole.nc --kind " + kind + " -o hole.svg");
    INFO(kind << run.error);
    REQUIRE(run.exit == 0);
    CHECK_THAT(words_of("hole.svg"), !ContainsSubstring("nan"));
    CHECK((words_of("hole.svg").find("missing") != std::string::npos) == (kind == "map"));
  }
  REQUIRE(plot("--kind map -o whole.svg").exit == 0);
  CHECK_THAT(words_of("whole.svg"), !ContainsSubstring("missing"));
}

// Of the scene's cells a third is open.
TEST_CASE("a distribution of pressure or gap is that of the cells that have one, beside no Gaussian",
          "[plot][contract]") {
  scene();
  Dataset data = read_dataset("scene.nc");
  set_field(data, "gap", Field::Constant(24, 20, 1e-6), {"m", "gap"});
  write_dataset(data, "gap.nc");
  for (const auto& [variable, words] :
       {std::pair{"pressure", "480 of 480 cells, in contact"}, {"gap", "160 of 480 cells, open"}}) {
    const Outcome run =
        shell(std::string("asperity-plot gap.nc --kind pdf -o part.svg --variable ") + variable);
    INFO(run.error);
    REQUIRE(run.exit == 0);
    CHECK_THAT(words_of("part.svg"), ContainsSubstring(words) && !ContainsSubstring("Gaussian"));
  }
}
