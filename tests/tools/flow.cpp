// asperity-contact --plasticity j2, and what asperity-stress makes of it.
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string pressed_plastically =
    "asperity-contact --smooth --shape 48x48 --size 3mm --radius 50mm --plasticity j2 --increments 4 " +
    steel;

}  // namespace

// Between cells the largest stress is that of a quadratic, and between layers the residual stress is
// interpolated.
TEST_CASE("below a contact that flows von Mises stress stays at the yield stress, by cut it does not",
          "[flow][contract][slow]") {
  require(pressed_plastically + " --load 6kN --yield 1GPa -o flow.nc");
  require("asperity-stress flow.nc --depths 0.1mm:0.8mm:15 --maximum -o below.nc");
  CHECK(attribute("below.nc", "stress_max_von_mises") <= 1.02e9);
  CHECK(largest(values_in("below.nc", "von_mises")) <= 1.02e9);
  CHECK(attribute("flow.nc", "contact_max_pressure") < 2.5e9);
  require("asperity-stress flow.nc --section y=0 --depths 0.1mm:0.8mm:15 -o section.nc");
  CHECK(largest(values_in("section.nc", "von_mises")) <= 1.02e9);
  CHECK(largest(values_in("section.nc", "von_mises")) >= 0.98e9);
}

// What elastic unloading leaves is u of the loaded state; the loop's residual is 1e-4 of the yield strain.
TEST_CASE("unloaded, the residual heights are the dent, and the stress balances itself",
          "[flow][contract][slow]") {
  require(pressed_plastically + " --load 6kN --yield 1GPa,inf --unload -o unloaded.nc");
  CHECK(attribute("unloaded.nc", "contact_load") == 0);
  CHECK(attribute("unloaded.nc", "contact_flattening_load") == Approx(6e3));
  const double dent = attribute("unloaded.nc", "contact_dent");
  CHECK(dent > 0);
  CHECK(-field_in("unloaded.nc", "heights_residual").minCoeff() == Approx(dent).epsilon(1e-12));
  // No force crosses a plane: σzz of a layer sums to zero, but for what lies beyond the domain, 11 % here.
  require("asperity-stress unloaded.nc --depths 0.3mm,0.5mm --components zz -o balance.nc");
  const std::vector<double> zz = values_in("balance.nc", "stress_zz");
  const std::size_t layer = zz.size() / 2;
  double sum = 0, size = 0;
  for (std::size_t i = 0; i < layer; ++i) sum += zz[i], size += std::abs(zz[i]);
  CHECK(std::abs(sum) <= 0.2 * size);
}

TEST_CASE("a load below yield leaves nothing, and says so", "[flow][contract]") {
  require(pressed_plastically + " --load 100N --yield 3GPa -o elastic.nc");
  CHECK(attribute("elastic.nc", "contact_dent") == 0);
  CHECK(attributes_in("elastic.nc").find("contact_layer_edges") == nullptr);
}

// The way back carries the dents of the greatest load.
TEST_CASE("a sweep up and down keeps its dents", "[flow][contract][slow]") {
  const Printed table(require(pressed_plastically + " --sweep 2kN:6kN:3,6kN:2kN:2 --yield 1GPa").out);
  const std::vector<double>& dent = table["dent"];
  REQUIRE(dent.size() == 4);
  CHECK(dent[1] > dent[0]);
  CHECK(dent[2] > dent[1]);
  CHECK(dent[3] == Approx(dent[2]).epsilon(1e-3));
  CHECK(table["approach"][3] > table["approach"][0]);
}
