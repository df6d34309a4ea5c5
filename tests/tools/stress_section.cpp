// Where asperity-stress looks: sections and points, and the bound of what it keeps.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/stress_runs.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("at cell centres the stress at points is that of the layers, and a point or its column has a unit",
          "[stress][exact]") {
  const Dataset volume = below("--depths 0,50um,0.6mm --components zz,von_mises --resolution full");
  const auto zz = values(volume, "stress_zz"), von_mises = values(volume, "von_mises");
  const Outcome table = shell(
      "printf '# x y z\n0.0234375mm 25um 50um\n\n-0.0234375mm 0.025mm 0.6mm # deep\n' | "
      "asperity-stress " +
      pressed() + "--points - --components zz,von_mises --json");
  INFO(table.error);
  REQUIRE(table.exit == 0);
  const auto json = nlohmann::json::parse(table.out);
  CHECK(json["stress_zz"]["unit"] == "Pa");
  const std::size_t cells = 64 * 48, first = cells + 32 * 48 + 24, second = 2 * cells + 31 * 48 + 24;
  const double bound = 16 * epsilon * static_cast<double>(cells) * field_of(volume, "pressure").maxCoeff();
  CHECK(std::abs(json["stress_zz"]["values"][0].get<double>() - zz[first]) <= bound);
  CHECK(std::abs(json["stress_zz"]["values"][1].get<double>() - zz[second]) <= bound);
  CHECK(std::abs(json["von_mises"]["values"][0].get<double>() - von_mises[first]) <= 4 * bound);
  CHECK(json["z"]["values"][1] == 0.6e-3);
  const std::string same = "0.0234375,25,50\n-0.0234375,25,600\n", run = "asperity-stress " + pressed();
  const Outcome headed = shell("printf '# x [mm] y [um] depth [um]\n" + same + "' > places; " + run +
                               "--points places --components zz,von_mises --json");
  CHECK(headed.exit == 0);
  const auto again = nlohmann::json::parse(headed.out);
  for (const char* name : {"stress_zz", "von_mises"})
    for (int k : {0, 1})
      CHECK(std::abs(again[name]["values"][k].get<double>() - json[name]["values"][k].get<double>()) <=
            bound);
  // A table of the tool is one of points again.
  CHECK(shell(run + "--points places > table; " + run + "--points table | cmp - table").exit == 0);
  const Outcome bare = shell("printf '" + same + "' > places; " + run + "--points places");
  CHECK(bare.exit == 4);
  CHECK_THAT(bare.error,
             ContainsSubstring("places: points: line 1: '0.0234375' has no unit: write 0.0234375um, or"));
}

TEST_CASE("a section through the maximum runs through the cell that --maximum finds", "[stress][contract]") {
  REQUIRE(shell("asperity-generate --shape 64x48 --size 1mm --rq 0.1um --length 9px,5px --seed 4 | "
                "asperity-contact "
                "--radius 5mm --young 208GPa --poisson 0.3 --load 20N -q -o off.nc")
              .exit == 0);
  for (const char axis : {'x', 'y'}) {
    const std::string key(1, axis);
    REQUIRE(shell("asperity-stress off.nc --depths 0:60um:7 --section " + key + "=max -q -o cut.nc").exit ==
            0);
    const Dataset cut = read_dataset("cut.nc");
    const Grid grid = grid_of(cut);
    const double at = cut.attributes.number("stress_section_" + key, NAN),
                 top = cut.attributes.number("stress_max_" + key, NAN);
    CHECK(std::abs(at - top) <= 0.5 * (axis == 'x' ? grid.dx : grid.dy));
    CHECK(at != 0);
    CHECK(shell("asperity-stress off.nc --depths 0:60um:7 --maximum -q | asperity-plot --kind von-mises "
                "--section " +
                key + "=max -o cut.png")
              .exit == 0);
  }
  CHECK_THAT(
      shell("asperity-stress off.nc --depths 0:60um:7 -q | asperity-plot --kind von-mises --section y=max -o "
            "no.png")
          .error,
      ContainsSubstring("asperity-stress --maximum adds it"));
}

TEST_CASE("the bound of --above is a stress, or a share of the Hertz or of the maximum pressure",
          "[stress][contract]") {
  const std::string layers = "--depths 0:1mm:4 --above ";
  const auto bound = [&](const std::string& text) {
    return below(layers + text).attributes.number("stress_above", 0);
  };
  CHECK(bound("100MPa") == 1e8);
  CHECK(relative_error(bound("0.5pmax"), 0.5 * field_of(below("--depths 0"), "pressure").maxCoeff()) <=
        epsilon);
  const std::string flat =
      "asperity-contact --smooth --shape 8x8 --size 1mm --boundary periodic --young 1GPa --poisson 0.3 "
      "--load 5N | ";
  CHECK(shell(flat + "asperity-stress --depths 0 --above 0.5pmax -o flat.nc").exit == 0);
  const Outcome none = shell(flat + "asperity-stress --depths 0 --above 0.5p0 -o flat.nc");
  CHECK(none.exit == 4);
  CHECK_THAT(none.error, ContainsSubstring("contact_hertz_pressure is missing"));
  CHECK_THAT(
      shell("asperity-plot " + pressed() + "--kind section --variable pressure --above 0.5 -o a.png").error,
      ContainsSubstring("--above: '0.5' has no unit: write 0.1p0"));
}

TEST_CASE(
    "at cell centres of a periodic contact, too, the stress at points is that of the layers and the section",
    "[stress][exact]") {
  REQUIRE(
      shell("asperity-generate --periodic --shape 48x32 --size 1.2mm,1mm --rq 0.2um --length 6px --seed 5 | "
            "asperity-contact --young 208GPa --poisson 0.3 --load 100N -o repeated.nc")
          .exit == 0);
  const std::string run =
      "asperity-stress repeated.nc --resolution full --friction 0.2 --friction-angle 30deg --components "
      "xx,zz,xz ";
  REQUIRE(shell(run + "--depths 0,30um,0.4mm,9mm -o layers.nc && " + run +
                "--depths 0,30um,0.4mm,9mm --section x=0.6mm -o plane.nc")
              .exit == 0);
  const Dataset layers = read_dataset("layers.nc"), plane = read_dataset("plane.nc");
  const Grid grid = grid_of(layers);
  REQUIRE(grid.periodic.both());
  const double bound = 2 * 48 * epsilon * field_of(layers, "pressure").maxCoeff();
  const std::vector<double> depths = depths_of(layers);
  for (Index i : {0, 21, 47, -48, 95})  // the last two a period beside
    for (Index j : {0, 17, 31}) {
      std::string list;
      for (double z : depths) list += fmt::format("{}m {}m {}m\n", grid.x(i), grid.y(j), z);
      const Outcome table = shell("printf -- '" + list + "' | " + run + "--points - --json");
      INFO(table.error);
      REQUIRE(table.exit == 0);
      const auto json = nlohmann::json::parse(table.out);
      for (const char* name : {"stress_xx", "stress_zz", "stress_xz"})
        for (std::size_t l = 0; l < depths.size(); ++l) {
          const double at_point = json[name]["values"][l].get<double>();
          const Index row = (static_cast<Index>(l) * 48 + (i + 48) % 48) * 32 + j;
          CAPTURE(i, j, depths[l], name);
          CHECK(std::abs(at_point - values(layers, name)[static_cast<std::size_t>(row)]) <= bound);
          if ((i + 48) % 48 == 47)
            CHECK(std::abs(at_point - values(plane, name)[l * 32 + static_cast<std::size_t>(j)]) <= bound);
        }
    }
}

TEST_CASE(
    "asperity-stress --above keeps the values from its share of Hertz's pressure on and fills the others",
    "[stress][contract]") {
  const std::string layers = "--depths 0:3mm:13 --components von_mises,xx ";
  const Dataset whole = below(layers), part = below(layers + "--above 0.3p0");
  const double least = 0.3 * whole.attributes.number("contact_hertz_pressure", 0);
  CHECK(part.attributes.number("stress_above", 0) == least);
  for (const char* name : {"von_mises", "stress_xx"}) {
    CHECK(part.at(name).attributes.number("_FillValue", 0) == fill);
    const std::vector<double> all = values(whole, name), kept = values(part, name);
    std::size_t count = 0;
    bool right = all.size() == kept.size();
    for (std::size_t i = 0; i < all.size() && right; ++i) {
      right = kept[i] == (std::abs(all[i]) >= least ? all[i] : fill);
      count += kept[i] != fill;
    }
    CHECK(right);
    CHECK(count > 0);
    const std::vector<double> range = numbers(*part.at(name).attributes.find("actual_range"));
    CHECK(range[1] <= *std::ranges::max_element(all));
  }
}

TEST_CASE("asperity-plot draws a section as the volume's in the same plane, and leaves out what was filled",
          "[stress][contract]") {
  const std::string layers = "asperity-stress " + pressed() + "--resolution full --depths 0:0.5mm:6 ";
  const Outcome run =
      shell(layers + "-o volume.nc && " + layers + "--section y=0 -o plane.nc && " + layers +
            "--section y=0 --above 0.2p0 -o part.nc && for f in volume plane part; do asperity-plot "
            "$f.nc --kind von-mises -o $f.png || exit 9; done; cmp volume.png plane.png");
  CAPTURE(run.error, run.out);
  CHECK(run.exit == 0);
  CHECK(shell("asperity-plot plane.nc --kind von-mises --section x=0 -o no.png").exit == 2);
}
