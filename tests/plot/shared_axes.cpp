// What shares an axis has one unit, and what a range shows is there.
#include <fstream>

#include "plot/pictures.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

void write_field(const std::string& name, const char* unit, const char* words) {
  Dataset data;
  set_grid(data, {{32, 32}, 1e-6, 1e-6});
  set_field(data, "signal", random_field({32, 32}, 1), {unit, words});
  write_dataset(data, name);
}

void write_text(const std::string& name, const std::string& text) { std::ofstream(scratch(name)) << text; }

void refused(const std::string& arguments, int exit, const std::string& words) {
  const Outcome run = shell("asperity-plot " + arguments + " -o w.svg");
  CAPTURE(arguments, run.error);
  CHECK(run.exit == exit);
  CHECK(lines(run.error) == 1);
  CHECK_THAT(run.error, ContainsSubstring(words));
}

}  // namespace

// Volts and metres were drawn on one axis, in the unit of the first.
TEST_CASE("inputs of different units are not drawn on one axis", "[plot][contract]") {
  write_field("volts.nc", "V", "potential");
  write_field("metres.nc", "m", "topography");
  write_field("again.nc", "m", "retrace");
  for (const char* kind : {"map", "surface", "profile", "psd", "pdf", "qq", "abbott"}) {
    refused(std::string("volts.nc metres.nc --labels one,two --variable signal --kind ") + kind, 4,
            "signal is in m in two, and in V in one: draw them apart");
    CHECK(shell(std::string("asperity-plot metres.nc again.nc --variable signal -o two.svg --kind ") + kind)
              .exit == 0);
    if (std::string(kind) != "psd") CHECK_THAT(words_of("two.svg"), ContainsSubstring("signal"));
  }
}

// The axis was called by the quantity of the first table.
TEST_CASE("tables of different stresses, or in other units than loads have, are not drawn on one axis",
          "[plot][contract]") {
  write_text("mises.txt", "# depth [m]\tvon_mises [Pa]\n0\t1e8\n1e-5\t2e8\n");
  write_text("shear.txt", "# depth [m]\tmax_shear [Pa]\n0\t1e8\n1e-5\t2e8\n");
  write_text("ratio.txt", "# depth [m]\tvon_mises [1]\n0\t1\n1e-5\t2\n");
  write_text("newton.txt", "# load [N]\tapproach [m]\tarea [m2]\n1\t1e-6\t1e-9\n2\t2e-6\t2e-9\n");
  write_text("line.txt", "# load [N/m]\tapproach [m]\tarea [m2]\n1\t1e-6\t1e-9\n2\t2e-6\t2e-9\n");
  refused("mises.txt shear.txt --labels a,b --kind maxima", 4, "max_shear");
  refused("mises.txt ratio.txt --labels a,b --kind maxima", 4, "von_mises: '1' cannot be converted to 'Pa'");
  refused("newton.txt line.txt --kind sweep", 4, "load is in N/m, and not in N");
}

// The title of the first was that of all.
TEST_CASE("errors of tables of loads are named where they are", "[plot][contract]") {
  write_text("mean.txt",
             "# load [N]\tapproach [m]\tapproach_standard_error [m]\tarea [m2]\n"
             "1\t1e-6\t1e-8\t1e-9\n2\t2e-6\t1e-8\t2e-9\n");
  write_text("exact.txt", "# load [N]\tapproach [m]\tarea [m2]\n1\t1e-6\t1e-9\n2\t2e-6\t2e-9\n");
  REQUIRE(shell("asperity-plot mean.txt exact.txt --kind sweep --labels a,b -o two.svg").exit == 0);
  CHECK_THAT(words_of("two.svg"),
             ContainsSubstring("\na, 95 % intervals of the mean\n") && ContainsSubstring("\nb\n"));
}

// A kernel and a surface side by side were both called a surface with errors.
TEST_CASE("of kernels and surfaces side by side each says what it is", "[plot][contract]") {
  REQUIRE(shell("asperity-kernel --shape 16x16 --size 16um --length 4px -o kernel.nc").exit == 0);
  REQUIRE(shell("asperity-generate --shape 64x64 --size 64um --rq 1um --length 4px --seed 1 -o surface.nc")
              .exit == 0);
  REQUIRE(shell("asperity-plot kernel.nc surface.nc --kind acf --labels a,b -o two.svg").exit == 0);
  CHECK_THAT(words_of("two.svg"),
             ContainsSubstring("\na, kernel\n") && ContainsSubstring("\nb, surface ± 2 standard errors\n"));
}

// One flat colour, or an empty panel, was drawn in silence.
TEST_CASE("a range beyond all values is refused with the range of the values", "[plot][contract]") {
  for (const char* kind : {"map", "surface", "profile", "abbott", "qq"})
    for (const char* range : {"10um,20um", "-20um,-10um"})
      refused(scene() + " --range " + range + " --kind " + kind, 2, "contains no value: give a part of -");
  refused(scene() + " --kind map --variable pressure --range 100GPa,200GPa", 2, "--range: '100GPa,200GPa'");
  refused(scene() + " --kind von-mises --range 100GPa,200GPa", 2, "give a part of 16.5MPa to 1.91GPa");
  refused(scene() + " --kind maxima --range 100GPa,200GPa", 2, "contains no value");
  CHECK(plot("--kind map --range 0um,20um -o a.svg").exit == 0);
}

TEST_CASE("depths and positions beyond the data are refused with what is there", "[plot][contract]") {
  refused(scene() + " --kind von-mises --depth-range 1mm,2mm", 2,
          "contains nothing to draw: give a part of 0 to 80um");
  refused(scene() + " --kind maxima --depth-range 1mm,2mm", 2, "give a part of 0 to 80um");
  refused(scene() + " --kind von-mises --x-range 1mm,2mm", 2, "contains nothing to draw");
  refused(scene() + " --kind acf --x-range=-2mm,-1mm", 2, "--x-range");
  refused(scene() + " --kind acf --x-range 0um,1um", 2, "--x-range");
}

// They were taken and left unused.
TEST_CASE("options that a kind does not use are refused", "[plot][contract]") {
  for (const char* arguments :
       {"map --depth-range 0um,10um", "map --section y=0", "map --above 1GPa", "map --scale-by p0",
        "pdf --range 0um,1um", "psd --x-range 0um,10um", "abbott --y-range 0um,10um", "contact --range 0,1",
        "sweep --variable pressure", "maxima --section y=0", "acf --depth-range 0um,10um"})
    refused(scene() + " --kind " + arguments, 2, "cannot be combined with --kind ");
}
