// Where asperity-stress looks: sections and points, and the bound of what it keeps.
#include <fmt/format.h>

#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

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
    const std::string axis = cut.along_x ? "y" : "x";
    const double place = values(volume, axis)[static_cast<std::size_t>(cut.index)];
    CHECK(values(section, "section_" + axis)[0] == place);
    CHECK(section.attributes.number("stress_section_" + axis, 9) == place);
    const Index n = cut.along_x ? grid.shape.nx : grid.shape.ny;
    for (const char* name :
         {"von_mises", "stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_xz", "stress_yz"}) {
      const std::vector<double> whole = values(volume, name), part = values(section, name);
      CHECK(section.at(name).dimensions == std::vector<std::string>{"z", cut.along_x ? "x" : "y"});
      REQUIRE(part.size() == static_cast<std::size_t>(4 * n));
      double error = 0;
      for (Index l = 0; l < 4; ++l)
        for (Index k = 0; k < n; ++k) {
          const Index i = cut.along_x ? k : cut.index, j = cut.along_x ? cut.index : k,
                      at = (l * grid.shape.nx + i) * grid.shape.ny + j;
          error = std::max(error, std::abs(part[static_cast<std::size_t>(l * n + k)] -
                                           whole[static_cast<std::size_t>(at)]));
        }
      CAPTURE(cut.option, name);
      CHECK(error <= 4 * bound);
    }
  }
}

TEST_CASE("at cell centres the stress at points is that of the layers, and a point or its column has a unit",
          "[stress][exact]") {
  const Dataset volume = below("--depths 0,50um,0.6mm --components zz,von_mises --resolution full");
  const std::string run = "asperity-stress " + oblong(), components = " --components zz,von_mises";
  const Printed written =
      printed("printf '# x y z\n0.0234375mm 25um 50um\n\n-0.0234375mm 0.025mm 0.6mm # deep\n' | " + run +
              "--points -" + components);
  const Printed headed =
      printed("printf '# x [mm] y [um] depth [um]\n0.0234375,25,50\n-0.0234375,25,600\n' > places; " + run +
              "--points places" + components);
  const std::size_t cells = 64 * 48, at[] = {cells + 32 * 48 + 24, 2 * cells + 31 * 48 + 24};
  const double bound = 16 * epsilon * static_cast<double>(cells) * field_of(volume, "pressure").maxCoeff();
  for (std::size_t k : {0, 1}) {
    CHECK(std::abs(written["stress_zz"][k] - values(volume, "stress_zz")[at[k]]) <= bound);
    CHECK(std::abs(written["von_mises"][k] - values(volume, "von_mises")[at[k]]) <= 4 * bound);
    for (const char* name : {"stress_zz", "von_mises"})
      CHECK(std::abs(headed[name][k] - written[name][k]) <= bound);
  }
  CHECK(written["z"][1] == 0.6e-3);
  // A table of the tool is one of points again.
  require(run + "--points places > table; " + run + "--points table | cmp - table");
}

TEST_CASE("a section through the maximum runs through the cell that --maximum finds", "[stress][contract]") {
  require(
      "asperity-generate --shape 64x48 --size 1mm --rq 0.1um --length 9px,5px --seed 4 | asperity-contact "
      "--radius 5mm --load 20N -q -o off.nc" +
      steel);
  for (const std::string axis : {"x", "y"}) {
    const std::string layers = "asperity-stress off.nc -q --depths 0:60um:7 ",
                      max = "--section " + axis + "=max ";
    require(layers + max + "-o cut.nc; " + layers + "--maximum | asperity-plot --kind von-mises " + max +
            "-o cut.png");
    const Grid grid = grid_of(read_dataset("cut.nc"));
    const double at = attribute("cut.nc", "stress_section_" + axis),
                 top = attribute("cut.nc", "stress_max_" + axis);
    CHECK(std::abs(at - top) <= 0.5 * (axis == "x" ? grid.dx : grid.dy));
    CHECK(at != 0);
  }
}

TEST_CASE("the bound of --above is a stress, or a share of the Hertz or of the maximum pressure",
          "[stress][contract]") {
  const auto bound = [&](const std::string& text) {
    return below("--depths 0:1mm:4 --above " + text).attributes.number("stress_above", 0);
  };
  CHECK(bound("100MPa") == 1e8);
  CHECK(relative_error(bound("0.5pmax"), 0.5 * field_of(below("--depths 0"), "pressure").maxCoeff()) <=
        epsilon);
}

TEST_CASE(
    "at cell centres of a periodic contact, too, the stress at points is that of the layers and the section",
    "[stress][exact]") {
  const std::string run =
      "asperity-stress repeated.nc --resolution full --friction 0.2 --friction-angle 30deg --components "
      "xx,zz,xz ";
  require(
      "asperity-generate --periodic --shape 48x32 --size 1.2mm,1mm --rq 0.2um --length 6px --seed 5 | "
      "asperity-contact --load 100N -o repeated.nc" +
      steel + "&& " + run + "--depths 0,30um,0.4mm,9mm -o layers.nc && " + run +
      "--depths 0,30um,0.4mm,9mm --section x=0.6mm -o plane.nc");
  const Dataset layers = read_dataset("layers.nc"), plane = read_dataset("plane.nc");
  const Grid grid = grid_of(layers);
  REQUIRE(grid.periodic.both());
  const double bound = 2 * 48 * epsilon * field_of(layers, "pressure").maxCoeff();
  const std::vector<double> depths = depths_of(layers);
  for (Index i : {0, 21, 47, -48, 95})  // the last two a period off
    for (Index j : {0, 17, 31}) {
      std::string list;
      for (double z : depths) list += fmt::format("{}m {}m {}m\n", grid.x(i), grid.y(j), z);
      const Printed table = printed("printf -- '" + list + "' | " + run + "--points -");
      for (const char* name : {"stress_xx", "stress_zz", "stress_xz"})
        for (std::size_t l = 0; l < depths.size(); ++l) {
          const double at_point = table[name][l];
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
  constexpr double fill = 9.9692099683868690e+36;
  const std::string layers = "--depths 0:3mm:13 --components von_mises,xx ";
  const Dataset whole = below(layers), part = below(layers + "--above 0.3p0");
  const double least = 0.3 * whole.attributes.number("contact_hertz_pressure", 0);
  CHECK(part.attributes.number("stress_above", 0) == least);
  for (const char* name : {"von_mises", "stress_xx"}) {
    CHECK(part.at(name).attributes.number("_FillValue", 0) == fill);
    std::vector<double> expected = values(whole, name);
    const double most = *std::ranges::max_element(expected);
    for (double& value : expected)
      if (std::abs(value) < least) value = fill;
    CHECK((values(part, name) == expected));
    CHECK(std::ranges::count(expected, fill) < static_cast<std::ptrdiff_t>(expected.size()));
    CHECK(numbers(*part.at(name).attributes.find("actual_range"))[1] <= most);
  }
}

TEST_CASE("asperity-plot draws a section as the volume's in the same plane, and leaves out what was filled",
          "[stress][contract]") {
  const std::string layers = "asperity-stress " + oblong() + "--resolution full --depths 0:0.5mm:6 ";
  require(layers + "-o volume.nc && " + layers + "--section y=0 -o plane.nc && " + layers +
          "--section y=0 --above 0.2p0 -o part.nc && for f in volume plane part; do asperity-plot "
          "$f.nc --kind von-mises -o $f.png || exit 9; done; cmp volume.png plane.png");
  CHECK(shell("asperity-plot plane.nc --kind von-mises --section x=0 -o no.png").exit == 2);
}
