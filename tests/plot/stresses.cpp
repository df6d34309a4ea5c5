// Sections with lines of equal stress, stress by depth, and loads, from datasets and from tables in a pipe.
#include <fstream>

#include "plot/pictures.hpp"
#include "tools/plot/figure.hpp"
#include "tools/plot/table.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::vector<double> depths{0, 1e-5, 3e-5, 8e-5};

// A stress that is largest at one cell of one layer, 9 times 100 MPa.
Dataset peaked(Index layer, Index i, Index j) {
  const Grid grid{{24, 20}, 1e-5, 1e-5};
  Dataset data;
  set_grid(data, grid);
  set_depths(data, depths);
  std::vector<double> stress;
  for (Index k = 0; k < 4; ++k)
    for (Index cell = 0; cell < grid.shape.cells(); ++cell) {
      const Index di = std::abs(cell / 20 - i), dj = std::abs(cell % 20 - j), dk = std::abs(k - layer);
      stress.push_back(1e8 * static_cast<double>(std::max<Index>(9 - di - dj - 2 * dk, 0)));
    }
  set_volume(data, "von_mises", stress, {"Pa", "von Mises stress"});
  return data;
}

plot::Request request() {
  plot::Request out;
  out.format = "svg";
  return out;
}

const plot::Layer& last_with(const plot::Panel& panel, std::string_view word) {
  const auto found =
      std::ranges::find_if(panel.layers.rbegin(), panel.layers.rend(),
                           [&](const plot::Layer& l) { return l.command.find(word) != l.command.npos; });
  REQUIRE(found != panel.layers.rend());
  return *found;
}

void write_text(const std::string& name, const std::string& text) { std::ofstream(scratch(name)) << text; }

}  // namespace

TEST_CASE("a section is marked at its largest stress, which the title says", "[plot][exact]") {
  const Dataset data = peaked(1, 5, 12);
  const Grid grid = grid_of(data);
  plot::Request asked = request();
  asked.section = "y=25um";  // of row 12
  const plot::Figure figure = plot::section({{data, "one"}}, asked);
  const plot::Layer& mark = last_with(figure.panels[0], "pointtype 1");
  CHECK(mark.numbers[0] * 1e-6 == Approx(grid.x(5)).epsilon(1e-14));
  CHECK(mark.numbers[1] * 1e-6 == Approx(depths[1]).epsilon(1e-14));
  CHECK(figure.title == "section y = 25 µm, largest 900 MPa at +");
  // In SVG the lines of the cross were a thin black and white, unseen on any colour: a disc lies below it.
  const plot::Layer& disc = last_with(figure.panels[0], "pointtype 7");
  CHECK(disc.numbers == mark.numbers);
  asked.x = {0, 1};  // beyond the largest
  const plot::Figure part = plot::section({{data, "one"}}, asked);
  CHECK_THAT(part.title, !ContainsSubstring("900"));
}

TEST_CASE("isolines stand at the numbers of the colour bar that lie within, and a constant has none",
          "[plot][exact]") {
  Dataset data = peaked(1, 5, 12);
  const plot::Figure figure = plot::section({{data, "one"}}, request());
  CHECK_THAT(figure.panels[0].commands.text(), ContainsSubstring("levels discrete 200,400,600\n"));
  CHECK(last_with(figure.panels[0], "with lines").from == "$lines");
  write_dataset(data, "peak.nc");
  for (const char* format : {"svg", "png", "pdf"}) {
    const Outcome run = shell(std::string("asperity-plot peak.nc --kind von-mises -v -o peak.") + format);
    CHECK((run.exit == 0 && run.error.find("gnuplot") == std::string::npos));
  }
  set_volume(data, "von_mises", std::vector<double>(4 * 480, 1e6), {"Pa", "von Mises stress"});
  const plot::Figure even = plot::section({{data, "one"}}, request());
  CHECK(even.panels[0].commands.text().empty());
}

TEST_CASE("the largest stress by depth is that of each layer, beside the one that was searched for",
          "[plot][exact]") {
  Dataset data = peaked(2, 5, 12);
  data.attributes.set("stress_max_von_mises", 9.5e8);
  data.attributes.set("stress_max_von_mises_error", 2e7);
  data.attributes.set("stress_max_depth", 2.5e-5);
  data.attributes.set("stress_accurate_depth", 2e-5);
  const plot::Figure figure = plot::maxima({{data, "one"}}, request());
  const std::vector<double>& curve = last_with(figure.panels[0], "pointtype 7").numbers;
  REQUIRE(curve.size() == 8);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(curve[2 * k] == Approx(depths[k] * 1e6).epsilon(1e-14));
    CHECK(curve[2 * k + 1] == Approx(0.9 - 0.2 * std::abs(static_cast<double>(k) - 2)).epsilon(1e-14));
  }
  const std::vector<double>& top = last_with(figure.panels[0], "pointtype 2").numbers;
  CHECK((top.size() == 2 && std::abs(top[0] - 25) <= 1e-13 && std::abs(top[1] - 0.95) <= 1e-15));
  CHECK(figure.title == "950 ± 20 MPa at 25 µm (×)");
  CHECK(figure.legend.size() == 1);  // stress_accurate_depth
}

TEST_CASE("tables of loads and of maxima are drawn from a pipe, with their errors", "[plot][contract]") {
  write_text("sweep.txt",
             "# load [N]\tapproach [m]\tarea [m2]\tarea_corrected [m2]\tconverged [1]\n"
             "1\t1e-6\t1e-9\t1e-9\t1\n10\t2e-6\t1e-8\t9e-9\t0\n");
  REQUIRE(shell("asperity-plot --kind sweep --to svg -o - < sweep.txt > a.svg").exit == 0);
  CHECK_THAT(words_of("a.svg"), ContainsSubstring("load [N]") && ContainsSubstring("approach [µm]") &&
                                    ContainsSubstring("contact area [") &&
                                    ContainsSubstring("not converged"));
  write_text("maxima.txt", "# depth [m]\tvon_mises [Pa]\tstandard_error [Pa]\n0\t1e8\t1e7\n1e-5\t2e8\t2e7\n");
  REQUIRE(shell("asperity-plot maxima.txt --kind maxima -o a.svg").exit == 0);
  CHECK_THAT(words_of("a.svg"),
             ContainsSubstring("largest von Mises [MPa]") && ContainsSubstring("95 % intervals"));
  const plot::Figure figure =
      plot::maxima({{plot::dataset_of_table(
                         "# depth [m]\tvon_mises [Pa]\tstandard_error [Pa]\n0\t1e8\t1e7\n1e-5\t2e8\t2e7\n"),
                     "one"}},
                   request());
  const std::vector<double>& band = last_with(figure.panels[0], "filledcurves").numbers;
  CHECK(band[1] == Approx(100 - 19.59963984540054).epsilon(1e-12));
  CHECK(band[5] == Approx(200 + 2 * 19.59963984540054).epsilon(1e-12));
}

TEST_CASE("what is no such table is refused in a line", "[plot][contract]") {
  const struct {
    const char *text, *kind, *words;
  } wrong[] = {{"1 2 3\n", "sweep", "table is none that a tool printed"},
               {"# \t\n1\t2\n", "sweep", "table has no columns"},
               {"# load [N]\tapproach [m]\tarea [m2]\nnan\tnan\tnan\n", "sweep", "load: no row of the table"},
               {"# load [N]\tapproach [m]\n", "sweep", "table has no rows"},
               {"# load [N]\tapproach [m]\n1\n", "sweep", "table: line 2 has 1 cell for 2 columns"},
               {"# load [N]\tapproach [m]\n1\t2\n", "sweep", "area is in no column"},
               {"# load [N]\tapproach [m]\n1\t2\n", "maxima", "depth is not the first column"}};
  for (const auto& [text, kind, words] : wrong) {
    write_text("wrong.txt", text);
    const Outcome run = shell(std::string("asperity-plot wrong.txt -o w.svg --kind ") + kind);
    CAPTURE(text, run.error);
    CHECK((run.exit == 4 && lines(run.error) == 1));
    CHECK_THAT(run.error, ContainsSubstring(words));
  }
  CHECK_THAT(test::plot("--kind sweep -o w.svg").error, ContainsSubstring("load is in no column"));
  CHECK(test::plot("--kind sweep -o w.svg").exit == 4);
}
