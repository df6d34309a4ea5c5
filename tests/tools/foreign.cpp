// The dataset as others read it: ncdump, and xarray through its scipy engine.
#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity::test;

namespace {

const std::string chain =
    "asperity-generate --shape 16x12 --size 3mm,2mm --rq 0.4um --length 3px --seed 7"
    " | asperity-contact --radius 50mm --young 208GPa --poisson 0.3 --load 500N"
    " | asperity-stress --depths 0:0.8mm:4 -o chain.nc && ";

std::string python(const std::string& script) { return "/usr/bin/python3 -c '" + script + "'"; }

}  // namespace

TEST_CASE("ncdump shows the dataset as a 64-bit offset file with units on every variable",
          "[foreign][contract]") {
  const Outcome run = shell(chain + "ncdump -k chain.nc && ncdump -h chain.nc");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  CHECK_THAT(run.out, ContainsSubstring("64-bit offset"));
  for (const char* variable :
       {"x", "y", "z", "heights", "pressure", "gap", "displacement", "contact", "von_mises"})
    CHECK_THAT(run.out, ContainsSubstring(std::string("\t\t") + variable + ":units = ") &&
                            ContainsSubstring(std::string("\t\t") + variable + ":long_name = "));
  CHECK_THAT(run.out,
             ContainsSubstring(":Conventions = \"CF-1.8\"") && ContainsSubstring("z:positive = \"down\""));
}

TEST_CASE("xarray opens the dataset as it stands and integrates the pressure to the load",
          "[foreign][exact][slow]") {
  const Outcome run = shell(
      chain + python("import xarray as xr;"
                     "d = xr.open_dataset(\"chain.nc\", engine=\"scipy\");"
                     "assert d.heights.dims == (\"x\", \"y\") and d.von_mises.dims == (\"z\", \"x\", \"y\");"
                     "area = d.x.length / d.sizes[\"x\"] * d.y.length / d.sizes[\"y\"];"
                     "print(float(d.pressure.sum()) * area)"));
  INFO(run.error);
  REQUIRE(run.exit == 0);
  // The load balance of the solver and one sum of 192 products.
  CHECK(relative_error(std::stod(run.out), 500) <= 1e-12 + 192 * epsilon);
}
