// Runs asperity-report as a user does and reads the page.
#include <filesystem>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/cli/readable.hpp"
#include "tools/cli/table.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

std::string page_of(const std::string& name) {
  std::ifstream in(scratch(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The page but for the digits of its pictures and fields, in which any word may occur, and its own script.
std::string words_of(std::string page) {
  for (const std::string_view begin : {";base64,", "data-z=", "data-colours=", "<script>"})
    for (auto at = page.find(begin); at != page.npos; at = page.find(begin, at + begin.size())) {
      const auto first = begin.starts_with("data") ? page.find('>', at) + 1 : at + begin.size();
      page.erase(first, page.find_first_of(begin == "<script>" ? "<" : "\"'<", first) - first);
    }
  return page;
}

// The page on a dataset of the scratch folder, which must be sound whatever the dataset.
std::string report_on(const std::string& arguments) {
  const Outcome run = shell("asperity-report " + arguments + " -o page.html");
  INFO(arguments << ": " << run.error);
  REQUIRE(run.exit == 0);
  const Outcome balance = shell("python3 " BALANCED " page.html");
  INFO(balance.error);
  CHECK(balance.exit == 0);
  const std::string page = words_of(page_of("page.html"));
  CHECK_THAT(page, !ContainsSubstring("http") && !ContainsSubstring(" src=\"/") && !ContainsSubstring("nan"));
  return page;
}

void draw_surface() {
  REQUIRE(
      shell("asperity-generate --shape 64x64 --size 1mm --rq 0.4um --length 6px,4px --seed 7 -o s.nc").exit ==
      0);
}

void press_surface(const std::string& more) {
  draw_surface();
  shell("asperity-contact s.nc --load 100N --radius 20mm --young 210GPa --poisson 0.3 -o c.nc " + more);
}

std::size_t pictures_in(const std::string& page) {
  std::size_t out = 0;
  for (auto at = page.find("<figure>"); at != page.npos; at = page.find("<figure>", at + 1)) ++out;
  return out;
}

}  // namespace

TEST_CASE("the page holds every number, error and interval of asperity-stats", "[report][exact]") {
  draw_surface();
  const std::string page = report_on("s.nc");
  const auto table = nlohmann::json::parse(
      shell("asperity-stats s.nc --parameters height,material,spatial,hybrid --json").out);
  REQUIRE(table.size() > 40);
  auto holds = [&](double value) {
    CHECK_THAT(page, ContainsSubstring("<data value=\"" + cli::shortest(value) + "\">"));
  };
  for (const auto& [name, entry] : table.items()) {
    CAPTURE(name);
    holds(entry["value"].get<double>());
    if (!entry.contains("standard_error")) continue;
    holds(entry["standard_error"].get<double>());
    for (const auto& end : entry["interval_95"])
      if (end.is_number()) holds(end.get<double>());
  }
  CHECK(pictures_in(page) == 7);  // map, profiles, distribution, quantiles, material ratio, spectra, ACF
  CHECK_THAT(page, ContainsSubstring("asperity-generate --shape 64x64") &&
                       ContainsSubstring("seed</dt><dd class=\"short\">7<"));
}

TEST_CASE("a pressed and stressed surface shows pressure, contact, section and what the solvers achieved",
          "[report][contract][slow]") {
  press_surface("");
  REQUIRE(shell("asperity-stress c.nc --depths 1um:0.3mm:8 --maximum -o st.nc").exit == 0);
  const std::string page = report_on("st.nc");
  CHECK(pictures_in(page) == 11);  // and pressure, contact, section, stress by depth
  for (const char* word : {"100\u00A0N", "smooth bodies (Hertz)", "largest von Mises stress", "210\u00A0GPa",
                           "6 × 4 samples (93.75\u00A0µm × 62.5\u00A0µm)", "convolutions of full size",
                           "<svg viewBox=", "image/png;base64,", "aria-label=\"Autocorrelation: Sal ",
                           "class=\"volume\"", "<b>asperity-contact</b>: the grid does not resolve",
                           "<b>asperity-stress</b>: the largest von Mises stress lies", "2 warnings</h2>"})
    CHECK_THAT(page, ContainsSubstring(word));
  Dataset bare = read_dataset("st.nc");
  bare.attributes.erase("stress_warnings");
  write_dataset(bare, "bare.nc");
  CHECK_THAT(report_on("bare.nc"), ContainsSubstring("<b>asperity-stress</b>: 1 of 8 layers lie less than "));
}

TEST_CASE("a contact shows what --add told of it", "[report][contract]") {
  press_surface("--add contact_ratios,elastic_energy,patches");
  const std::string page = report_on("c.nc");
  for (const char* word : {"roughness of the sphere, σR/a0²", "elastic energy", "patches of contact",
                           "a patch percolates along x</dt><dd class=\"short\">no<"})
    CHECK_THAT(page, ContainsSubstring(word));
  CHECK_THAT(page, !ContainsSubstring("area share"));
}

// Without a load the stress below is the residual one; both are shown to four digits.
TEST_CASE(
    "a contact that flows shows its strain and the stress that asperity-stress finds once it is unloaded",
    "[report][exact][slow]") {
  const std::string press =
      "asperity-contact --smooth --shape 24x24 --size 3mm --radius 50mm --young 208GPa --poisson 0.3 "
      "--plasticity j2 --increments 2 ";
  require(press + "--load 6kN --yield 1GPa --unload -o flow.nc");
  const std::string page = report_on("flow.nc");
  CHECK(pictures_in(page) == 4);  // pressure, state, and two sections
  const Dataset data = read_dataset("flow.nc");
  const std::vector<double> strain = numbers(data.at("plastic_strain").values),
                            depths = numbers(data.at("layer").values);
  const auto k = static_cast<std::size_t>(std::ranges::max_element(strain) - strain.begin()) / (24 * 24);
  CHECK_THAT(page, ContainsSubstring("A contact with plastic flow") &&
                       ContainsSubstring(
                           "largest plastic strain</dt><dd>" +
                           cli::readable(data.attributes.number("contact_max_plastic_strain", 0), "1") +
                           "<small>at depth " + cli::readable(depths[k], "m")) &&
                       ContainsSubstring("dent of each body by plastic flow</dt><dd class=\"short\">" +
                                         cli::readable(data.attributes.number("contact_dent", 0), "m")) &&
                       ContainsSubstring("energy of the residual stress"));
  std::string all;
  for (const double z : depths) all += (all.empty() ? "" : ",") + cli::shortest(z) + "m";
  require("asperity-stress flow.nc -q --depths " + all + " -o below.nc");
  CHECK_THAT(page, ContainsSubstring(cli::readable(
                       std::ranges::max(numbers(read_dataset("below.nc").at("von_mises").values)), "Pa")));
  for (const std::string more : {"--load 6kN --yield 1GPa,9GPa", "--load 100N --yield 3GPa"}) {
    require(press + more + " -o flow.nc");
    CHECK_THAT(report_on("flow.nc"), !ContainsSubstring("largest plastic strain of the second body"));
  }
  CHECK_THAT(report_on("flow.nc"), !ContainsSubstring("Plastic flow"));
}

TEST_CASE("of a pressure the distribution is that of the cells in contact, with a form removed too",
          "[report][contract]") {
  press_surface("");
  const auto cells = (field_of(read_dataset("c.nc"), "pressure") > 0).count();
  for (const std::string more : {"", " --remove-form plane"})
    CHECK_THAT(report_on("c.nc --variable pressure" + more),
               ContainsSubstring(std::to_string(cells) + " of 4096 cells, in contact"));
}

TEST_CASE("figures show the field that the tables measure", "[report][contract]") {
  Dataset tilted;
  const Grid grid{{32, 32}, 1e-6, 1e-6};
  set_grid(tilted, grid);
  const Field rough = 1e-8 * random_field({32, 32}, 1);
  set_field(tilted, "heights", rough + sample(grid, [](double x, double) { return 0.1 * x; }),
            {"m", "height"});
  write_dataset(tilted, "tilted.nc");
  const auto sq = [](const std::string& page) {
    const auto at = page.find("<text>Sq = ");
    REQUIRE(at != page.npos);
    return std::stod(page.substr(at + 11));
  };
  // A plane of 3.1 µm over the side has Sq 0.92 µm.
  CHECK(sq(report_on("tilted.nc")) == Approx(923).margin(10));
  CHECK(sq(report_on("tilted.nc --remove-form plane")) < 20);
}

TEST_CASE("a solver that did not converge is told in plain sight", "[report][contract]") {
  press_surface("--max-convolutions 1");
  const std::string page = report_on("c.nc");
  const auto alarm = page.find("<b>asperity-contact</b>: not converged");
  REQUIRE(alarm != page.npos);
  CHECK(alarm < page.find("<dl"));
}

TEST_CASE("what a tool warned of stands above all numbers, with the tool's name and never as markup",
          "[report][contract]") {
  draw_surface();
  Dataset data = read_dataset("s.nc");
  data.attributes.set("filter_warnings", "one <b>\nanother");
  data.attributes.set("kernel_answer", "nearest");
  data.attributes.set("kernel_change", 0.02);
  write_dataset(data, "warned.nc");
  const std::string page = report_on("warned.nc"), top = page.substr(0, page.find("<dl"));
  for (const char* words :
       {"3 warnings</h2>", "<b>asperity-filter</b>: one &lt;b&gt;</li>",
        "<b>asperity-filter</b>: another</li>", "it was changed by up to 0.02 of the variance"})
    CHECK_THAT(top, ContainsSubstring(words));
  CHECK_THAT(page, ContainsSubstring("yes, to the closest autocorrelation found, not to the one asked for"));
}

TEST_CASE("a contact above the yield stress says so on top, whatever the dataset tells of it",
          "[report][contract]") {
  press_surface("--yield 300MPa");
  REQUIRE(shell("asperity-stress c.nc --depths 20um:0.3mm:8 --maximum -q -o st.nc").exit == 0);
  Dataset data = read_dataset("st.nc");
  data.attributes.erase("stress_warnings");
  data.attributes.erase("stress_max_von_mises");
  write_dataset(data, "bare.nc");
  for (const std::string name : {"st.nc", "bare.nc"})
    CHECK_THAT(report_on(name), ContainsSubstring("above the yield stress of 300"));
}

TEST_CASE("a measured surface with missing points, a smooth contact and a kernel each have a page",
          "[report][contract][slow]") {
  const std::string measured = report_on(ASPERITY_TEST_DATA "/profiler-96x96.x3p --remove-form plane");
  CHECK_THAT(measured, ContainsSubstring("Measured from the plane"));
  CHECK_THAT(measured, ContainsSubstring("standard errors and intervals cannot be given below 10"));
  const std::string open = report_on(ASPERITY_TEST_DATA "/afm-64x64.nc");
  CHECK_THAT(open, ContainsSubstring("\">above <data"));  // of the slowest decay
  draw_surface();
  Dataset data = read_dataset("s.nc");
  std::get<std::vector<double>>(data.find("heights")->values)[7] = std::nan("");
  write_dataset(data, "hole.nc");
  CHECK_THAT(report_on("hole.nc"), ContainsSubstring("N_missing"));
  REQUIRE(shell("asperity-contact --smooth --shape 32x32 --size 1mm --load 100N --radius 20mm --young 210GPa "
                "--poisson 0.3 -o smooth.nc")
              .exit == 0);
  CHECK_THAT(report_on("smooth.nc"), ContainsSubstring("Map of pressure"));
  REQUIRE(
      shell("asperity-generate --shape 64x64 --size 1mm --rq 0.4um --length 6px --seed 3 --count 2 -o m%d.nc")
          .exit == 0);
  CHECK_THAT(report_on("m1.nc"), ContainsSubstring("number in the ensemble</dt><dd class=\"short\">1<"));
}

TEST_CASE("what is left out says why", "[report][contract]") {
  Dataset flat;
  set_grid(flat, {{16, 16}, 1e-6, 1e-6});
  set_field(flat, "heights", Field::Zero(16, 16), {"m", "height"});
  write_dataset(flat, "flat.nc");
  const std::string page = report_on("flat.nc");
  CHECK_THAT(page, ContainsSubstring("Not computed: every value is the same"));
}

TEST_CASE("a broken field beside the one that is measured is left out", "[report][contract]") {
  draw_surface();
  Dataset data = read_dataset("s.nc");
  set_field(data, "own", Field::Zero(64, 64), {"K", "own field"});
  std::get<std::vector<double>>(data.find("own")->values)[7] = INFINITY;
  write_dataset(data, "broken.nc");
  const std::string page = report_on("broken.nc");
  CHECK_THAT(page, ContainsSubstring("data-label=\"height\"") && !ContainsSubstring("data-label=\"own"));
}

TEST_CASE("names, history and title of a hostile dataset are shown and never markup", "[report][contract]") {
  Dataset data;
  set_grid(data, {{16, 16}, 1e-6, 1e-6});
  set_field(data, "heights", 1e-7 * random_field({16, 16}, 1), {"m", "<i>heights</i>"});
  set_scalar(data, "a<b>&'c", 1, {"\"><svg onload=x>", "</table>"});
  data.attributes.set("note<s>", "</dl>\xff<b>");
  data.attributes.set("history", "2026: asperity-x '<script>alert(1)</script>'\n</ol><iframe>");
  write_dataset(data, "hostile.nc");
  const std::string page = report_on("hostile.nc --title '</title><script>x'");
  CHECK_THAT(page, ContainsSubstring("a&lt;b&gt;&amp;&#39;c") &&
                       ContainsSubstring("&lt;/ol&gt;&lt;iframe&gt;") &&
                       ContainsSubstring("<title>&lt;/title&gt;&lt;script&gt;x</title>"));
  for (const char* markup : {"<svg onload", "<iframe", "<s>", "<i>", "\xff"})
    CHECK_THAT(page, !ContainsSubstring(markup));
}

TEST_CASE("the same dataset gives the same page under SOURCE_DATE_EPOCH, on any number of threads",
          "[report][contract]") {
  draw_surface();
  const std::string run = "SOURCE_DATE_EPOCH=1000000000 asperity-report s.nc --threads ";
  const Outcome one = shell(run + "1"), two = shell(run + "2");
  REQUIRE(one.exit == 0);
  CHECK((one.out == two.out));
  CHECK_THAT(one.out, ContainsSubstring("2001-09-09T01:46:40Z"));
}

TEST_CASE("a report on what is no dataset, or holds nothing to tell, gets one line and its exit code",
          "[report][contract]") {
  draw_surface();
  Dataset empty;
  empty.attributes.set("title", "nothing");
  write_dataset(empty, "empty.nc");
  std::ofstream(scratch("garbage.nc")) << "\x89PNG no dataset";
  const struct {
    const char* arguments;
    int exit;
  } wrong[] = {{"absent.nc -o w.html", 1},
               {"garbage.nc -o w.html", 4},
               {"empty.nc -o w.html", 4},
               {"s.nc --variable gap -o w.html", 4},
               {"s.nc --remove-form x -o w.html", 2},
               {"s.nc --colour red -o w.html", 2},
               {"s.nc -o nowhere/w.html", 1}};
  for (const auto& [arguments, exit] : wrong) {
    const Outcome run = shell(std::string("asperity-report ") + arguments);
    CAPTURE(arguments, run.error);
    CHECK(run.exit == exit);
    CHECK(lines(run.error) == 1);
    CHECK_FALSE(std::filesystem::exists(scratch("w.html")));
  }
}

// The contact solved again starts from round-off of the first one's gap, 1e-16 of 4 um, and ends alike.
TEST_CASE("a page has the errors of the grid that its dataset lacks, equal to those of --add grid_errors",
          "[report][exact]") {
  REQUIRE(shell("asperity-generate --shape 64x64 --size 3mm --rq 0.4um --model gaussian --length 12px --seed "
                "7 -o s.nc")
              .exit == 0);
  // The number of an element, or that of the attribute's line.
  auto told = [](const std::string& page, double value) {
    const std::string begin = " ± <data value=\"";
    double nearest = 0;
    for (auto at = page.find(begin); at != page.npos; at = page.find(begin, at + 1)) {
      const double found = std::stod(page.substr(at + begin.size()));
      if (std::abs(found - value) < std::abs(nearest - value)) nearest = found;
    }
    return nearest;
  };
  for (const std::string given : {"--load 5000N", "--load 5000N --yield 800MPa", "--approach 25um"}) {
    CAPTURE(given);
    const std::string press = "asperity-contact s.nc -q --radius 50mm --young 208GPa --poisson 0.3 " + given,
                      below = " | asperity-stress --maximum -q ";
    REQUIRE(shell(press + " --add contact_stiffness" + below + "-o plain.nc").exit == 0);
    REQUIRE(shell(press + " --add contact_stiffness,grid_errors" + below + "--add grid_errors -o asked.nc")
                .exit == 0);
    const Attributes asked = read_dataset("asked.nc").attributes;
    const std::string page = report_on("plain.nc"), same = report_on("asked.nc");
    CHECK_THAT(page, ContainsSubstring("value ± error of the grid") && !ContainsSubstring("Not all errors"));
    for (const char* name : {"load", "approach", "max_pressure", "area", "area_corrected", "plastic_area",
                             "mean_gap", "stiffness"}) {
      CAPTURE(name);
      const double error = asked.number(std::string("contact_") + name + "_error", 0);
      const bool clamped = name == std::string("max_pressure") && given.ends_with("800MPa");
      if (error > 0 && !clamped) CHECK(told(page, error) == Approx(error).epsilon(1e-6));
      if (clamped) CHECK_THAT(page, ContainsSubstring("<small>the limit pressure itself</small>"));
    }
    // Of the stress both pages show the same digits.
    auto line = [](const std::string& of, const std::string& name) {
      const auto at = of.find("title=\"" + name + "\"");
      REQUIRE(at != of.npos);
      return of.substr(at, of.find("</dd>", at) - at);
    };
    for (const char* name : {"stress_max_von_mises", "stress_max_depth"}) {
      CHECK_THAT(line(page, name), ContainsSubstring(" ± "));
      CHECK(line(page, name) == line(same, name));
    }
  }
}

TEST_CASE("where errors of the grid cannot be computed the page says why in one sentence",
          "[report][contract]") {
  REQUIRE(shell("asperity-contact --smooth --shape 64x64 --size 3mm --radius 50mm --young 208GPa --poisson "
                "0.3 --load 5kN | asperity-stress --maximum -q -o whole.nc")
              .exit == 0);
  const Dataset whole = read_dataset("whole.nc");
  auto page_without = [&](auto change) {
    Dataset data = whole;
    change(data);
    write_dataset(data, "changed.nc");
    return report_on("changed.nc");
  };
  const std::string words = "Not all errors of the grid are known: ";
  CHECK_THAT(report_on("whole.nc"), !ContainsSubstring(words));
  CHECK_THAT(page_without([](Dataset& data) { data.erase("gap"); }),
             ContainsSubstring(words + "the dataset has no gap, which asperity-contact writes."));
  CHECK_THAT(page_without([](Dataset& data) {
               const Field twice = 2 * field_of(data, "pressure");
               set_field(data, "pressure", twice, {"Pa", "contact pressure"});
             }),
             ContainsSubstring(words + "by its fields contact_load is 10000 N, not 5000 N; it was cropped or "
                                       "changed since."));
  // The middle, which carries the whole load: its mean gap is another.
  CHECK_THAT(
      page_without([](Dataset& data) {
        const Dataset all = data;
        Grid grid = grid_of(all);
        grid.shape = {48, 48};
        set_grid(data, grid);
        for (const auto& [name, unit] : {std::pair{"pressure", "Pa"}, {"gap", "m"}, {"displacement", "m"}})
          set_field(data, name, field_of(all, name).block(8, 8, 48, 48), {unit, name});
      }),
      ContainsSubstring("by its fields contact_mean_gap is "));
  CHECK_THAT(page_without([](Dataset& data) { data.attributes.set("contact_converged", 0); }),
             ContainsSubstring(words + "the contact did not converge."));
  press_surface("");
  CHECK_THAT(report_on("c.nc"), ContainsSubstring(words + "the grid does not resolve the surface"));
}
