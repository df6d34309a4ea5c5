// Maps of more points than pixels or with outliers, errors in titles, scale bars, and sections of several cases.
#include <cmath>
#include <sstream>

#include "plot/boxes.hpp"
#include "tools/plot/figure.hpp"
#include "tools/plot/source.hpp"
#include "tools/plot/table.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

plot::Case case_of(const Field& z) {
  Dataset data;
  set_grid(data, {{z.rows(), z.cols()}, 1e-6, 1e-6});
  set_field(data, "heights", z, {"m", "height"});
  set_field(data, "contact", z, {"1", "contact state"});
  return {data, "one"};
}

plot::Request request(const std::string& format = "png") {
  plot::Request out;
  out.format = format;
  return out;
}

const plot::Layer& layer_with(const plot::Figure& figure, std::string_view word) {
  const auto& layers = figure.panels.at(0).layers;
  const auto found = std::ranges::find_if(
      layers, [&](const plot::Layer& l) { return l.command.find(word) != l.command.npos; });
  REQUIRE(found != layers.end());
  return *found;
}

}  // namespace

// The panel is 720 pixels wide at most, so that 1440 points along x are blocks of two or three. Of z = i the mean
// of a block of k points from i on is i + (k - 1)/2 exactly. A side of 33 000 points was refused by gnuplot.
TEST_CASE("a pixel of a dense map shows the mean of the points of its block that are there",
          "[plot][exact]") {
  Field z = Field::NullaryExpr(1440, 12, [](Index i, Index) { return static_cast<double>(i); });
  plot::Case dense = case_of(z);
  std::vector<std::int8_t> mask(1440 * 12, 0);
  mask[0] = 1;
  set_flags(dense.data, "mask", mask, "missing points", "measured missing");
  const plot::Figure figure = plot::map({dense}, request());
  std::istringstream note(figure.panels[0].x->note.substr(figure.panels[0].x->note.find("means of")));
  std::string word;
  Index along = 0, up = 0;
  note >> word >> word >> along >> word >> up;
  REQUIRE(((along == 2 || along == 3) && up == 1));
  const std::vector<double>& drawn = layer_with(figure, "with image").numbers;  // fast along x
  const Index columns = 1440 / along;
  REQUIRE(std::ssize(drawn) == columns * 12);
  for (Index k = 0; k < columns; ++k)
    CHECK(std::abs(drawn[static_cast<std::size_t>(columns + k)] * 1e3 -
                   (static_cast<double>(along * k) + 0.5 * static_cast<double>(along - 1))) <= 1e-9);
  CHECK(std::abs(drawn[0] * 1e3 - 0.5 * static_cast<double>(along)) <= 1e-12);  // without the point at 0
  CHECK(plot::map({case_of(z)}, request("pdf")).panels[0].x->note.find("means") == std::string::npos);
  for (const char* format : {"png", "svg", "pdf"}) {
    write_dataset(case_of(1e-7 * random_field({33'000, 3}, 1)).data, "long.nc");
    const Outcome run = shell(std::string("asperity-plot long.nc --kind map -o long.") + format);
    CHECK((run.exit == 0 && run.error.empty()));
  }
  CHECK_THAT(words_of("long.svg"), ContainsSubstring("means of ") && ContainsSubstring(" × 1 points"));
  CHECK_THAT(bytes_of("long.pdf"), ContainsSubstring("/Image"));
}

TEST_CASE("a contact of a single cell stays in a map of more cells than pixels", "[plot][law]") {
  Field states = Field::Zero(2000, 1500);
  states(1234, 567) = 2;
  const plot::Figure figure = plot::contact({case_of(states)}, request());
  CHECK_THAT(figure.panels[0].x->note, ContainsSubstring("largest of 3 × 3 points"));
  CHECK(std::ranges::count(layer_with(figure, "with image").numbers, 2.0) == 1);
}

// Of k = 0, 1, ... 1000 the share p % lies at k = 10 p.
TEST_CASE("colours of shares of the values are between these quantiles", "[plot][exact]") {
  Field z = Field::NullaryExpr(1001, 1, [](Index i, Index) {
              return static_cast<double>(i * 2 % 1001);
            }).replicate(1, 2);
  plot::Request asked = request();
  asked.range = "1%:97.5%";
  const plot::ColourBar bar = *plot::map({case_of(z)}, asked).colours;
  CHECK(bar.colours.range == plot::Range{10, 975});
  CHECK(bar.name == "height, 1 to 97.5 %");
  CHECK(plot::map({case_of(z)}, request()).colours->colours.range == plot::Range{0, 1000});
}

// The middle 99 % of heights that are uniform from -0.1 to 0.1 µm are 0.198 µm wide, and 8 times that is 1.58 µm.
TEST_CASE("outliers among heights take colours from no others, and among pressures keep them",
          "[plot][law]") {
  Field z = 1e-7 * random_field({100, 100}, 1);
  CHECK(plot::map({case_of(z)}, request()).colours->name == "height");
  z(5, 5) = 1.4e-6;
  CHECK(plot::map({case_of(z)}, request()).colours->name == "height");
  z(5, 5) = 6e-6;
  const plot::Figure squeezed = plot::map({case_of(z)}, request());
  CHECK(squeezed.colours->name == "height, 0.5 to 99.5 %");
  CHECK(squeezed.colours->colours.range.high < 1e-7);
  CHECK_THAT(squeezed.title, ContainsSubstring("to 6 µm"));
  plot::Request asked = request();
  asked.range = "-1um,6um";
  CHECK(plot::map({case_of(z)}, asked).colours->colours.range == plot::Range{-1e-6, 6e-6});
  plot::Case pressed = case_of(z);
  set_field(pressed.data, "pressure", z.abs(), {"Pa", "pressure"});
  asked = request();
  asked.variable = "pressure";
  CHECK(plot::map({pressed}, asked).colours->colours.range.high == 6e-6);
}

TEST_CASE("shares that are none are refused, and a kind without colours refuses all", "[plot][contract]") {
  for (const char* range :
       {"1%:", ":99%", "99%:1%", "1%:101%", "-1%:99%", "1:99", "1%:1%", "a%:b%", "0%:nan%"}) {
    const Outcome run = test::plot(std::string("--kind map -o a.png --range=") + range);
    CAPTURE(range, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1));
    CHECK_THAT(run.error, ContainsSubstring("is no pair of rising shares from 0 to 100 %"));
  }
  for (const char* kind : {"abbott", "qq", "profile", "maxima"}) {
    const Outcome run = test::plot(std::string("--range 1%:99% -o a.png --kind ") + kind);
    CAPTURE(kind, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1));
    CHECK_THAT(run.error, ContainsSubstring("which this kind has not: give LOW,HIGH with unit"));
  }
}

TEST_CASE("a scale bar stands in place of the axes, and notes stay", "[plot][contract]") {
  write_dataset(case_of(1e-7 * random_field({300, 20}, 1)).data, "bar.nc");
  REQUIRE(shell("asperity-plot bar.nc --kind map --scale-bar -o bar.svg").exit == 0);
  const std::string words = words_of("bar.svg");
  CHECK_THAT(words,
             ContainsSubstring("100 µm\n") && ContainsSubstring("y × 2.4\n") && !ContainsSubstring("x ["));
  check_apart("bar.svg");
  check_inside("bar.svg");
  CHECK_THAT(test::plot("--kind pdf --scale-bar -o a.svg").error, ContainsSubstring("--scale-bar"));
}

// "386 ± 17 nm": the title of a distribution had values alone.
TEST_CASE("titles of distributions and of material ratio curves have the errors that asperity-stats prints",
          "[plot][contract]") {
  REQUIRE(shell("asperity-generate --shape 64x48 --size 1mm --rq 0.4um --length 5px --seed 7 -o d.nc").exit ==
          0);
  for (const auto& [kind, symbols] :
       {std::pair{"pdf", std::array{"Sq", "Ssk", "Sku"}}, {"abbott", std::array{"Sk", "Spk", "Svk"}}}) {
    REQUIRE(shell(std::string("asperity-plot d.nc -o d.svg --kind ") + kind).exit == 0);
    std::string title = words_of("d.svg");
    std::ranges::replace(title, '\n', ' ');
    for (auto at = title.find("−"); at != title.npos; at = title.find("−")) title.replace(at, 3, "-");
    for (const char* symbol : symbols) {
      std::istringstream row(
          shell(std::string("asperity-stats d.nc --parameters height,material --table text | grep '^") +
                symbol + " '")
              .out);
      std::string name, value, sign, error;
      row >> name >> value >> sign >> error;
      CAPTURE(title, symbol);
      CHECK_THAT(title, ContainsSubstring(std::string(symbol) + " = " + value + " ± " + error));
    }
  }
}

// t(0.975) of three degrees of freedom is 3.182446305284263 (tables; Abramowitz & Stegun 26.10).
TEST_CASE("intervals of means over four surfaces are as wide as Student's t says", "[plot][exact]") {
  const auto of = [](const std::string& n) {
    return plot::half_intervals(
        plot::dataset_of_table("# depth [m]\tstandard_error [Pa]\tsurfaces [1]\n0\t1\t" + n + "\n1\t2\t" + n +
                               "\n"),
        "standard_error");
  };
  CHECK(of("4")(0) == Approx(3.182446305284263).epsilon(1e-9));
  CHECK(of("4")(1) == Approx(2 * 3.182446305284263).epsilon(1e-9));
  CHECK(std::isnan(of("1")(0)));
}

// gnuplot's hair lines, 0.4 of 1200 pixels, left hollow marks and crosses hardly visible.
TEST_CASE("lines of symbols in an SVG are as wide as those of the other formats", "[plot][contract]") {
  REQUIRE(test::plot("--kind psd -o a.svg").exit == 0);
  const std::string svg = bytes_of("a.svg");
  for (const char* symbol : {"<path id='gpPt0' ", "<path id='gpPt1' ", "<circle id='gpPt5' "})
    CHECK_THAT(svg, ContainsSubstring(std::string(symbol) + "stroke-width='0.3'"));
}

TEST_CASE("sections of several cases say where each lies, or lie where the largest of all is",
          "[plot][contract]") {
  std::vector<plot::Case> cases;
  for (const auto& [place, largest] : {std::pair{-1e-5, 1e9}, {1.5e-5, 2e9}}) {
    Dataset data = read_dataset(scene());
    data.attributes.set("stress_max_von_mises", largest);
    data.attributes.set("stress_max_y", place);
    cases.push_back({data, "case"});
  }
  plot::Request asked = request();
  asked.section = "y=max";
  const plot::Figure apart = plot::section(cases, asked);
  CHECK(apart.panels[0].label == "case, y = −12.5 µm");
  CHECK(apart.panels[1].label == "case, y = 12.5 µm");
  asked.section = plot::section_of_all(cases, "y=max-of-all");
  const plot::Figure alike = plot::section(cases, asked);
  CHECK(alike.title == "section y = 12.5 µm");
  CHECK(alike.panels[0].label == "case");
  CHECK_THAT(
      test::plot("--kind von-mises --section y=max-of-all -o a.png").error,
      ContainsSubstring("stress_max_y: is missing in scene") || ContainsSubstring("stress_max_y is missing"));
}
