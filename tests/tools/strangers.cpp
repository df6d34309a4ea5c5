// What strangers found in the tools as they are typed: one test for each fault.
#include <fstream>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/maps.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string steel = " --young 208GPa --poisson 0.3";
const std::string draw =
    "asperity-generate --shape 24x20 --size 24um,20um --rq 0.1um --length 3um --seed 1 -q ";

void refused(const std::string& line, int code, const std::string& words) {
  const Outcome run = shell(line);
  CAPTURE(line, run.error);
  CHECK(run.exit == code);
  CHECK(lines(run.error) == 1);
  CHECK_THAT(run.error, ContainsSubstring(words));
}

}  // namespace

TEST_CASE("an ensemble takes the place neither of what it is drawn from nor of its own members",
          "[strangers][outputs][contract]") {
  REQUIRE(
      shell(draw + "-o s_1.nc; cp s_1.nc kept.nc; asperity-kernel --length 3px -o k_0.nc; ln -s t1.nc t0.nc")
          .exit == 0);
  refused(
      "asperity-generate --marginal s_1.nc --length 3px --rq 1um --size 1mm --shape 24x20 --seed 1 --count 2 "
      "-o s_%d.nc",
      2, "'s_1.nc' is an input of this run");
  refused("asperity-generate --kernel k_0.nc --rq 1um --size 1mm --shape 24x20 --seed 1 --count 2 -o k_%d.nc",
          2, "'k_0.nc' is an input of this run");
  refused(draw + "--count 2 -o t%d.nc", 2, "'t1.nc' is the file of --count too");
  CHECK(shell("cmp s_1.nc kept.nc").exit == 0);
}

TEST_CASE("a file of options is not written over", "[strangers][outputs][contract]") {
  REQUIRE(shell("echo 'remove-form = \"plane\"' > options.txt; " + draw + "-o g.nc").exit == 0);
  refused("asperity-stats --config options.txt g.nc -o options.txt", 2,
          "'options.txt' is an input of this run");
  REQUIRE(shell("echo 'seed = 3' > seed.json").exit == 0);
  refused(
      "asperity-generate --shape 8x8 --size 1mm --rq 1um --length 3px -o h.nc --report seed.json --config "
      "seed.json",
      2, "--report: 'seed.json' is an input of this run");
}

TEST_CASE("ASPERITY_STATS_CONFIG names a file of options as --config does", "[strangers][config][contract]") {
  REQUIRE(shell("echo 'remove-form = \"plane\"' > plane.toml; " + draw + "-o g.nc").exit == 0);
  const Outcome by_option = shell("asperity-stats g.nc --config plane.toml"),
                by_variable = shell("ASPERITY_STATS_CONFIG=plane.toml asperity-stats g.nc");
  CHECK(by_option.out == by_variable.out);
  CHECK(by_option.out != shell("asperity-stats g.nc").out);
  refused("ASPERITY_STATS_CONFIG=absent.toml asperity-stats g.nc", 2,
          "ASPERITY_STATS_CONFIG: 'absent.toml' cannot be read");
  refused("ASPERITY_STATS_CONFIG= asperity-stats g.nc", 2, "is empty");
}

TEST_CASE("texts that look like numbers come back from --dump-config as they were",
          "[strangers][config][law]") {
  for (const std::string title : {"1.50", "1e5", "20251231235959999999", "a\rb", "tab\there"}) {
    std::ofstream(scratch("title.txt"), std::ios::binary) << title;
    const Outcome run = shell(
        "asperity-plot g.nc --kind map -o p.svg --title \"$(cat title.txt)\" --dump-config > d.toml && "
        "asperity-plot --config d.toml --dump-config | cmp - d.toml");
    CAPTURE(title, run.error);
    CHECK(run.exit == 0);
  }
}

TEST_CASE("a row that was cut from a surface does not keep the width of the whole", "[strangers][contract]") {
  Dataset data;
  set_grid(data, {{16, 1}, 1e-6, 72e-6});
  set_field(data, "heights", 1e-7 * random_field({16, 1}, 1), {"m", "height"});
  write_dataset(data, "row.nc");
  CHECK(shell("asperity-stats row.nc -q").exit == 0);
  data.find("y")->attributes.set_values("actual_range", Values(std::vector<double>{-3.45e-5, 3.45e-5}));
  write_dataset(data, "row.nc");
  refused("asperity-stats row.nc -q", 4, "y: only one point is left of those in actual_range");
}

TEST_CASE(
    "a kernel and its tables are read as they are meant, transposed too, or refused where they were changed",
    "[strangers][kernel][contract]") {
  REQUIRE(shell("asperity-kernel --length 2um,3um --spacing 1um --rq 0.1um -o k.nc").exit == 0);
  const std::string use = "asperity-generate --shape 24x20 --seed 1 -q --no-history --kernel ";
  const Dataset kernel = read_dataset("k.nc");
  Dataset turned = kernel;
  Variable& values = *turned.find("kernel");
  const Field across = table_of(kernel, "kernel").transpose();
  values.dimensions = {"l", "k"};
  values.values = std::vector<double>(across.data(), across.data() + across.size());
  write_dataset(turned, "turned.nc");
  REQUIRE(shell(use + "k.nc -o a.nc; " + use + "turned.nc -o b.nc").exit == 0);
  CHECK((field_of(read_dataset("a.nc"), "heights") == field_of(read_dataset("b.nc"), "heights")).all());

  Dataset doubled = kernel;
  for (double& v : std::get<std::vector<double>>(doubled.find("kernel")->values)) v *= 2;
  write_dataset(doubled, "doubled.nc");
  refused(use + "doubled.nc -o c.nc", 4, "kernel: the sum of its squares, ");
  Dataset half = kernel;
  half.erase("p");
  write_dataset(half, "half.nc");
  refused("asperity-generate --acf half.nc --shape 24x20 --size 24um,20um --seed 1 -q -o c.nc", 4,
          "have no coordinate");
}

TEST_CASE("Poisson's ratio of a dataset is a number or two", "[strangers][stress][contract]") {
  REQUIRE(shell("asperity-contact --smooth --shape 16x16 --size 3mm --radius 50mm --young 200GPa --poisson "
                "0.3 --load 1kN "
                "-q -o p.nc")
              .exit == 0);
  for (const Values& wrong : {Values(std::string("abc")), Values(std::vector<double>{0.3, 0.3, 0.3})}) {
    Dataset data = read_dataset("p.nc");
    data.attributes.set_values("contact_poisson", wrong);
    write_dataset(data, "q.nc");
    refused("asperity-stress q.nc --depths 0:0.1mm:3 -q -o s.nc", 4,
            "contact_poisson: it must be one number");
  }
}

// The standard errors and the bias of Sku were those of heights about a mean that is known: refused by 8 of 8
// seeds.
TEST_CASE("periodic surfaces whose correlation is as long as they are have the kurtosis prescribed",
          "[strangers][validate][statistics][slow]") {
  for (int seed = 1; seed <= 4; ++seed) {
    const Outcome run =
        shell("asperity-generate --shape 48x48 --size 48um --rq 1um --periodic --length 30px --seed " +
              std::to_string(seed) + " --count 60 -q -o 'v_%02d.nc' && asperity-validate -q v_*.nc");
    CAPTURE(seed, run.out, run.error);
    CHECK(run.exit == 0);
  }
}

// The surfaces that they are compared with lose the same to their means: 8 of 8 ensembles were found to differ
// in their kurtosis.
TEST_CASE("skewed surfaces whose mean takes much of the variance are not found to differ",
          "[strangers][validate][contract]") {
  const std::string skewed =
      "asperity-generate --shape 64x64 --size 64um --rq 1um --skewness -1 --seed 1 -q --count ";
  REQUIRE(
      shell(skewed + "3 --length 20px --periodic -o 'w_%d.nc'; " + skewed + "12 --length 6px -o 'u_%d.nc'")
          .exit == 0);
  CHECK(shell("asperity-validate -q w_*.nc").exit == 0);
  CHECK(shell("asperity-validate -q u_*.nc").exit == 0);
}

// It printed no row and said to increase --max-lag.
TEST_CASE("asperity-acf says that holes like a checkerboard's leave no lengths",
          "[strangers][acf][contract]") {
  const Outcome run = shell(
      "for i in $(seq 24); do for j in $(seq 24); do [ $(((i + j) % 2)) = 0 ] && printf \"$((i * j % 7)) \" "
      "|| "
      "printf 'nan '; done; echo; done > checkerboard.txt; asperity-convert checkerboard.txt --size 24um "
      "--unit "
      "um -o checkerboard.nc && asperity-acf --result lengths checkerboard.nc");
  CAPTURE(run.out, run.error);
  CHECK(run.exit == 0);
  CHECK_THAT(run.error, ContainsSubstring("no two neighbouring points are both measured"));
  CHECK_THAT(run.error, !ContainsSubstring("--max-lag"));
}

// A map in a wrong unit, and one that was never levelled, got advice to measure a larger field, or nothing.
TEST_CASE(
    "heights too high for their length are told once by each tool that reads or draws them, not with -q",
    "[strangers][contract]") {
  const std::string high = "asperity-generate --shape 32x32 --size 1mm --rq 0.4mm --length 6px --seed 1 ";
  require(high + "-q -o high.nc; asperity-convert high.nc -q -o high.sdf");
  for (const std::string& line :
       {high + "-o again.nc", high + "--count 3 -o again_%d.nc", std::string("asperity-stats high.nc"),
        std::string("asperity-pdf high.nc"), std::string("asperity-psd high.nc --result radial"),
        std::string("asperity-convert high.sdf -o high.gsf"),
        std::string("asperity-filter high.nc --mirror x -o turned.nc"),
        "asperity-contact high.nc --approach 1um -o c.nc --radius 1mm" + steel}) {
    const Outcome run = shell(line), quiet = shell(line + " -q");
    CAPTURE(line, run.error);
    const std::size_t told = run.error.find("check the units of heights and lengths");
    CHECK(told != std::string::npos);
    CHECK(run.error.find("check the units", told + 10) == std::string::npos);
    CHECK(quiet.error.find("check the units") == std::string::npos);
  }
  CHECK(shell(draw + "-o plausible.nc; asperity-stats plausible.nc").error.find("units") ==
        std::string::npos);
}

TEST_CASE("of heights that are a tilt, the tilt is told before any advice to measure more",
          "[strangers][contract]") {
  const Grid g{{64, 48}, 1e-6, 1e-6};
  const Field tilted =
      20e-9 * random_field(g.shape, 1) + sample(g, [](double x, double) { return 0.05 * x; });
  write_map(tilted, g, "tilt.nc");
  for (const std::string& line :
       {std::string("asperity-stats tilt.nc"), std::string("asperity-acf tilt.nc --result lengths"),
        "asperity-contact tilt.nc --load 1mN -o c.nc" + steel}) {
    const Outcome run = shell(line);
    CAPTURE(line, run.error);
    const std::size_t tilt = run.error.find("a plane makes up 99.9"),
                      more = run.error.find("measure a larger field");
    CHECK(tilt < run.error.size());
    CHECK(tilt < more);
    CHECK_THAT(run.error, ContainsSubstring("--remove-form plane"));
  }
  CHECK(shell("asperity-stats tilt.nc --remove-form plane").error.find("a plane") == std::string::npos);
}
