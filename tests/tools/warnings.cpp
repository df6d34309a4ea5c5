// What a tool warns of goes with its result: in the dataset, and in JSON.
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string two_bodies = " --radius 50mm" + steel;

}  // namespace

// Of exponential heights, whose slopes no grid resolves, at a limit pressure that yields below.
TEST_CASE("what a tool warns of stands in its dataset, goes on with it, and goes with the result",
          "[warnings][contract]") {
  const std::string unresolved = "the grid does not resolve the surface", yields = "von Mises stress reaches",
                    layers = " --depths 0:60um:3 ";
  require(rough + " --seed 3 -o w.nc");
  require("asperity-contact w.nc --load 50N --yield 300MPa" + two_bodies + "-o pressed.nc");
  CHECK(attributes_in("pressed.nc").text("contact_warnings").starts_with(unresolved));

  require("asperity-stress pressed.nc" + layers + "-o in_file.nc && asperity-stress pressed.nc" + layers +
          "| cat > piped.nc && asperity-stress pressed.nc --maximum -o maximum.nc");
  for (const char* name : {"in_file.nc", "piped.nc", "maximum.nc"}) {
    const Attributes a = attributes_in(name);
    CAPTURE(name, a.text("stress_warnings"));
    CHECK(a.text("contact_warnings").starts_with(unresolved));
    CHECK(a.text("stress_warnings").find(yields) != std::string::npos);
    CHECK(a.text("stress_warnings").find(unresolved) == std::string::npos);
  }
  CHECK(values_in("in_file.nc", "von_mises") == values_in("piped.nc", "von_mises"));

  require("asperity-stress in_file.nc -o twice.nc" + layers);
  CHECK(attributes_in("twice.nc").text("stress_warnings") ==
        attributes_in("in_file.nc").text("stress_warnings"));
  require("asperity-contact in_file.nc --load 1N" + two_bodies + "-o again.nc");
  CHECK(attributes_in("again.nc").text("stress_warnings").empty());
}

// Each surface has its own, whether they are worked on at once or one after the other; JSON has all.
TEST_CASE("a warning about one of several surfaces stands in its dataset alone",
          "[warnings][several][contract]") {
  require(rough + " --seed 3 -o of_0.nc && " + rough + " --model gaussian --seed 3 -o of_1.nc");
  for (const char* threads : {"1", "2"}) {
    const std::string line = "asperity-contact of_?.nc --load 50N" + two_bodies + "--threads " + threads;
    require(line + " --each each_%d.nc -o rows.tsv");
    CHECK(attributes_in("each_1.nc").text("contact_warnings").starts_with("the grid does not resolve"));
    CHECK(attributes_in("each_2.nc").text("contact_warnings").empty());
    const std::string json = require(line + " --json").out;
    CHECK(json.find("\"warnings\": [\n    \"of_0.nc: the grid does not resolve") != std::string::npos);
  }
  CHECK(require("asperity-contact of_1.nc --sweep 50N,60N --json" + two_bodies).out.find("warnings") ==
        std::string::npos);
}

// Of an attribute that does not fit its points, which the frame warns of as it reads: the first surface on
// another thread than the one that presses it.
TEST_CASE("what is warned of as surfaces are read stands in the dataset of each, and all in that of the mean",
          "[warnings][several][contract]") {
  require(rough + " --model gaussian --seed 3 --count 3 -o read_%d.nc");
  for (const char* name : {"read_0.nc", "read_1.nc"}) {
    Dataset data = read_dataset(name);
    data.find("x")->attributes.set("length", 4e-2);
    write_dataset(data, name);
  }
  for (const char* threads : {"1", "2"}) {
    require("asperity-contact read_?.nc --load 50N" + two_bodies + "--each own_%d.nc -o rows.tsv --threads " +
            threads);
    for (const char* of : {"1", "2"})
      CHECK(attributes_in("own_" + std::string(of) + ".nc").text("contact_warnings").find("0.04 replaced") !=
            std::string::npos);
    CHECK(attributes_in("own_3.nc").text("contact_warnings").empty());
    require("asperity-acf read_?.nc -o mean.nc --threads " + std::string(threads));
    const std::string of_mean = attributes_in("mean.nc").text("acf_warnings");
    CHECK(of_mean.starts_with("read_0.nc: x: attribute length 0.04 replaced"));
  }
}

// Of 1 N and 2 N alone the contact has few cells. The count of later loads comes before the table.
TEST_CASE("a warning about a load of a sweep stands in the dataset of this load", "[warnings][contract]") {
  require(rough + " --model gaussian --seed 3 -o swept.nc");
  const std::string sweep = "asperity-contact swept.nc --sweep 1N,2N,800N" + two_bodies;
  require(sweep + " --each load_%d.nc -o rows.tsv");
  for (const char* file : {"load_1.nc", "load_2.nc", "load_3.nc"}) {
    const std::string warned = attributes_in(file).text("contact_warnings");
    CAPTURE(file, warned);
    CHECK((warned.find("fewer than 50") == warned.npos) == (file == std::string("load_3.nc")));
    CHECK(warned.find("N: ") == warned.npos);
  }
  CHECK(require(sweep + " --json").out.find("under 1 more load, up to 2N") != std::string::npos);
}
