// Runs asperity-plot as a user does and looks at what it wrote.
#include <cstdio>

#include "plot/pictures.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr const char* kinds[] = {"map",       "surface", "profile", "acf", "pdf",   "contact",
                                 "von-mises", "abbott",  "psd",     "qq",  "maxima", "features"};

unsigned big_endian(const std::string& bytes, std::size_t at) {
  unsigned out = 0;
  for (std::size_t k = 0; k < 4; ++k) out = out << 8 | static_cast<unsigned char>(bytes.at(at + k));
  return out;
}

// A PDF's width [pt], cairo's without the fraction; its height is above 50.
double width_of_pdf(const std::string& name) {
  const std::string pdf = bytes_of(name);
  double width = 0, height = 0;
  REQUIRE(std::sscanf(pdf.c_str() + pdf.find("/MediaBox ["), "/MediaBox [ 0 0 %lf %lf", &width, &height) ==
          2);
  CHECK(height > 50);
  return width;
}

std::size_t occurrences(const std::string& text, const std::string& of) {
  std::size_t count = 0;
  for (auto at = text.find(of); at != text.npos; at = text.find(of, at + 1)) ++count;
  return count;
}

void check_texts_inside(const std::string& name) {
  const std::string svg = bytes_of(name);
  int width = 0, height = 0, texts = 0;
  REQUIRE(std::sscanf(svg.c_str() + svg.find("viewBox="), "viewBox=\"0 0 %d %d", &width, &height) == 2);
  const std::string place = "<g transform=\"translate(";
  for (auto at = svg.find(place); at != svg.npos; at = svg.find(place, at + 1)) {
    double x = 0, y = 0;  // of the base line
    REQUIRE(std::sscanf(svg.c_str() + at + place.size(), "%lf,%lf", &x, &y) == 2);
    CAPTURE(x, y, width, height);
    CHECK((0 <= x && x <= width));
    CHECK((0 <= y && y <= height - 0.005 * width));  // room for what hangs below the line
    ++texts;
  }
  CHECK(texts >= 4);
}

}  // namespace

TEST_CASE("every kind draws a PNG of the size asked for, and says nothing", "[plot][contract]") {
  for (const std::string kind : kinds) {
    CAPTURE(kind);
    const Outcome run = plot("--kind " + kind + " --pixels 640x500 -o a.png");
    CHECK(run.exit == 0);
    CHECK(run.error + run.out == "");
    const std::string png = bytes_of("a.png");
    REQUIRE(png.size() > 24);
    CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    CHECK(big_endian(png, 16) == 640);
    CHECK(big_endian(png, 20) == 500);
    CHECK(png.substr(png.size() - 8, 4) == "IEND");
  }
}

TEST_CASE("every kind draws an SVG whose axes carry their units", "[plot][contract]") {
  const char* words[][2] = {{"height [nm]", "x [µm]"},
                            {"height [nm]", "y [µm]"},
                            {"height [nm]", "x [µm] at y"},
                            {"lag [µm]", "autocorrelation"},
                            {"density [1/µm]", "Gaussian"},
                            {"elastic", "at the limit"},
                            {"depth z [µm]", "von Mises [GPa]"},
                            {"height above the mean [nm]", "material ratio [%]"},
                            {"wave number [rad/mm]", "PSD of profiles [µm³]"},
                            {"height above the mean [nm]", "normal quantile"},
                            {"depth z [µm]", "largest von Mises [GPa]"},
                            {"height [nm]", "45 hills, Spd"}};
  for (std::size_t k = 0; k < std::size(kinds); ++k) {
    CAPTURE(kinds[k]);
    REQUIRE(plot(std::string("--kind ") + kinds[k] + " -o a.svg").exit == 0);
    const std::string svg = bytes_of("a.svg");
    CHECK(svg.starts_with("<?xml"));
    CHECK(svg.ends_with("</svg>\n\n"));
    for (const char* word : words[k]) CHECK_THAT(words_of("a.svg"), ContainsSubstring(word));
  }
}

// 8 cm are 226.77 pt. The kinds differ in height, not in width.
TEST_CASE("every kind draws a PDF of one page that is 8 cm wide, with its fonts", "[plot][contract]") {
  for (const char* kind : kinds) {
    CAPTURE(kind);
    const Outcome run = plot(std::string("--kind ") + kind + " -o a.pdf");
    CHECK(run.exit == 0);
    CHECK(run.error + run.out == "");
    const std::string pdf = bytes_of("a.pdf");
    CHECK(pdf.starts_with("%PDF-1."));
    CHECK(std::abs(width_of_pdf("a.pdf") - 226.77) <= 1);
    CHECK_THAT(pdf, ContainsSubstring("DejaVuSans") && !ContainsSubstring("CreationDate"));
  }
  CHECK(shell("asperity-plot < " + scene() + " --kind map -o - --to pdf").out.starts_with("%PDF"));
}

// The smallest letters of a page of 8 cm, printed as that, are those that journals ask for: 6 pt or more.
TEST_CASE("letters of an SVG are 6 pt high where one panel is printed 8 cm wide", "[plot][law]") {
  for (const char* kind : kinds) {
    CAPTURE(kind);
    REQUIRE(plot(std::string("--kind ") + kind + " -o size.svg").exit == 0);
    const std::string svg = bytes_of("size.svg"), size = "font-size=\"";
    int width = 0, found = 0;
    REQUIRE(std::sscanf(svg.c_str() + svg.find("viewBox="), "viewBox=\"0 0 %d", &width) == 1);
    for (auto at = svg.find(size); at != svg.npos; at = svg.find(size, at + 1), ++found)
      CHECK(std::atof(svg.c_str() + at + size.size()) / width * 8 / 2.54 * 72 >= 6);
    CHECK(found >= 4);
  }
}

// The label of the x axis used to stand half below the lower edge of an SVG: gnuplot places it by the
// terminal's fonts.
TEST_CASE("no text of an SVG leaves its canvas", "[plot][law]") {
  for (const char* kind : kinds) {
    CAPTURE(kind);
    REQUIRE(plot(std::string("--kind ") + kind + " -o edge.svg").exit == 0);
    check_texts_inside("edge.svg");
  }
}

// A legend of four profiles used to begin and to end beyond the edges.
TEST_CASE("a legend that is longer than a line takes several", "[plot][law]") {
  const std::string four = scene() + " " + scene() + " " + scene() + " " + scene();
  REQUIRE(shell("asperity-plot " + four + " --kind profile -o four.svg --labels '" +
                "the first surface,the second surface,the third surface,the fourth surface'")
              .exit == 0);
  check_texts_inside("four.svg");
  CHECK_THAT(words_of("four.svg"), ContainsSubstring("first") && ContainsSubstring("fourth"));
}

TEST_CASE("the same dataset gives the same bytes", "[plot][contract][slow]") {
  const auto drawn = [] {
    std::vector<std::string> out;
    for (const std::string name :
         {"map -o b.png", "surface -o b.png", "von-mises -o b.svg", "acf -o b.pdf"}) {
      REQUIRE(plot("--kind " + name).exit == 0);
      out.push_back(bytes_of(name.substr(name.size() - 5)));
    }
    return out;
  };
  const std::vector<std::string> first = drawn();
  await_next_second();  // a second date
  const std::vector<std::string> second = drawn();
  for (std::size_t k = 0; k < first.size(); ++k) CHECK((first[k] == second[k]));
}

TEST_CASE("what a title holds is drawn and never run", "[plot][contract]") {
  REQUIRE(plot("--kind map --title \"a'b \\`touch ran\\` <&> @x {y}_2 \\$(touch ran)\" -o t.svg").exit == 0);
  CHECK_THAT(words_of("t.svg"), ContainsSubstring("a'b `touch ran` &lt;&amp;> @x {y}_2 $(touch ran)"));
  CHECK_FALSE(std::filesystem::exists(scratch("ran")));
}

// The lags of a kernel are first + k step: near the origin they miss zero by rounding. They were refused.
TEST_CASE("lags that miss zero by rounding still have their origin", "[plot][contract]") {
  Dataset data;
  const Field rho = Field::NullaryExpr(
      4, 7, [](Index p, Index q) { return std::exp(-1.0 * static_cast<double>(p + std::abs(q - 3))); });
  for (const char* name : {"acf_target", "acf_achieved"})
    set_table(data, name, rho, {"p", 0, 0.1, "m", "lag"}, {"q", -3, 0.1, "m", "lag"}, {"m2", "acf"});
  write_dataset(data, "kernel.nc");
  const Outcome run = shell("asperity-plot kernel.nc --kind acf -o k.svg");
  INFO(run.error);
  CHECK(run.exit == 0);
}

TEST_CASE("the section through the largest stress is where the dataset says", "[plot][contract]") {
  scene();
  Dataset data = read_dataset("scene.nc");
  CHECK(plot("--kind von-mises --section y=max -o w.png").exit == 4);
  data.attributes.set("stress_max_y", 37.5e-6);
  write_dataset(data, "max.nc");
  REQUIRE(shell("asperity-plot max.nc --kind von-mises --section y=max -o m.svg").exit == 0);
  CHECK_THAT(words_of("m.svg"), ContainsSubstring("y = 37.5 µm"));
}

TEST_CASE("several cases stand side by side under their names", "[plot][contract]") {
  const Outcome run = plot(scene() + " --kind map --labels first,second -o two.svg");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  CHECK_THAT(words_of("two.svg"), ContainsSubstring("first") && ContainsSubstring("second"));
}

// Three panels: in one column 8 cm wide, in two 11.5 cm; the lowest of each column names x, the left ones y.
TEST_CASE("panels stand in so many columns, and share their axes", "[plot][law][slow]") {
  for (const std::string kind : {"map", "surface", "acf", "pdf", "contact", "von-mises"}) {
    CAPTURE(kind);
    for (const auto& [columns, points, bottoms, lefts] :
         {std::tuple{1, 226.77, 1u, 3u}, std::tuple{2, 325.98, 2u, 2u}, std::tuple{3, 425.20, 3u, 1u}}) {
      CAPTURE(columns);
      const std::string three = scene() + " " + scene() + " --labels one,two,six --kind " + kind +
                                " --columns " + std::to_string(columns);
      REQUIRE(plot(three + " -o three.svg").exit == 0);
      REQUIRE(plot(three + " -o three.pdf").exit == 0);
      CHECK(std::abs(width_of_pdf("three.pdf") - points) <= 1);
      check_texts_inside("three.svg");
      const std::string words = words_of("three.svg");
      for (const std::string label : {"one", "two", "six"}) CHECK_THAT(words, ContainsSubstring(label));
      if (kind != "map" && kind != "contact") continue;
      CHECK(occurrences(words, "x [") == bottoms);
      CHECK(occurrences(words, "y [") == lefts);
    }
  }
}
