// What asperity-stress is asked for and no more: layers, sections, points, the maximum, values above a bound.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/stress_runs.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE(
    "depths of --depths are a list, or a range at equal steps or at equal ratios, px half the shorter side "
    "of a cell",
    "[stress][contract]") {
  auto depths = [](const std::string& text) { return depths_of(below("--components zz --depths " + text)); };
  const double cell = 3e-3 / 64;
  const std::vector<double> listed = depths("0,10um,0.5mm");
  REQUIRE(listed.size() == 3);
  CHECK(listed[0] == 0);
  CHECK(relative_error(listed[1], 1e-5) <= 4 * epsilon);
  CHECK(relative_error(listed[2], 5e-4) <= 4 * epsilon);
  const std::vector<double> uniform = depths("0:1mm:5"), geometric = depths("0.5px:1mm:4:geometric");
  REQUIRE(uniform.size() == 5);
  REQUIRE(geometric.size() == 4);
  for (std::size_t k = 0; k < 5; ++k)
    CHECK(uniform[k] == Approx(0.25e-3 * static_cast<double>(k)).epsilon(4 * epsilon));
  for (std::size_t k = 0; k < 4; ++k)
    CHECK(geometric[k] ==
          Approx(0.5 * cell * std::pow(2e-3 / cell, static_cast<double>(k) / 3)).epsilon(16 * epsilon));
  CHECK(geometric.back() == 1e-3);
}

// The volume's rows come from an inverse transform, the section's from sums over the lags: round-off of 16 ε
// Σ|p|, at most 16 ε of the cells times the maximum pressure.
TEST_CASE("a section is the volume's values in its plane, at the cell centres nearest to it",
          "[stress][exact]") {
  const std::string layers = "--depths 0,20um,0.2mm,0.7mm --components all --resolution full ";
  const Dataset volume = below(layers);
  const Grid grid = grid_of(volume);
  const double bound =
      16 * epsilon * static_cast<double>(grid.shape.cells()) * field_of(volume, "pressure").maxCoeff();
  struct Cut {
    std::string option;
    bool along_x;
    Index index;
  };
  for (const Cut& cut : {Cut{"y=0", true, 24}, Cut{"y=-1.2mm", true, 0}, Cut{"x=0.31mm", false, 38},
                         Cut{"x=1.5mm", false, 63}}) {
    const Dataset section = below(layers + "--section " + cut.option);
    const double place = values(volume, cut.along_x ? "y" : "x")[static_cast<std::size_t>(cut.index)];
    CHECK(values(section, cut.along_x ? "section_y" : "section_x")[0] == place);
    CHECK(section.attributes.number(cut.along_x ? "stress_section_y" : "stress_section_x", 9) == place);
    for (const char* name :
         {"von_mises", "stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_xz", "stress_yz"}) {
      const std::vector<double> whole = values(volume, name), part = values(section, name);
      CHECK(section.at(name).dimensions == std::vector<std::string>{"z", cut.along_x ? "x" : "y"});
      const Index n = cut.along_x ? grid.shape.nx : grid.shape.ny;
      REQUIRE(part.size() == static_cast<std::size_t>(4 * n));
      double error = 0;
      for (Index l = 0; l < 4; ++l)
        for (Index k = 0; k < n; ++k) {
          const Index i = cut.along_x ? k : cut.index, j = cut.along_x ? cut.index : k;
          error = std::max(
              error, std::abs(part[static_cast<std::size_t>(l * n + k)] -
                              whole[static_cast<std::size_t>((l * grid.shape.nx + i) * grid.shape.ny + j)]));
        }
      CAPTURE(cut.option, name);
      CHECK(error <= 4 * bound);
    }
  }
}

// The points were those below one period alone: -175 MPa in place of -500. Sums over the
// modes in two orders: n ε of the maximum pressure each (stress/points.hpp), 48 cells to a side.
TEST_CASE("asperity-stress --maximum leaves its place and no volume, and the same place as beside a volume",
          "[stress][contract]") {
  const Dataset alone = below("--maximum"), beside = below("--maximum --depths 0,1mm");
  CHECK_FALSE(alone.has("von_mises"));
  CHECK_FALSE(alone.has("z"));
  for (const char* name : {"stress_max_von_mises", "stress_max_x", "stress_max_y", "stress_max_depth"})
    CHECK(alone.attributes.number(name, -1) == beside.attributes.number(name, -2));
  const std::vector<double> near =
      values(below("--depths " + std::to_string(alone.attributes.number("stress_max_depth", 0) * 1e6) + "um"),
             "von_mises");
  CHECK(relative_error(alone.attributes.number("stress_max_von_mises", 0), largest(near)) <= 0.02);
  CHECK(below("--depths 0").attributes.find("stress_max_x") == nullptr);
}

// On the axis of a Hertz contact the largest shear stress is half of von Mises, but for the parabolas between
// the cell centres, 2e-6 here; the tension lies beside it.
TEST_CASE(
    "the maximum of another stress, and below a depth, has its own name, and drops that of a former run",
    "[stress][contract]") {
  REQUIRE(
      shell("asperity-contact --smooth --shape 64x48 --size 4mm --radius 50mm --young 208GPa --poisson 0.3 "
            "--load 5kN | asperity-stress --maximum -o mises.nc; asperity-stress mises.nc --maximum --of "
            "max_shear -o shear.nc; asperity-stress shear.nc --maximum --of principal --below 2px -o "
            "tension.nc")
          .exit == 0);
  const Attributes mises = read_dataset("mises.nc").attributes, shear = read_dataset("shear.nc").attributes,
                   tension = read_dataset("tension.nc").attributes;
  auto figure = [](const Attributes& a, const char* name) { return a.number(name, -1); };
  CHECK(relative_error(figure(mises, "stress_max_von_mises"), 2 * figure(shear, "stress_max_shear")) <= 1e-5);
  CHECK(relative_error(figure(mises, "stress_max_depth"), figure(shear, "stress_max_depth")) <= 1e-3);
  CHECK(figure(tension, "stress_max_principal") > 0);
  CHECK(figure(tension, "stress_max_below") == Approx(2 * 4e-3 / 64).epsilon(1e-12));
  CHECK(figure(tension, "stress_max_depth") == figure(tension, "stress_max_below"));
  for (const char* name : {"stress_max_von_mises", "stress_max_shear"}) CHECK(tension.find(name) == nullptr);
  CHECK(shear.find("stress_max_von_mises") == nullptr);
  CHECK(shear.find("stress_max_below") == nullptr);
  const Outcome note = shell("asperity-stress mises.nc --maximum --of principal --below 0.2mm -o tension.nc");
  CHECK(lines(note.error) == 2);
  CHECK_THAT(note.error, ContainsSubstring("the largest principal stress lies at the depth of --below"));
  CHECK(shell("asperity-stress mises.nc --depths 0.3mm --section y=max --of max_shear --below 0.1mm -o s.nc")
            .exit == 0);
  CHECK(read_dataset("s.nc").attributes.find("stress_max_shear") != nullptr);
}

// The table is that of the layers; between the cell centres of a rough one its values are higher by a parabola.
TEST_CASE("the table of --result maxima holds the largest stress of each layer and its place",
          "[stress][contract]") {
  const Outcome tsv = shell("asperity-stress " + pressed() + "--result maxima --depths 2px,0.2mm,0.5mm -q"),
                json = shell("asperity-stress " + pressed() +
                             "--result maxima --depths 2px,0.2mm,0.5mm --of max_shear --json -q");
  CHECK(tsv.exit == 0);
  CHECK(tsv.out.starts_with("# depth [m]\tvon_mises [Pa]\tx [m]\ty [m]\n"));
  CHECK(lines(tsv.out) == 4);
  const auto columns = nlohmann::json::parse(json.out);
  const Dataset data = below("--depths 2px,0.2mm,0.5mm --components max_shear");
  const std::vector<double> all = values(data, "max_shear"), z = values(data, "z");
  const std::size_t cells = all.size() / 3;
  for (std::size_t k = 0; k < 3; ++k) {
    const double found = columns["max_shear"]["values"][k],
                 cell = *std::max_element(all.begin() + static_cast<long>(k * cells),
                                          all.begin() + static_cast<long>((k + 1) * cells));
    CAPTURE(k, found, cell);
    CHECK(columns["depth"]["values"][k] == z[k]);
    CHECK(found >= cell);
    CHECK(found <= 1.05 * cell);
    CHECK(std::abs(columns["x"]["values"][k].get<double>()) <= 1.5e-3);
    CHECK(std::abs(columns["y"]["values"][k].get<double>()) <= 1.2e-3);
  }
}

TEST_CASE("all components are all stresses, and the directions of the principal ones are asked for by name",
          "[stress][contract]") {
  const Dataset all = below("--depths 0.1mm --components all"),
                directions = below("--depths 0.1mm --components principal_directions"),
                principal = below("--depths 0.1mm --components principal");
  for (const char* name : {"von_mises", "max_shear", "octahedral_shear", "stress_1", "stress_3", "stress_xy"})
    CHECK(all.find(name) != nullptr);
  CHECK(all.find("direction_1_x") == nullptr);
  CHECK(principal.find("stress_2") != nullptr);
  CHECK(principal.find("direction_1_x") == nullptr);
  CHECK(directions.find("direction_3_z") != nullptr);
  CHECK(directions.find("stress_1") == nullptr);
}

TEST_CASE("a file, a pipe and a pipe of more than --memory carry the same volumes", "[stress][law]") {
  const std::string run = "asperity-stress " + pressed() + "--depths 0:1mm:7 --components all --no-history ";
  REQUIRE(shell(run + "-o file.nc && " + run + "> redirected.nc && " + run + "| cat > pipe.nc && " + run +
                "--memory 100kB | cat > again.nc && " + run + "--threads 3 -o threads.nc")
              .exit == 0);
  auto bytes = [](const std::string& name) {
    Dataset data = read_dataset(name);
    data.attributes.erase("stress_seconds");
    return encode_netcdf(data);
  };
  for (const char* name : {"redirected.nc", "pipe.nc", "again.nc", "threads.nc"}) {
    CAPTURE(name);
    CHECK(bytes(name) == bytes("file.nc"));
  }
}

TEST_CASE("layers that are asked for anew replace what a former run left", "[stress][contract]") {
  REQUIRE(shell("asperity-stress " + pressed() +
                "--depths 0,1mm --section y=0 --above 0.1p0 --maximum | asperity-stress --depths 0 "
                "--components zz -o anew.nc")
              .exit == 0);
  const Dataset data = read_dataset("anew.nc");
  CHECK(data.has("stress_zz"));
  CHECK_FALSE(data.has("von_mises"));
  CHECK_FALSE(data.has("section_y"));
  for (const char* name : {"stress_above", "stress_section_y", "stress_max_x"})
    CHECK(data.attributes.find(name) == nullptr);
}

TEST_CASE("what asperity-stress cannot do is one line that names the option and the value",
          "[stress][contract][slow]") {
  const std::tuple<std::string, std::string, int> wrong[] = {
      {"", "--depths is required", 2},
      {"--depths 0:1mm", "--depths: '0:1mm' is not of the form", 2},
      {"--depths 0:1mm:1", "--depths: '1' is not a number", 2},
      {"--depths 0:1mm:4:geometric", "--depths: equal ratios cannot start from '0'", 2},
      {"--depths 1um:1mm:4:often", "--depths: 'often'", 2},
      {"--depths 1mm,0.5mm", "--depths: '1mm,0.5mm' does not increase", 2},
      {"--depths 0.5", "--depths: '0.5' has no unit", 2},
      {"--depths inf", "--depths: 'inf' has no unit", 2},
      {"--depths 0 --section z=0", "--section: 'z=0'", 2},
      {"--depths 0 --section y=1.3mm", "--section: 'y=1.3mm' lies outside", 2},
      {"--section y=0 --maximum", "--section needs --depths", 2},
      {"--maximum --above 0.6p0", "--above needs --depths", 2},
      {"--depths 0 --above=-1p0", "--above: '-1p0' is not above 0", 2},
      {"--maximum --components zz", "--components needs", 2},
      {"--maximum --of zz", "--of: 'zz' is none of von_mises|max_shear|principal", 2},
      {"--depths 0 --of max_shear", "--of needs --maximum or --result maxima", 2},
      {"--result maxima", "--depths is required", 2},
      {"--result maxima --maximum", "--result: maxima needs --depths", 2},
      {"--result maxima --depths 0 --maximum", "--maximum cannot be combined with --result maxima", 2},
      {"--result maxima --depths 0 --section y=0", "--section cannot be combined", 2},
      {"--result maxima --depths 0 --components zz", "--components cannot be combined", 2},
      {"--result maxima --depths 0 --above 1MPa", "--above cannot be combined", 2},
      {"--result maxima --points points", "--points cannot be combined", 2},
      {"--result maxima --depths 0 --report r.json", "--report cannot be combined", 2},
      {"--depths 0 --below 2px", "--below needs --maximum", 2},
      {"--maximum --below=-1px", "--below: '-1px' is not a depth from 0", 2},
      {"--maximum --below 3", "--below: '3' has no unit", 2},
      {"--depths 0 --components zx", "--components: 'zx' is none of", 2},
      {"--depths 0 --json", "--json", 2},
      {"--points points --depths 0", "--points", 2},
      {"--points points --report r.json", "--report", 2},
      {"--points points", "points: line 2: '0 0 -1um' is not", 4},
      {"--depths 1e31m", "--depths: '1e31m' is not a depth", 2},
      {"--depths 0 --poisson 0.51", "--poisson: 0.51 must lie above -1 and not above 0.5", 2},
      {"--depths 0 --poisson=-1", "--poisson: -1 must", 2},
      {"--depths 0 --friction 0.1 --friction-angle 361deg", "--friction-angle: ", 2},
      {"--depths 0 --friction 0.1 --friction-angle=-7rad", "--friction-angle: ", 2},
  };
  for (const auto& [options, words, exit] : wrong) {
    const Outcome run = shell("printf '0 0 1um\\n0 0 -1um\\n' > points; asperity-stress " + pressed() +
                              options + " -o absent");
    CAPTURE(options, run.error);
    CHECK(run.exit == exit);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring("asperity-stress: ") && ContainsSubstring(words));
  }
  CHECK(shell("cat absent").exit == 1);
}
