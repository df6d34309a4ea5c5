// asperity-stress: layers, sections, points, the largest stress, and what is said of it.
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

std::string errors_of(const std::string& line) { return require(line).error; }

// 64² cells of 47 um, Hertz: 1690 MPa 0.45 mm deep.
const std::string hertz = sphere + "--load 5kN ";

}  // namespace

// Layers at 4, 21 and 43 cells: the first is the same to the last bit. Von Mises stress adds the errors of
// components, each 2e-6, with weights of √3 at the most for each of six.
TEST_CASE("resolutions full and adapted differ in deep layers only, by 2e-6 of the maximum pressure",
          "[stress][contract]") {
  require("asperity-contact --smooth --shape 128x128 --size 3mm --radius 50mm --load 5000N -o fine.nc" +
          steel);
  const std::string run = "asperity-stress fine.nc --depths 0.1mm,0.5mm,1mm ";
  require(run + "--resolution full -o full.nc; " + run + "-o adapted.nc");
  const double most = field_in("fine.nc", "pressure").maxCoeff();
  const std::vector<double> full = values_in("full.nc", "von_mises"),
                            adapted = values_in("adapted.nc", "von_mises");
  const std::size_t layer = 128 * 128;
  REQUIRE(full.size() == 3 * layer);
  double deep = 0;
  for (std::size_t i = 0; i < layer; ++i) CHECK(full[i] == adapted[i]);
  for (std::size_t i = layer; i < full.size(); ++i) deep = std::max(deep, std::abs(full[i] - adapted[i]));
  CHECK(deep > 0);
  CHECK(deep <= 6 * std::sqrt(3.0) * 2e-6 * most);
}

TEST_CASE("friction adds its traction at the surface, along its angle, and is recorded",
          "[stress][contract]") {
  require("asperity-contact --smooth --shape 32x32 --size 3mm --radius 50mm --load 5000N -o coarse.nc" +
          steel);
  const std::string run = "asperity-stress --depths 0mm --components zz,xz,yz ";
  for (const auto& [angle, in_x, in_y] : {std::tuple{"", 1.0, 0.0},
                                          {"--friction-angle 90deg", 0.0, 1.0},
                                          {"--friction-angle 0.5rad", std::cos(0.5), std::sin(0.5)}}) {
    require(run + "coarse.nc --friction 0.25 " + angle + " -o sliding.nc");
    CHECK(attribute("sliding.nc", "stress_friction") == 0.25);
    CHECK(attribute("sliding.nc", "stress_friction_angle") == Approx(std::atan2(in_y, in_x)));
    const auto zz = values_in("sliding.nc", "stress_zz"), xz = values_in("sliding.nc", "stress_xz"),
               yz = values_in("sliding.nc", "stress_yz");
    for (std::size_t i = 0; i < zz.size(); ++i) {
      CHECK(std::abs(xz[i] - 0.25 * in_x * zz[i]) <= 1e-12 * largest(zz));
      CHECK(std::abs(yz[i] - 0.25 * in_y * zz[i]) <= 1e-12 * largest(zz));
    }
  }
  require(run + "sliding.nc -o resting.nc");
  CHECK(attribute("resting.nc", "stress_friction") == 0);
  CHECK(attributes_in("resting.nc").find("stress_friction_angle") == nullptr);
}

// Components are written in double precision: what follows from them is to their round-off.
TEST_CASE(
    "principal, largest and octahedral shear stress are written with the components that they follow from",
    "[stress][contract]") {
  require("asperity-contact --smooth --shape 24x20 --size 3mm --radius 50mm --load 5000N" + steel +
          "| asperity-stress --depths 0.1mm,0.45mm --friction 0.2 --components "
          "principal,principal_directions,max_shear,octahedral_shear,von_mises,xx,yy,zz -o derived.nc");
  const Dataset data = read_dataset("derived.nc");
  const auto first = values(data, "stress_1"), second = values(data, "stress_2"),
             third = values(data, "stress_3"), shear = values(data, "max_shear"),
             octahedral = values(data, "octahedral_shear"), mises = values(data, "von_mises"),
             xx = values(data, "stress_xx"), yy = values(data, "stress_yy"), zz = values(data, "stress_zz"),
             x = values(data, "direction_3_x"), y = values(data, "direction_3_y"),
             z = values(data, "direction_3_z");
  const double bound = 1e-13 * largest(mises);
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(first[i] >= second[i]);
    CHECK(second[i] >= third[i]);
    CHECK(std::abs(first[i] + second[i] + third[i] - xx[i] - yy[i] - zz[i]) <= bound);
    CHECK(std::abs(shear[i] - 0.5 * (first[i] - third[i])) <= bound);
    CHECK(std::abs(octahedral[i] - std::sqrt(2.0) / 3 * mises[i]) <= bound);
    CHECK(std::abs(x[i] * x[i] + y[i] * y[i] + z[i] * z[i] - 1) <= 1e-14);
  }
  CHECK(data.at("direction_3_x").attributes.text("units") == "1");
  CHECK(data.at("stress_1").attributes.text("units") == "Pa");
}

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

TEST_CASE("all components are all stresses, and the directions of the principal ones are asked for by name",
          "[stress][contract]") {
  const Dataset all = below("--depths 0.1mm --components all"),
                directions = below("--depths 0.1mm --components principal_directions"),
                principal = below("--depths 0.1mm --components principal");
  for (const char* name : {"von_mises", "max_shear", "octahedral_shear", "stress_1", "stress_3", "stress_xy"})
    CHECK(all.has(name));
  CHECK((principal.has("stress_2") && directions.has("direction_3_z")));
  CHECK_FALSE((all.has("direction_1_x") || principal.has("direction_1_x") || directions.has("stress_1")));
}

TEST_CASE("layers that are asked for anew replace what a former run left", "[stress][contract]") {
  require(
      "asperity-stress " + oblong() +
      "--depths 0,1mm --section y=0 --above 0.1p0 --maximum | asperity-stress --depths 0 --components zz -o "
      "anew.nc");
  const Dataset data = read_dataset("anew.nc");
  CHECK(data.has("stress_zz"));
  CHECK_FALSE((data.has("von_mises") || data.has("section_y")));
  for (const char* name : {"stress_above", "stress_section_y", "stress_max_x"})
    CHECK(data.attributes.find(name) == nullptr);
}

// ---- the largest stress ----

// The points were those below one period alone: -175 MPa in place of -500. Sums over the
// modes in two orders: n ε of the maximum pressure each (stress/points.hpp), 48 cells to a side.
TEST_CASE("asperity-stress --maximum leaves its place and no volume, and the same place as beside a volume",
          "[stress][contract]") {
  const Dataset alone = below("--maximum"), with_volume = below("--maximum --depths 0,1mm");
  auto figure = [&](const std::string& name) { return alone.attributes.number("stress_max_" + name, -1); };
  CHECK_FALSE((alone.has("von_mises") || alone.has("z")));
  for (const std::string name : {"von_mises", "x", "y", "depth"})
    CHECK(figure(name) == with_volume.attributes.number("stress_max_" + name, -2));
  const Dataset near = below("--depths " + std::to_string(figure("depth") * 1e6) + "um");
  CHECK(relative_error(figure("von_mises"), largest(values(near, "von_mises"))) <= 0.02);
  CHECK(below("--depths 0").attributes.find("stress_max_x") == nullptr);
}

// On the axis of a Hertz contact the largest shear stress is half of von Mises, but for the parabolas between
// the cell centres, 2e-6 here; the tension lies off it.
TEST_CASE(
    "the maximum of another stress, and below a depth, has its own name, and drops that of a former run",
    "[stress][contract]") {
  require(
      "asperity-contact --smooth --shape 64x48 --size 4mm --radius 50mm --load 5kN" + steel +
      "| asperity-stress --maximum -o mises.nc; asperity-stress mises.nc --maximum --of max_shear -o "
      "shear.nc; "
      "asperity-stress shear.nc --maximum --of principal --below 2px -o tension.nc; asperity-stress mises.nc "
      "--depths 0.3mm --section y=max --of max_shear --below 0.1mm -o section.nc");
  CHECK(relative_error(attribute("mises.nc", "stress_max_von_mises"),
                       2 * attribute("shear.nc", "stress_max_shear")) <= 1e-5);
  CHECK(relative_error(attribute("mises.nc", "stress_max_depth"),
                       attribute("shear.nc", "stress_max_depth")) <= 1e-3);
  const double bound = attribute("tension.nc", "stress_max_below");
  CHECK(attribute("tension.nc", "stress_max_principal") > 0);
  CHECK(bound == Approx(2 * 4e-3 / 64).epsilon(1e-12));
  CHECK(attribute("tension.nc", "stress_max_depth") == bound);
  for (const auto& [file, gone] : {std::pair{"tension.nc", "stress_max_von_mises"},
                                   {"tension.nc", "stress_max_shear"},
                                   {"shear.nc", "stress_max_von_mises"},
                                   {"shear.nc", "stress_max_below"}})
    CHECK(attributes_in(file).find(gone) == nullptr);
  CHECK(attributes_in("section.nc").find("stress_max_shear") != nullptr);
  const Outcome note = shell("asperity-stress mises.nc --maximum --of principal --below 0.2mm -o tension.nc");
  CHECK(lines(note.error) == 2);
  CHECK_THAT(note.error, ContainsSubstring("the largest principal stress lies at the depth of --below"));
}

// Between the cell centres of a rough layer its values are higher by a parabola.
TEST_CASE("the table of --result maxima holds the largest stress of each layer and its place",
          "[stress][contract]") {
  const std::string maxima = "asperity-stress " + oblong() + "--result maxima --depths 2px,0.2mm,0.5mm -q ";
  CHECK(require(maxima).out.starts_with("# depth [m]\tvon_mises [Pa]\tx [m]\ty [m]\n"));
  const Printed table = printed(maxima + "--of max_shear");
  REQUIRE(table.rows.size() == 3);
  const Dataset data = below("--depths 2px,0.2mm,0.5mm --components max_shear");
  const std::vector<double> all = values(data, "max_shear");
  const auto cells = static_cast<std::ptrdiff_t>(all.size() / 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto layer = all.begin() + static_cast<std::ptrdiff_t>(k) * cells;
    const double found = table["max_shear"][k], cell = *std::max_element(layer, layer + cells);
    CAPTURE(k, found, cell);
    CHECK(table["depth"][k] == values(data, "z")[k]);
    CHECK(found >= cell);
    CHECK(found <= 1.05 * cell);
    CHECK(std::abs(table["x"][k]) <= 1.5e-3);
    CHECK(std::abs(table["y"][k]) <= 1.2e-3);
  }
}

// Only -v told it.
TEST_CASE("a maximum above stress_accurate_depth is a warning with both depths, a deeper one is none",
          "[stress][contract]") {
  CHECK(errors_of(hertz + " | asperity-stress --maximum -q -o b.nc").empty());
  const std::string error = errors_of(hertz + " | asperity-stress --maximum --friction 0.6 -q -o b.nc");
  CHECK(lines(error) == 1);
  CHECK_THAT(error, ContainsSubstring("warning: the largest von Mises stress lies 0 um deep") &&
                        ContainsSubstring("93.75 um of stress_accurate_depth") &&
                        ContainsSubstring("only as the root of its cell"));
  // To the edge of Hertz' contact, 1.1092 p0, and 1.5 % of p0; its pressure on these cells is 0.1 % off.
  const double p0 = attribute("b.nc", "contact_hertz_pressure"),
               found = attribute("b.nc", "stress_max_von_mises");
  CHECK(std::abs(attribute("b.nc", "stress_max_von_mises_error") - ((1.1092 + 0.015) * p0 - found)) <=
        3e-3 * p0);
  // The former run's error does not stay.
  CHECK(errors_of("asperity-stress b.nc --maximum -q -o c.nc").empty());
  CHECK(attributes_in("c.nc").find("stress_max_von_mises_error") == nullptr);
}

// Johnson, (4.45) on the axis of a line contact, b = p₀ = 1; 54 cells across leave 5e-4.
TEST_CASE("below a line contact the largest von Mises stress is that of plane strain", "[stress][exact]") {
  const auto mises = [](double z) {
    const double root = std::sqrt(1 + z * z), across = 2 * z - (1 + 2 * z * z) / root, down = -1 / root,
                 along = 0.3 * (across + down);
    return std::sqrt((std::pow(across - down, 2) + std::pow(down - along, 2) + std::pow(along - across, 2)) /
                     2);
  };
  double top = 0, depth = 0;
  for (double z = 0; z < 2; z += 1e-4)
    if (mises(z) > top) top = mises(z), depth = z;
  for (const std::string place :
       {"--shape 8x256 --size 0.1mm,1mm --radius-y 10mm,inf --boundary periodic_x",
        "--shape 256x8 --size 1mm,0.1mm --radius-x 10mm,inf --boundary periodic_y"}) {
    require("asperity-contact --smooth --load 10N " + place + steel +
            "| asperity-stress --maximum -o line.nc");
    const double p0 = attribute("line.nc", "contact_hertz_pressure"),
                 b = attribute("line.nc", "contact_hertz_half_width");
    CAPTURE(place);
    CHECK(attribute("line.nc", "stress_max_von_mises") == Approx(top * p0).epsilon(1e-3));
    CHECK(attribute("line.nc", "stress_max_depth") == Approx(depth * b).epsilon(0.02));
  }
}

// A pressure that rises as sin² towards the edge and would fall beyond it.
TEST_CASE("a maximum at the edge of a free domain is a warning, at the edge of a period it is none",
          "[stress][contract]") {
  for (const bool periodic : {false, true}) {
    const Grid grid{{16, 8}, 1e-3, 4e-3, periodic};
    Dataset data;
    set_grid(data, grid);
    const Field p =
        sample(grid, [&](double x, double) { return std::pow(std::sin(M_PI * x / grid.size_x()), 8); });
    set_field(data, "pressure", 1e9 * p, {"Pa", "pressure"});
    write_dataset(data, "edge.nc");
    const std::string error = errors_of("asperity-stress edge.nc --poisson 0.3 --maximum -o b.nc");
    CAPTURE(periodic);
    CHECK((error.find("lies at the edge of the domain") == std::string::npos) == periodic);
  }
}
