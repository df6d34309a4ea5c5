// The table of what the tools write: it names whatever they do, and the documentation nothing else.
#include "dataset/catalogue.hpp"

#include <filesystem>
#include <regex>
#include <sstream>

#include "tools/results.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

bool is_of_the_run(const std::string& name) {
  return name == "history" || name == "source" || name == "Conventions";
}

}  // namespace

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
