#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

std::vector<double> von_mises(const std::string& options) {
  const Outcome run =
      shell("asperity-stress --depths 0.1mm,0.5mm,1mm " + options + " pressed-128.nc -o below.nc");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  return numbers(read_dataset("below.nc").at("von_mises").values);
}

}  // namespace

// Layers at 4, 21 and 43 cells: the first is the same to the last bit. Von Mises stress adds the errors of
// components, each 2e-6, with weights of √3 at the most for each of six.
TEST_CASE("resolutions full and adapted differ in deep layers only, by 2e-6 of the maximum pressure",
          "[stress][contract]") {
  REQUIRE(
      shell("asperity-contact --smooth --shape 128x128 --size 3mm --radius 50mm --young 208GPa --poisson 0.3 "
            "--load 5000N -o pressed-128.nc")
          .exit == 0);
  const double largest = field_of(read_dataset("pressed-128.nc"), "pressure").maxCoeff();
  const std::vector<double> full = von_mises("--resolution full"), adapted = von_mises("");
  const std::size_t layer = 128 * 128;
  REQUIRE(full.size() == 3 * layer);
  double deep = 0;
  for (std::size_t i = 0; i < layer; ++i) CHECK(full[i] == adapted[i]);
  for (std::size_t i = layer; i < full.size(); ++i) deep = std::max(deep, std::abs(full[i] - adapted[i]));
  CHECK(deep > 0);
  CHECK(deep <= 6 * std::sqrt(3.0) * 2e-6 * largest);
}

TEST_CASE("friction adds its traction at the surface, along its angle, and is recorded",
          "[stress][contract]") {
  const std::string press =
      "asperity-contact --smooth --shape 32x32 --size 3mm --radius 50mm --young 208GPa --poisson 0.3 --load "
      "5000N | ";
  const std::string stress = "asperity-stress --depths 0mm --components zz,xz,yz ";
  for (const auto& [angle, in_x, in_y] :
       {std::tuple{"", 1.0, 0.0}, std::tuple{"--friction-angle 90deg", 0.0, 1.0},
        std::tuple{"--friction-angle 0.5rad", std::cos(0.5), std::sin(0.5)}}) {
    REQUIRE(shell(press + stress + "--friction 0.25 " + angle + " -o sliding.nc").exit == 0);
    const Dataset data = read_dataset("sliding.nc");
    CHECK(data.attributes.number("stress_friction", -1) == 0.25);
    CHECK(data.attributes.number("stress_friction_angle", -1) == Approx(std::atan2(in_y, in_x)));
    const auto zz = numbers(data.at("stress_zz").values), xz = numbers(data.at("stress_xz").values),
               yz = numbers(data.at("stress_yz").values);
    const double largest = -*std::min_element(zz.begin(), zz.end());
    for (std::size_t i = 0; i < zz.size(); ++i) {
      CHECK(std::abs(xz[i] - 0.25 * in_x * zz[i]) <= 1e-12 * largest);
      CHECK(std::abs(yz[i] - 0.25 * in_y * zz[i]) <= 1e-12 * largest);
    }
  }
  REQUIRE(shell(stress + "sliding.nc -o resting.nc").exit == 0);
  CHECK(read_dataset("resting.nc").attributes.number("stress_friction", -1) == 0);
  CHECK(read_dataset("resting.nc").attributes.find("stress_friction_angle") == nullptr);
  for (const auto& [wrong, named] :
       {std::pair{"--friction=-0.1", "--friction"}, std::pair{"--friction-angle 30deg", "--friction"},
        std::pair{"--friction 0.1 --friction-angle north", "--friction-angle"}}) {
    const Outcome run = shell(stress + wrong + " sliding.nc");
    CHECK(run.exit == 2);
    CHECK_THAT(run.error, ContainsSubstring(named));
  }
}

// Components are written in double precision: what follows from them is to their round-off.
TEST_CASE(
    "principal, largest and octahedral shear stress are written with the components that they follow from",
    "[stress][contract]") {
  REQUIRE(
      shell("asperity-contact --smooth --shape 24x20 --size 3mm --radius 50mm --young 208GPa --poisson 0.3 "
            "--load 5000N | asperity-stress --depths 0.1mm,0.45mm --friction 0.2 --components "
            "principal,principal_directions,max_shear,octahedral_shear,von_mises,xx,yy,zz -o derived.nc")
          .exit == 0);
  const Dataset data = read_dataset("derived.nc");
  auto values = [&](const std::string& name) { return numbers(data.at(name).values); };
  const auto first = values("stress_1"), second = values("stress_2"), third = values("stress_3");
  const auto shear = values("max_shear"), octahedral = values("octahedral_shear"),
             mises = values("von_mises");
  const auto xx = values("stress_xx"), yy = values("stress_yy"), zz = values("stress_zz");
  const auto x = values("direction_3_x"), y = values("direction_3_y"), z = values("direction_3_z");
  const double bound = 1e-13 * *std::max_element(mises.begin(), mises.end());
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

// The contact took -0.3 and the stress, which reads it from the dataset, refused it as a wrong option.
TEST_CASE(
    "a Poisson's ratio that the contact takes is taken by the stress, and one that no body has is bad data",
    "[stress][contract]") {
  const std::string press =
      "asperity-contact --smooth --shape 32x32 --size 3mm --radius 50mm --young 208GPa --load 5kN ";
  for (const char* ratio : {"-0.99", "-0.3", "0", "0.5"}) {
    const Outcome run =
        shell(press + "--poisson=" + ratio + " | asperity-stress --depths 0.3mm -o auxetic.nc");
    CAPTURE(ratio, run.error);
    CHECK(run.exit == 0);
    CHECK(read_dataset("auxetic.nc").attributes.number("stress_poisson", 9) == std::stod(ratio));
  }
  for (const char* ratio : {"-1", "0.51", "nan"}) {
    const Outcome pressed = shell(press + "--poisson=" + ratio + " -o refused.nc"),
                  below = shell("asperity-stress auxetic.nc --depths 0.3mm -o refused.nc --poisson=" +
                                std::string(ratio));
    CHECK(pressed.exit == 2);
    CHECK(below.exit == 2);
    CHECK(pressed.error.substr(pressed.error.find(':')) == below.error.substr(below.error.find(':')));
  }
  Dataset wrong = read_dataset("auxetic.nc");
  wrong.attributes.set_values("contact_poisson", std::vector<double>{0.7, 0.3});
  write_dataset(wrong, "wrong.nc");
  const Outcome run = shell("asperity-stress wrong.nc --depths 0.3mm -o absent.nc");
  CHECK(run.exit == 4);
  CHECK(run.error == "asperity-stress: wrong.nc: contact_poisson: 0.7 must lie above -1 and not above 0.5\n");
  CHECK(shell("asperity-stress wrong.nc --body 2 --depths 0.3mm -o counter.nc").exit == 0);
}

namespace {

// 64² cells of 47 um, Hertz: 1690 MPa 0.45 mm deep.
const std::string smooth =
    "asperity-contact --smooth --shape 64x64 --size 3mm --radius 50mm --young 208GPa --poisson 0.3 --load "
    "5kN ";

std::string errors_of(const std::string& line) {
  const Outcome run = shell(line);
  INFO(line + run.error);
  CHECK(run.exit == 0);
  return run.error;
}

}  // namespace

// A yield stress of 1100 MPa limits the pressure to 3300 MPa, more than Hertz's 2724: nothing yields at the
// surface, and nothing was said of the 1690 MPa below it.
TEST_CASE(
    "von Mises stress above the yield stress is said once with both figures, of layers, points and the "
    "maximum",
    "[stress][contract][slow]") {
  REQUIRE(shell(smooth + "--yield 1100MPa -o plastic.nc; " + smooth + "--yield 1800MPa -o safe.nc; " +
                smooth + "-o elastic.nc; echo 0 0 0.45mm > axis")
              .exit == 0);
  for (const char* asked :
       {"--depths 0.1mm,0.45mm -o b.nc", "--depths 0.1mm,0.45mm | cat > b.nc",
        "--depths 0.45mm --section y=0 -o b.nc", "--depths 0.1mm,0.45mm --memory 10kB | cat > b.nc",
        "--maximum -o b.nc", "--maximum --depths 0.1mm -o b.nc", "--maximum --depths 0.45mm -o b.nc -q",
        "--points axis -q", "--depths 0.45mm --above 0.5p0 -o b.nc"}) {
    const std::string options = asked;
    const std::string error = errors_of("asperity-stress plastic.nc " + options);
    CAPTURE(options, error);
    CHECK(lines(error) == 1);
    CHECK_THAT(error, ContainsSubstring("warning: von Mises stress reaches 16") &&
                          ContainsSubstring("above the yield stress of 1100 MPa"));
    CHECK(errors_of("asperity-stress safe.nc " + options).empty());
    CHECK(errors_of("asperity-stress elastic.nc " + options).empty());
  }
  CHECK(errors_of("asperity-stress plastic.nc --depths 0.45mm --components zz -o b.nc").empty());
  CHECK(errors_of("asperity-stress plastic.nc --depths 3mm -o b.nc").empty());
}

// Only -v told it.
TEST_CASE("a maximum above stress_accurate_depth is a warning with both depths, a deeper one is none",
          "[stress][contract]") {
  CHECK(errors_of(smooth + " | asperity-stress --maximum -q -o b.nc").empty());
  const std::string error = errors_of(smooth + " | asperity-stress --maximum --friction 0.6 -q -o b.nc");
  CHECK(lines(error) == 1);
  CHECK_THAT(error, ContainsSubstring("warning: the largest von Mises stress lies 0 um deep") &&
                        ContainsSubstring("93.75 um of stress_accurate_depth") &&
                        ContainsSubstring("only as the root of its cell"));
  // To the edge of Hertz' contact, 1.1092 p0, and 1.5 % of p0; its pressure on these cells is 0.1 % off.
  const Attributes data = read_dataset("b.nc").attributes;
  const double p0 = data.number("contact_hertz_pressure", 0), found = data.number("stress_max_von_mises", 0);
  CHECK(std::abs(data.number("stress_max_von_mises_error", 0) - ((1.1092 + 0.015) * p0 - found)) <=
        3e-3 * p0);
  // The former run's error does not stay.
  CHECK(errors_of("asperity-stress b.nc --maximum -q -o c.nc").empty());
  CHECK(read_dataset("c.nc").attributes.find("stress_max_von_mises_error") == nullptr);
}

// At μ = 0.32 the edge bears 0.684 p0, the depth 0.665, and these cells see only the depth: nothing was said.
TEST_CASE("what an edge bears more than a maximum in the depth is told", "[stress][contract]") {
  REQUIRE(shell(smooth + "-o elastic.nc").exit == 0);
  const std::string run = "asperity-stress elastic.nc -q -o b.nc --maximum ";
  const std::string error = errors_of(run + "--friction 0.32");
  CHECK(lines(error) == 1);
  CHECK_THAT(error, ContainsSubstring("um deep: at an edge of a smooth contact with this largest pressure"));
  CHECK(read_dataset("b.nc").attributes.number("stress_max_depth", 0) > 0.3e-3);
  CHECK(errors_of(run + "--friction 0.3").empty());
  CHECK(errors_of(run + "--friction 0.32 --below 2px").empty());
  CHECK(errors_of("asperity-contact --smooth --shape 16x16 --size 1mm --boundary periodic --young 208GPa "
                  "--poisson 0.3 --load 5N | asperity-stress --maximum --friction 0.4 -q -o b.nc")
            .empty());
}

TEST_CASE("layers above stress_accurate_depth are counted in one warning, which the maximum's stands for",
          "[stress][contract]") {
  REQUIRE(shell(smooth + "-o elastic.nc").exit == 0);
  for (const char* section : {"", "--section y=0"}) {
    const std::string error = errors_of("asperity-stress elastic.nc --depths 0,90um,94um,0.45mm -o b.nc -q " +
                                        std::string(section));
    CHECK(lines(error) == 1);
    CHECK_THAT(error, ContainsSubstring("2 of 4 layers lie less than 93.75 um deep") &&
                          ContainsSubstring("stress_accurate_depth") && ContainsSubstring("9 %"));
  }
  CHECK(errors_of("asperity-stress elastic.nc --depths 2px,0.45mm -o b.nc -q").empty());
  const std::string both =
      errors_of("asperity-stress elastic.nc --depths 0,0.45mm --maximum --friction 0.6 -o b.nc -q");
  CHECK(lines(both) == 1);
  CHECK_THAT(both, ContainsSubstring("the largest von Mises stress lies 0 um deep"));
}

// At a corner of cells the shear stress of their pressures grows without end towards the surface: 15 GPa
// under 3 GPa.
TEST_CASE("points above stress_accurate_depth are counted in a warning, deeper ones are not",
          "[stress][contract]") {
  REQUIRE(shell(smooth + "-o elastic.nc; printf '0 0 0\\n0 0 1um\\n0 0 0.4mm\\n' > axis").exit == 0);
  const std::string error = errors_of("asperity-stress elastic.nc --points axis -q");
  CHECK(lines(error) == 1);
  CHECK_THAT(error,
             ContainsSubstring("2 of 3 points lie less than 93.75 um deep") && ContainsSubstring("9 %"));
  // In the middle of the contact the four cells bear alike, at (0.656 mm, 0.656 mm) they do not.
  CHECK_THAT(error, !ContainsSubstring("infinite"));
  REQUIRE(shell("printf '0 0 0\\n0.65625mm 0.65625mm 0\\n0.65625mm 0.01mm 0\\n' > sides").exit == 0);
  CHECK_THAT(errors_of("asperity-stress elastic.nc --points sides -q"),
             ContainsSubstring(
                 "; at 1 of them, the first at (656.25, 656.25) um, on a corner of a cell at the surface, "
                 "stress_xy is infinite"));
  CHECK_THAT(errors_of("asperity-stress elastic.nc --points sides -q --friction 0.2"),
             ContainsSubstring(
                 "; at 2 of them, the first at (656.25, 656.25) um, on a side of a cell at the surface, "
                 "stress_xx, stress_yy or stress_xy is infinite"));
  // A uniform pressure has the same stress at every depth, exactly.
  CHECK(errors_of("asperity-contact --smooth --shape 16x16 --size 1mm --boundary periodic --young 208GPa "
                  "--poisson 0.3 "
                  "--load 5N | asperity-stress --maximum -q -o b.nc")
            .empty());
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
  for (const char* place : {"--shape 8x256 --size 0.1mm,1mm --radius-y 10mm,inf --boundary periodic_x",
                            "--shape 256x8 --size 1mm,0.1mm --radius-x 10mm,inf --boundary periodic_y"}) {
    require(std::string("asperity-contact --smooth ") + place +
            " --young 208GPa --poisson 0.3 --load 10N | asperity-stress --maximum -o line.nc");
    const Attributes& a = read_dataset("line.nc").attributes;
    const double p0 = a.number("contact_hertz_pressure", 0), b = a.number("contact_hertz_half_width", 0);
    CAPTURE(place);
    CHECK(a.number("stress_max_von_mises", 0) == Approx(top * p0).epsilon(1e-3));
    CHECK(a.number("stress_max_depth", 0) == Approx(depth * b).epsilon(0.02));
  }
}

// A pressure that rises as sin² towards the edge and would fall beyond it.
TEST_CASE("a maximum at the edge of a free domain is a warning, at the edge of a period it is none",
          "[stress][contract]") {
  for (bool periodic : {false, true}) {
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
