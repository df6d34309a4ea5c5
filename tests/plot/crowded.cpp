// Labels of the material ratio curve where its lines lie close together, and names and titles of any length.
#include <cmath>

#include "plot/boxes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const Shape shape{64, 64};

void write_heights(const std::string& name, const Field& heights) {
  Dataset data;
  set_grid(data, {shape, 1e-6, 1e-6});
  set_field(data, "heights", heights, {"m", "height"});
  write_dataset(data, name);
}

// A rough surface with one point far above or below, or of which only tips or pits are left.
std::vector<std::pair<std::string, Field>> crowded() {
  const Field z = random_field(shape, 1);
  Field peak = z, pit = z;
  peak(30, 30) = 500, pit(30, 30) = -500;
  const Field tips = (1.2 * z).exp(), shelf = 0.01 * z + (z - 1.8).max(0), hollows = -shelf;
  return {{"peak", peak},
          {"pit", pit},
          {"tips", tips},
          {"hollows", Field(-tips)},
          {"shelf", shelf},
          {"worn", hollows},
          {"steps", (5 * z).round() / 5},
          {"cut", Field(z.min(0.5))},
          {"filled", z.max(-0.5)}};
}

std::string repeated(const std::string& text, int times) {
  std::string out;
  for (int k = 0; k < times; ++k) out += text;
  return out;
}

}  // namespace

// Of a surface with one outlier Spk, Sk and Svk were written on each other, of a worn one Smr1 and Smr2.
TEST_CASE("the labels of a material ratio curve stand apart however its heights are distributed",
          "[plot][law]") {
  for (const auto& [name, z] : crowded())
    for (const std::string more : {"", " --pixels 500x900", " --pixels 900x400", " --range -3um,3um"}) {
      CAPTURE(name, more);
      write_heights("crowd.nc", 1e-6 * z);
      const Outcome run = shell("asperity-plot crowd.nc --kind abbott -o crowd.svg" + more);
      CAPTURE(run.error);
      REQUIRE(run.exit == 0);
      check_apart("crowd.svg");
      check_inside("crowd.svg");
      const std::string words = words_of("crowd.svg");
      for (const char* label : {"Smr1 = ", "Smr2 = "})
        CHECK((words.find(label) != words.npos || run.error.find(label) != run.error.npos));
      if (more.empty()) CHECK_THAT(words, ContainsSubstring("\nSk\n") && ContainsSubstring("Smr2"));
    }
}

// A title of 300 letters left the sheet on both sides, and so did names.
TEST_CASE("titles and names of any length stay on the sheet, apart from all else", "[plot][law]") {
  write_heights("one.nc", 1e-6 * random_field(shape, 1));
  const std::string words = repeated("ground and then polished ", 12), word = repeated("Wm", 150),
                    wide = repeated("粗さ", 150), lines = repeated("line\\nline ", 30);
  for (const std::string& name : {words, word, wide, lines})
    for (const char* kind : {"map", "profile", "psd", "abbott", "surface", "pdf"}) {
      CAPTURE(kind, name);
      REQUIRE(shell("asperity-plot one.nc -o long.svg --title $'" + name + "' --kind " + kind).exit == 0);
      check_apart("long.svg");
      check_inside("long.svg");
      REQUIRE(shell("asperity-plot one.nc one.nc one.nc -o long.svg --labels $'a" + name + "z,b" + name +
                    ",c" + name + "' --kind " + kind)
                  .exit == 0);
      check_apart("long.svg");
      check_inside("long.svg");
      CHECK_THAT(words_of("long.svg"), ContainsSubstring("…"));
    }
}

// Six names of 40 letters took six lines, half of the height that was given.
TEST_CASE("a legend of long names takes at most three lines", "[plot][law]") {
  write_heights("one.nc", 1e-6 * random_field(shape, 1));
  const std::string name = repeated("specimen ", 5);
  std::string files, labels;
  for (const char* end : {"a", "b", "c", "d", "e", "f"})
    files += "one.nc ", labels += (labels.empty() ? "" : ",") + name + end;
  REQUIRE(shell("asperity-plot " + files + "-o six.svg --kind profile --labels '" + labels + "'").exit == 0);
  std::vector<double> heights;
  for (const Box& box : boxes_of("six.svg"))
    if (box.text.starts_with("sp")) heights.push_back(box.high);
  CHECK(heights.size() == 6);
  std::ranges::sort(heights);
  CHECK(std::unique(heights.begin(), heights.end()) - heights.begin() <= 3);
}

// The long_name of a variable is the label of its axis and of the colour bar.
TEST_CASE("a long name of a quantity keeps its unit and stays on the sheet", "[plot][law]") {
  Dataset data;
  set_grid(data, {shape, 1e-6, 1e-6});
  set_field(data, "signal", random_field(shape, 1),
            {"V", repeated("phase of the lateral force ", 10) + "itself"});
  write_dataset(data, "named.nc");
  for (const char* kind : {"map", "profile", "pdf", "qq", "surface"}) {
    CAPTURE(kind);
    REQUIRE(shell(std::string("asperity-plot named.nc --variable signal -o named.svg --kind ") + kind).exit ==
            0);
    check_apart("named.svg");
    check_inside("named.svg");
    CHECK_THAT(words_of("named.svg"), ContainsSubstring("[V]"));
  }
}
