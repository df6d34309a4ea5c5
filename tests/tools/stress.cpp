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

// Layers at 4, 21 and 43 cells: the first is the same to the last bit. Von Mises stress adds the errors of components,
// each 2e-6, with weights of √3 at the most for each of six.
TEST_CASE("resolutions full and adapted differ in deep layers only, by 2e-6 of the largest pressure",
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
