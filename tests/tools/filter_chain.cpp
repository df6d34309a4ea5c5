// asperity-filter: the order of its steps, where they come from, what the dataset keeps, several maps, memory.
#include <nlohmann/json.hpp>

#include "stats/filter/form.hpp"
#include "tools/maps.hpp"

using namespace asperity;
using namespace asperity::test;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

const std::string draw =
    "asperity-generate -q --shape 96x64 --size 96um,64um --rq 0.4um --length 6px --seed 7 -o drawn.nc; "
    "asperity-convert drawn.nc --no-history -o drawn.gsf && asperity-convert drawn.gsf -o map.nc;";

using Json = nlohmann::json;

// Every number of two answers within a share of itself.
void check_equal(const Json& one, const Json& other, double share) {
  if (one.is_number() && other.is_number()) {
    CHECK(std::abs(one.get<double>() - other.get<double>()) <= share * std::abs(one.get<double>()));
  } else if (one.is_structured() && one.size() == other.size()) {
    for (auto at = one.begin(), its = other.begin(); at != one.end(); ++at, ++its)
      check_equal(*at, *its, share);
  } else {
    CHECK(one == other);
  }
}

}  // namespace

// A crop of a levelled map is tilted again, by a correlated surface.
TEST_CASE("steps run in the order of the command line, and one may come again", "[filter][law]") {
  require(draw);
  const Field z = heights_in("map.nc");
  const auto part = [](const Field& field) -> Field { return field.topRows(20); };
  require("asperity-filter -q map.nc --crop 0:20,: --remove-form plane -o first.nc");
  require("asperity-filter -q map.nc --remove-form plane --crop 0:20,: -o last.nc");
  require("asperity-filter -q map.nc --remove-form plane --crop 0:20,: --remove-form plane -o both.nc");
  CHECK(same_bits(heights_in("first.nc"), remove_form(part(z), 1)));
  CHECK(same_bits(heights_in("last.nc"), part(remove_form(z, 1))));
  CHECK((heights_in("first.nc") - heights_in("last.nc")).abs().maxCoeff() > 1e-8);
  CHECK((heights_in("first.nc") - heights_in("both.nc")).abs().maxCoeff() <= 1e3 * epsilon * 1e-6);
}

TEST_CASE("the same command gives the same bytes, and a second level changes round-off alone",
          "[filter][law]") {
  require(draw +
          "export SOURCE_DATE_EPOCH=1; for n in 1 2; do asperity-filter -q map.nc --remove-form 2 --lambda-c "
          "40um --threads $n --no-history > $n.nc; done; cmp 1.nc 2.nc");
  require(
      "asperity-filter -q map.nc --remove-form 3 | asperity-filter -q --remove-form 3 -o twice.nc; "
      "asperity-filter -q map.nc --remove-form 3 -o once.nc");
  CHECK_THAT(last_run("twice.nc"), ContainsSubstring("remove-form 3: removed nothing but round-off; "));
  CHECK((heights_in("twice.nc") - heights_in("once.nc")).abs().maxCoeff() <= 1e3 * epsilon * 1e-6);
}

// What is measured is what is written: one code for both. Errors too, for the dataset knows the form's degree.
// Ends of intervals are roots, found to some 1e-8 of themselves.
TEST_CASE("a filtered map measures as the raw one does with the same options, to round-off",
          "[filter][law][slow]") {
  require(draw);
  for (const char* steps :
       {"--remove-form plane", "--remove-form 3", "--remove-form plane --lambda-s 4um",
        "--remove-form plane --lambda-s 4um --lambda-c 40um", "--lambda-s 4um,spline --lambda-c 40um,robust",
        "--remove-form 2 --lambda-c 30um"}) {
    CAPTURE(steps);
    const std::string measure = " --errors theory --parameters height,material,hybrid,spatial --json ";
    Json raw = Json::parse(require("asperity-stats -q map.nc" + measure + steps).out);
    Json written = Json::parse(
        require("asperity-filter -q map.nc " + std::string(steps) + " | asperity-stats -q" + measure).out);
    raw.erase("mean"), written.erase("mean");  // that of the form
    check_equal(raw, written, 1e-7);
  }
}

TEST_CASE("history has the command, and a line for each step in its order", "[filter][contract]") {
  require(draw + "asperity-filter map.nc --remove-form plane --crop :32,: -o out.nc");
  const std::string told = last_run("out.nc");
  CHECK_THAT(told,
             ContainsSubstring("Z: asperity-filter map.nc --remove-form plane --crop :32,: -o out.nc\n  1. "
                               "remove-form plane: removed "));
  CHECK_THAT(told, EndsWith("\n  2. crop :32,:: now 32x64 cells on 32um x 64um"));
  CHECK_THAT(read_dataset("out.nc").attributes.text("history"),
             ContainsSubstring("asperity-convert drawn.gsf"));
  const Outcome verbose = require("asperity-filter -v map.nc --scale 2 --no-history -o out.nc");
  CHECK(verbose.error == "1. scale 2: multiplied by 2\n");
  CHECK_THAT(last_run("out.nc"), ContainsSubstring("asperity-convert"));
}

TEST_CASE("steps of a file or a variable keep their order, and those of the command line replace them",
          "[filter][config][contract]") {
  require(draw);
  const std::string steps = "--remove-form plane --scale -2 --remove-form 2 --crop 1:9,:",
                    last = " --no-history -o ";
  require("asperity-filter -q map.nc " + steps + last + "typed.nc");
  require("asperity-filter " + steps + " --dump-config > o.toml; asperity-filter -q --config o.toml map.nc" +
          last + "file.nc; ASPERITY_FILTER_STEPS='" + steps + "' asperity-filter -q map.nc" + last +
          "variable.nc; cmp typed.nc file.nc && cmp typed.nc variable.nc");
  CHECK_THAT(shell("grep steps o.toml").out, EndsWith("steps = \"" + steps + "\"\n"));
  require("asperity-filter -q --config o.toml map.nc --scale 3" + last + "scaled.nc");
  CHECK(same_bits(heights_in("scaled.nc"), 3 * heights_in("map.nc")));
  const std::pair<const char*, const char*> refused[] = {
      {"echo 'scale = 2' > s.toml; asperity-filter map.nc --config s.toml",
       "asperity-filter: s.toml: scale: is a step"},
      {"ASPERITY_FILTER_SCALE=2 asperity-filter map.nc",
       "asperity-filter: ASPERITY_FILTER_SCALE is a step, and its place among others is not known: set "
       "ASPERITY_FILTER_STEPS"},
      {"asperity-filter map.nc --steps '--scale 2' --mirror x",
       "asperity-filter: --steps cannot be combined with"},
      {"asperity-filter map.nc --steps '--level 2'", "asperity-filter: --steps: '--level' is no step"},
      {"asperity-filter map.nc --steps '--scale'", "asperity-filter: --steps: '--scale' needs a value"},
      {"ASPERITY_FILTER_STEPS='--scale 0' asperity-filter map.nc",
       "asperity-filter: ASPERITY_FILTER_STEPS: scale: '0' is not"},
  };
  for (const auto& [line, expected] : refused) {
    const Outcome run = shell(std::string(line) + " -o no.nc");
    CAPTURE(line, run.error);
    CHECK(run.exit == 2);
    CHECK_THAT(run.error, StartsWith(expected));
    CHECK(lines(run.error) == 1);
  }
}

// A value that is in the way stays; each map has its place in the pattern.
TEST_CASE("several maps are written by a pattern, and one that fails keeps the others",
          "[filter][contract]") {
  require(draw + "cp map.nc b.nc; printf '1 2\\n3 word\\n' > a.txt");
  const Outcome run = shell("asperity-filter a.txt b.nc map.nc --scale 2 -o f_%d.nc");
  CHECK(run.exit == 4);
  CHECK_THAT(run.error, ContainsSubstring("asperity-filter: warning: a.txt: "));
  CHECK(shell("ls f_*.nc").out == "f_2.nc\nf_3.nc\n");
  CHECK(same_bits(heights_in("f_3.nc"), 2 * heights_in("map.nc")));
  require("ls b.nc map.nc | asperity-filter -q --files-from - --scale 2 -o g_%d.nc");
  CHECK(same_bits(heights_in("g_2.nc"), heights_in("f_3.nc")));
  CHECK(shell("asperity-filter b.nc map.nc --scale 2 -o one.nc").exit == 2);
  require("asperity-filter map.nc --scale 2 -o only_%02d.nc");
  CHECK(same_bits(heights_in("only_01.nc"), heights_in("f_3.nc")));
  require("asperity-filter map.nc --crop 0:3,0:3 -o small.nc");
  const Outcome small = shell("asperity-filter small.nc map.nc --lambda-s 6um -o s_%d.nc");
  CHECK(small.exit == 2);
  CHECK_THAT(small.error, ContainsSubstring("small.nc: --lambda-s: "));
  CHECK(shell("ls s_*.nc").out == "s_2.nc\n");
  const Outcome over = shell("cp b.nc h_2.nc; asperity-filter map.nc h_2.nc --scale 2 -o h_%d.nc; ls h_1.nc");
  CHECK_THAT(over.error, ContainsSubstring("is an input of this run"));
  CHECK_THAT(over.error, ContainsSubstring("h_1.nc"));
  CHECK(same_bits(heights_in("h_2.nc"), heights_in("b.nc")));
}

TEST_CASE("a map larger than memory is refused in one line with what it needs", "[filter][contract]") {
  write_map(random_field({1100, 1000}, 1), {{1100, 1000}, 1e-6, 1e-6}, "large.nc");
  const Outcome run = shell("asperity-filter large.nc --decimate 2x2 --memory 16MB -o no.nc");
  CHECK(run.exit == 4);
  CHECK(run.error ==
        "asperity-filter: large.nc: dataset: reading needs 18MB, the memory limit is 17MB: raise --memory\n");
  require("asperity-filter -q large.nc --decimate 2x2 --memory 64MB -o small.nc");
}

// Errors of a variable that became the map were 14 times too small for the form of the heights, and a form of the
// whole stood for a part of it.
TEST_CASE("what a map has lost stays with it: a form, by its share, and measured points",
          "[filter][contract]") {
  require(draw);
  const auto number = [](const std::string& file, const std::string& name) {
    return read_dataset(file).attributes.number(name, 0);
  };
  require("asperity-filter -q map.nc --remove-form 6 -o form.nc");
  Dataset data = read_dataset("form.nc");
  set_field(data, "other", random_field({96, 64}, 1), {"V", "other"});
  write_dataset(data, "form.nc");
  require("asperity-filter -q form.nc --variable other --scale 2 -o other.nc");
  CHECK(number("form.nc", "filter_form_degree") == 6);
  CHECK(number("other.nc", "filter_form_degree") == 0);
  require(
      "asperity-convert -q form.nc --variable other -o other.nc; asperity-convert -q form.nc --size 1mm -o "
      "large.nc");
  CHECK(number("other.nc", "filter_form_degree") == 0);
  CHECK(number("large.nc", "filter_form_degree") == 6);
  for (const std::string memory : {"", " --memory 200kB"}) {
    require("asperity-filter -q form.nc --crop 0:48,0:32" + memory + " -o part.nc");
    CHECK(number("part.nc", "filter_form_degree") == 2);
  }
  require("asperity-filter -q form.nc --lambda-c 8um -o short.nc");
  CHECK(number("short.nc", "filter_form_degree") == 0);
  // Filled points.
  Field z = heights_in("map.nc");
  z.block(3, 4, 8, 12).setConstant(NAN);
  write_map(z, {{96, 64}, 1e-6, 1e-6}, "holes.nc");
  require(
      "asperity-filter -q holes.nc --fill laplace --scale 2 -o filled.nc; asperity-filter -q filled.nc "
      "--scale 2 --memory 200kB -o again.nc");
  for (const char* file : {"filled.nc", "again.nc"}) {
    CHECK(number(file, "filter_filled_share") == 1.0 / 64);
    const Outcome run = require(std::string("asperity-stats --errors theory ") + file);
    CHECK_THAT(run.error,
               ContainsSubstring("1.6 % of the points were filled; errors take them for measured"));
  }
}

// Both take more than the map that they make or are made of: 2900 x 2900 points, 4096 x 16384 between two steps.
TEST_CASE("a step that would take more than memory is refused before it", "[filter][contract]") {
  write_map(random_field({4096, 4}, 1), {{4096, 4}, 1e-6, 1e-6}, "long.nc");
  for (const std::string step : {"--rotate 45deg", "--spacing 2048um,0.000244140625um"}) {
    const Outcome run = shell("asperity-filter long.nc --memory 100MB -o no.nc " + step);
    CAPTURE(step, run.error);
    CHECK(run.exit == 2);
    CHECK_THAT(run.error, StartsWith("asperity-filter: " + step.substr(0, step.find(' '))) &&
                              ContainsSubstring("points needs some"));
  }
}

TEST_CASE("a field besides heights becomes the map, in its unit, and results of the former one are dropped",
          "[filter][contract]") {
  require(
      "asperity-generate -q --shape 32x32 --size 1mm --rq 0.4um --length 6px --seed 7 | asperity-contact -q "
      "--load 5N "
      "--radius 10mm --young 208GPa --poisson 0.3 -o c.nc");
  const Outcome run = require("asperity-filter c.nc --variable pressure --crop 4:28,: -o p.nc");
  CHECK_THAT(run.error, ContainsSubstring("dropped results of the former map"));
  const Dataset p = read_dataset("p.nc");
  CHECK(p.at("values").attributes.text("units") == "Pa");
  CHECK_FALSE((p.has("pressure") || p.has("heights") || p.attributes.find("contact_load")));
  require("asperity-filter -q c.nc --remove-form plane -o l.nc");
  CHECK_FALSE(read_dataset("l.nc").has("acf_target"));
}
