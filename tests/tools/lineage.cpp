// What the tools write, and what rests on what: a result that is replaced takes with it all that was computed from it.
#include "tools/cli/lineage.hpp"

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "dataset/catalogue.hpp"
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

using Words = std::set<std::string>;

const std::string bodies = " --radius 50mm --young 208GPa --poisson 0.3 ";

/// Of a variable or an attribute, "" of what the tools do not know.
std::string owner(const std::string& name) {
  const KnownResult* result = result_of(name);
  return result ? std::string(result->name) : std::string();
}

bool is_coordinate(const Variable& v) { return v.dimensions == std::vector<std::string>{v.name}; }

bool is_of_the_run(const std::string& name) {
  return name == "history" || name == "source" || name == "Conventions";
}

bool stands_on_surface(const Variable& v) {
  return std::ranges::any_of(v.dimensions, [](const std::string& d) { return d == "x" || d == "y"; });
}

// Every result there is, and a stranger's variables and attributes, two of which look like ours.
void write_everything() {
  static const bool once = [] {
    const Outcome run = shell(
        "export SOURCE_DATE_EPOCH=1; asperity-generate --shape 16x12 --size 1.6mm,1.2mm --rq 0.4um "
        "--length 3px --seed 7 --add noise,kernel | asperity-acf --add structure_function,acf_quantiles "
        "--max-lag "
        "5x5 | "
        "asperity-psd | asperity-contact --load 5N --yield 100MPa --add heights_residual" +
        bodies + "| asperity-stress --depths 0:50um:3 --maximum --components all -o all.nc");
    INFO(run.error);
    REQUIRE(run.exit == 0);
    Dataset data = read_dataset("all.nc");
    set_field(data, "own_field", random_field({16, 12}, 1), {"K", "of a user"});
    data.put({"own_number", {}, std::vector<float>{2.5F}, {}});
    data.put({"own_depths", {"z"}, std::vector<double>{1, 2, 3}, {}});
    data.attributes.set("filter_form_degree", 1);
    data.attributes.set("operator", "a person");
    data.attributes.set("contact_person", "another");
    data.attributes.set("stress_relief", "600 degC, 2 h");
    write_dataset(data, "all.nc");
    return true;
  }();
  REQUIRE(once);
}

struct Case {
  std::string command;       // with all.nc for its input
  Words computed;            // results that it computes anew
  Words stale;               // that rest on them, or on what they replace
  bool new_surface = false;  // whatever lies on (x, y) goes too

  std::string tool() const { return command.substr(0, command.find(' ')); }
};

const std::vector<Case>& cases() {
  static const Words of_surface{"filter", "acf", "psd", "contact", "residual", "stress"};
  static const Words of_kernel{"heights", "filter", "acf", "psd", "contact", "residual", "stress"};
  static const Words but_filter{"kernel", "acf", "psd", "contact", "residual", "stress"};
  static const std::vector<Case> list{
      {"asperity-contact all.nc --load 2N" + bodies, {"contact"}, {"residual", "stress"}},
      {"asperity-contact all.nc --load 2N --variable heights_residual" + bodies, {"contact"}, {"stress"}},
      {"asperity-contact all.nc --load 2N --yield 90MPa --add heights_residual" + bodies,
       {"contact", "residual"},
       {"stress"}},
      {"asperity-stress all.nc --maximum", {"stress"}, {}},
      {"asperity-stress all.nc --depths 0:50um:3 --components zz --friction 0.2", {"stress"}, {}},
      {"asperity-stress all.nc --depths 0:50um:3 --section y=0", {"stress"}, {}},
      {"asperity-acf all.nc --max-lag 4x4", {"acf"}, {}},
      {"asperity-acf all.nc --variable pressure --max-lag 4x4", {"acf"}, {}},
      {"asperity-psd all.nc --window none", {"psd"}, {}},
      {"asperity-generate --seed 8 --add kernel < all.nc", {"heights"}, of_surface, true},
      {"asperity-generate --acf all.nc --infeasible nearest --seed 8 --add kernel",
       {"kernel", "heights"},
       of_surface,
       true},
      {"asperity-kernel --acf all.nc --infeasible nearest", {"kernel"}, of_kernel, true},
      {"asperity-filter all.nc --crop 0:8,2:", {"heights", "filter"}, but_filter, true},
      {"asperity-convert all.nc", {}, {}},
  };
  return list;
}

Outcome run_into(const std::string& command, const std::string& name, const std::string& input = "all.nc") {
  const std::string line = std::regex_replace(command, std::regex("all\\.nc"), input);
  return shell("export SOURCE_DATE_EPOCH=1; " + line + " --no-history > " + name);
}

// Names and values of everything; whatever order they stand in.
std::map<std::string, Values> contents(const Dataset& data) {
  std::map<std::string, Values> out;
  for (const Variable& v : data.variables) {
    out["variable " + v.name] = v.values;
    for (const Attribute& a : v.attributes) out["variable " + v.name + ":" + a.name] = a.values;
  }
  for (const Attribute& a : data.attributes) out["attribute " + a.name] = a.values;
  return out;
}

}  // namespace

// A contact at 2 N on a file that held the stress of 5 N kept von_mises and stress_max_von_mises: each tool
// had a list of its own of what to forget, of its own results alone.
TEST_CASE("nothing that rests on what a tool replaces survives it, and everything else does",
          "[lineage][contract]") {
  write_everything();
  const Dataset before = read_dataset("all.nc");
  for (const Case& c : cases()) {
    const Outcome run = run_into(c.command, "now.nc");
    CAPTURE(c.command, run.error);
    REQUIRE((run.exit == 0 || run.exit == 3));
    const Dataset now = read_dataset("now.nc");
    for (const Variable& v : before.variables) {
      if (is_coordinate(v)) continue;
      const std::string from = owner(v.name);
      CAPTURE(v.name, from);
      if (c.stale.contains(from) || (c.new_surface && from.empty() && stands_on_surface(v)))
        CHECK(!now.has(v.name));
      else if (!c.computed.contains(from)) {
        REQUIRE(now.has(v.name));
        CHECK(now.at(v.name).values == v.values);
      }
    }
    for (const Attribute& a : before.attributes) {
      if (is_of_the_run(a.name)) continue;
      const std::string from = owner(a.name);
      CAPTURE(a.name, from);
      const Values* there = now.attributes.find(a.name);
      if (c.stale.contains(from))
        CHECK(there == nullptr);
      else if (!c.computed.contains(from)) {
        REQUIRE(there != nullptr);
        CHECK(*there == a.values);
      }
    }
  }
}

TEST_CASE("what went is said in one line, which --quiet silences, and where nothing went none is",
          "[lineage][contract][slow]") {
  write_everything();
  const Dataset before = read_dataset("all.nc");
  for (const Case& c : cases()) {
    const Outcome run = run_into(c.command, "now.nc"), quiet = run_into(c.command + " --quiet", "now.nc");
    CAPTURE(c.command, run.error);
    const std::string start = c.tool() + ": dropped results of the former ";
    const bool any = !cli::Inventory(before).missing_in(read_dataset("now.nc")).empty();
    const std::size_t at = run.error.find(start);
    CHECK((at != run.error.npos) == any);
    CHECK((at == run.error.npos || run.error.find(start, at + 1) == run.error.npos));
    CHECK(quiet.error.find(start) == quiet.error.npos);
  }
  const Outcome pressed = run_into(cases().front().command, "now.nc");
  CHECK_THAT(
      pressed.error,
      ContainsSubstring("asperity-contact: dropped results of the former pressure: displacement_plastic, "
                        "heights_residual, stress_*\n"));
}

TEST_CASE("a second run of the same command leaves the dataset as the first left it, and says nothing",
          "[lineage][law][slow]") {
  write_everything();
  for (const Case& c : cases()) {
    // what is cut once more is another map, and a table is gone with the surface that it came from
    if (c.new_surface && c.command.find(" < ") == c.command.npos) continue;
    CAPTURE(c.command);
    run_into(c.command, "first.nc");
    const Outcome again = run_into(c.command, "second.nc", "first.nc");
    REQUIRE(again.exit == 0);
    CHECK(again.error.find("dropped") == again.error.npos);
    CHECK(contents(read_dataset("second.nc")) == contents(read_dataset("first.nc")));
  }
}

// The README's again.nc kept displacement_plastic of the first press beside the pressure of the second.
TEST_CASE("what is pressed stays, and the dataset says what was", "[lineage][contract]") {
  write_everything();
  const std::string press = "asperity-contact --load 2N" + bodies;
  REQUIRE(shell(press + "--yield 90MPa --add heights_residual all.nc -o one.nc && " + press +
                "--variable heights_residual one.nc -o again.nc && " + press + "again.nc -o heights.nc")
              .exit == 0);
  const Dataset one = read_dataset("one.nc"), again = read_dataset("again.nc"),
                last = read_dataset("heights.nc");
  CHECK(one.attributes.text("contact_variable") == "heights");
  CHECK(again.attributes.text("contact_variable") == "heights_residual");
  CHECK(again.at("heights_residual").values == one.at("heights_residual").values);
  CHECK(!again.has("displacement_plastic"));
  CHECK(!last.has("heights_residual"));
  REQUIRE(shell("asperity-generate --seed 3 < again.nc > drawn.nc").exit == 0);
  CHECK(!read_dataset("drawn.nc").has("heights_residual"));
  CHECK(!read_dataset("drawn.nc").has("pressure"));
}

TEST_CASE("an autocorrelation or a spectrum of the pressure goes with it, one of the heights does not",
          "[lineage][contract]") {
  write_everything();
  for (const std::string name : {"acf", "psd"})
    for (const std::string variable : {"pressure", "heights"}) {
      CAPTURE(name, variable);
      REQUIRE(shell("asperity-" + name + " --variable " + variable +
                    " all.nc -o m.nc && asperity-contact --load 2N m.nc -o p.nc" + bodies)
                  .exit == 0);
      CHECK(read_dataset("m.nc").attributes.text(name + "_variable") == variable);
      CHECK(read_dataset("p.nc").has(name) == (variable == "heights"));
    }
}

TEST_CASE("an autocorrelation of the surface that is pressed stays, unless the press leaves another one",
          "[lineage][contract]") {
  write_everything();
  const std::string press = "asperity-contact --load 2N --variable heights_residual m.nc -o p.nc" + bodies;
  REQUIRE(shell("asperity-acf --variable heights_residual all.nc -o m.nc && " + press).exit == 0);
  CHECK(read_dataset("p.nc").has("acf"));
  REQUIRE(shell(press + "--yield 90MPa --add heights_residual").exit == 0);
  const Dataset pressed = read_dataset("p.nc");
  CHECK(!pressed.has("acf"));
  const Field before = field_of(read_dataset("m.nc"), "heights_residual"),
              flattened = field_of(pressed, "displacement_plastic");
  CHECK((field_of(pressed, "heights_residual") == before - flattened).all());
}

TEST_CASE("each dataset of a sweep is one case, and what went is said once", "[lineage][contract]") {
  write_everything();
  const Outcome run = shell("asperity-contact all.nc --sweep 1N,2N --each press-%d.nc" + bodies);
  INFO(run.error);
  REQUIRE(run.exit == 0);
  const std::size_t said = run.error.find("dropped");
  CHECK(said != run.error.npos);
  CHECK(run.error.find("dropped", said + 1) == run.error.npos);
  for (const char* name : {"press-1.nc", "press-2.nc"}) {
    CHECK(!read_dataset(name).has("von_mises"));
    CHECK(!read_dataset(name).attributes.find("stress_max_von_mises"));
  }
}

TEST_CASE("a report on a surface that was pressed anew shows no stress of the former contact",
          "[lineage][contract][slow]") {
  write_everything();
  const Outcome run = shell("asperity-contact -q all.nc --load 2N" + bodies + "| asperity-report");
  REQUIRE(run.exit == 0);
  CHECK(run.out.find("von Mises") == run.out.npos);
  CHECK(shell("asperity-report all.nc").out.find("von Mises") != run.out.npos);
}

TEST_CASE("a user's volume stays at its depths, and goes when there are others", "[lineage][contract]") {
  write_everything();
  for (const auto& [depths, stays] :
       {std::pair("0:50um:3", true), std::pair("0:60um:3", false), std::pair("0:50um:4", false)}) {
    const Outcome run = shell(std::string("asperity-stress all.nc -o deep.nc --depths ") + depths);
    CAPTURE(depths, run.error);
    REQUIRE(run.exit == 0);
    CHECK(read_dataset("deep.nc").has("own_depths") == stays);
    CHECK((run.error.find("own_depths") == run.error.npos) == stays);
  }
}

TEST_CASE("a map that is cut keeps what is not of the surface, its history too", "[lineage][contract]") {
  write_everything();
  REQUIRE(shell("asperity-filter all.nc --decimate 2x2 -o cut.nc").exit == 0);
  const Dataset cut = read_dataset("cut.nc");
  CHECK(cut.attributes.text("operator") == "a person");
  CHECK(cut.has("own_number"));
  CHECK(!cut.has("own_field"));
  CHECK_THAT(cut.attributes.text("history"), ContainsSubstring("asperity-generate"));
  CHECK(grid_of(cut).shape == Shape{8, 6});
}

// ---- the table of what the tools write: it names whatever they do, and the documentation nothing else ----

TEST_CASE("the table names whatever the tools write", "[lineage][contract][slow]") {
  const std::string draw = "asperity-generate --shape 16x12 --size 1.6mm,1.2mm --rq 0.4um --seed 7 ";
  const std::string commands[] = {
      draw + "--length 3px --add noise --skewness 0.5 --kurtosis 4",
      draw + "--length 3px --method filter --skewness 0.3 --kurtosis 3.5",
      draw + "--length 3px --model matern",
      draw + "--length 3px --model self-affine",
      draw + "--length 3px --model stretched-exponential --exponent 1.5",
      draw + "--length 3px --model exponential-cosine --wavelength 6px",
      draw +
          "--length 3px | asperity-acf --add structure_function,acf_quantiles --direction 30deg --max-lag "
          "5x5",
      draw +
          "--length 3px | asperity-acf --add acf_quantiles | asperity-kernel --acf - --infeasible nearest "
          "--marginal measured",
      draw + "--length 3px | asperity-filter --remove-form plane",
      draw + "--length 3px | asperity-psd",
      draw +
          "--length 3px -o d.nc && asperity-contact d.nc --counter d.nc --load 5N --yield 100MPa --add "
          "heights_residual,contact_ratios,elastic_energy,patches" +
          bodies,
      "asperity-contact d.nc --approach 0.2um" + bodies +
          " | asperity-stress --depths 0:50um:3 --maximum "
          "--components all,principal_directions --friction 0.2 --above 0.1p0",
      "asperity-contact --smooth --shape 16x16 --size 3mm --load 5N" + bodies +
          " | asperity-stress --depths 0,10um --section x=0",
  };
  for (const std::string& command : commands) {
    const Outcome run = shell(command + " > named.nc");
    CAPTURE(command, run.error);
    REQUIRE((run.exit == 0 || run.exit == 3));
    const Dataset data = read_dataset("named.nc");
    for (const Variable& v : data.variables) {
      CAPTURE(v.name);
      CHECK((is_coordinate(v) || !owner(v.name).empty()));
    }
    for (const Attribute& a : data.attributes) {
      CAPTURE(a.name);
      CHECK((is_of_the_run(a.name) || !owner(a.name).empty()));
    }
  }
}

// A name that some run may write and no run above did.
TEST_CASE("the table lists every name under a tool's prefix that stands in a source of the tools",
          "[lineage][contract]") {
  const std::regex name("\"((kernel|generate|filter|contact|stress|acf|psd)_[a-z0-9_]*[a-z0-9])\"");
  int found = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ASPERITY_TEST_DATA "/../../tools")) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
    std::ifstream in(entry.path());
    const std::string text(std::istreambuf_iterator<char>(in), {});
    for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at) {
      if ((*at)[1] == "contact_ratios") continue;  // a word of --add
      CAPTURE(entry.path(), (*at)[1].str());
      CHECK(!owner((*at)[1].str()).empty());
      ++found;
    }
  }
  CHECK(found >= 100);
}

TEST_CASE("no name belongs to two results, and each rests on results", "[lineage][exact]") {
  Words variables, attributes, results;
  const auto once = [](Words& seen, std::string_view name) {
    CAPTURE(name);
    CHECK(seen.insert(std::string(name)).second);
  };
  for (const KnownResult& r : known_results()) {
    std::istringstream bases{std::string(r.rests_on)};
    for (std::string base; bases >> base;) CHECK(results.contains(base));
    once(results, r.name);
    std::istringstream own{std::string(r.variables)};
    for (std::string name; own >> name;) {
      once(variables, name);
      CHECK(result_of_variable(name) == &r);
    }
  }
  for (const KnownAttribute& a : known_attributes()) {
    once(attributes, a.name);
    CHECK(!variables.contains(std::string(a.name)));
    CHECK(a.name.starts_with(result_of_attribute(a.name)->prefix));
  }
}

TEST_CASE(
    "docs/dataset.md names variables and attributes of the table alone, and infinite ones that may be so",
    "[lineage][contract]") {
  std::ifstream in(ASPERITY_TEST_DATA "/../../docs/dataset.md");
  const std::regex quoted("`([A-Za-z_]+)[^`]*`"),
      attribute("(kernel|generate|filter|contact|stress|acf|psd)_[a-z_]+[a-z]");
  const Words coordinates{"x", "y", "z", "p", "q"};
  bool open = false;
  int found = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) open = false;
    open = open || line.find("may be infinite") != line.npos;
    const bool row = line.starts_with("| `");
    const std::string cell = row ? line.substr(0, line.find('|', 1)) : line;
    for (std::sregex_iterator at(cell.begin(), cell.end(), quoted), end; at != end; ++at) {
      const std::string name = (*at)[1];
      CAPTURE(line, name);
      if (!row && !std::regex_match(name, attribute)) continue;
      if (row && coordinates.contains(name)) continue;
      ++found;
      CHECK(!owner(name).empty());
      if (const KnownAttribute* known = known_attribute(name); open && known) CHECK(known->open);
    }
  }
  CHECK(found >= 40);
}
