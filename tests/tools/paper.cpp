// The scene of Creţu, Bălan & Urzică (2009), run through the tools: two steel spheres of 50 mm pressed
// together by 5 kN, smooth and with roughness of 0.4 µm, 128 × 128 points on 3 mm × 3 mm.
#include <nlohmann/json.hpp>

#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity::test;
using nlohmann::json;

namespace {

const std::string bodies =
    "--radius 50mm,50mm --young 208GPa --poisson 0.3 --load 5000N --yield 1200MPa --tolerance 1e-8";

// Hertz, from R = 25 mm, E* = E / (2 (1 - ν²)): p0³ = 6 Q E*² / (π³ R²), a = π p0 R / (2 E*), δ = a² / R.
const double composite_modulus = 208e9 / (2 * (1 - 0.09)), radius = 25e-3;
const double p0 =
    std::cbrt(6 * 5000 * composite_modulus * composite_modulus / (std::pow(M_PI, 3) * radius * radius));
const double a = M_PI * p0 * radius / (2 * composite_modulus);

struct Scene {
  json contact, stress;
};

Scene run(const std::string& name, const std::string& start) {
  const Outcome out =
      shell(start + bodies + " --report " + name +
            "-c.json | asperity-stress --depths 0:0.8mm:32 --maximum " + "--report " + name + "-s.json -o " +
            name + ".nc && cat " + name + "-c.json && echo , && cat " + name + "-s.json");
  INFO(out.error);
  REQUIRE(out.exit == 0);
  const json both = json::parse("[" + out.out + "]");
  return {both[0], both[1]};
}

const Scene& smooth() {
  static const Scene scene = run("smooth", "asperity-contact --smooth --shape 128x128 --size 3mm ");
  return scene;
}

Scene rough(const std::string& lengths) {
  return run("rough" + lengths, "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --seed 7 --length " +
                                    lengths + " | asperity-contact ");
}

}  // namespace

// The bounds are the errors of Love's discretisation at 23.4 µm, of order 2 in the spacing (tests/contact).
TEST_CASE("the smooth scene is Hertz's contact to the error of its grid", "[paper][exact]") {
  const json& c = smooth().contact;
  CHECK(relative_error(c["contact_max_pressure"], p0) <= 1.4e-4);
  CHECK(relative_error(c["contact_approach"], a * a / radius) <= 3.3e-5);
  CHECK(c["contact_residual"].get<double>() <= 1e-8);
  CHECK(std::abs(c["contact_load_residual"].get<double>()) <= 1e-12);
  CHECK(c["contact_plastic_area"] == 0);
}

// Huber's field: 0.620041 p0 at 0.480864 a on the axis.
TEST_CASE("the smooth scene's greatest von Mises stress is 0.6200 p0 at 0.48 a below the centre",
          "[paper][exact]") {
  const json& s = smooth().stress;
  CHECK(relative_error(s["stress_max_von_mises"], 0.620041 * p0) <= 0.005);
  CHECK(std::abs(s["stress_max_depth"].get<double>() / a - 0.4809) <= 0.01);
  CHECK(std::abs(s["stress_max_x"].get<double>()) <= 3e-3 / 128);
  CHECK(std::abs(s["stress_max_y"].get<double>()) <= 3e-3 / 128);
}

TEST_CASE("a rough contact keeps to its limit pressure, its load and its residual", "[paper][law]") {
  for (const char* lengths : {"17px,4px", "13px,13px"}) {
    CAPTURE(lengths);
    const Scene scene = rough(lengths);
    const json& c = scene.contact;
    CHECK(c["contact_max_pressure"].get<double>() <= 3600e6);
    CHECK(c["contact_residual"].get<double>() <= 1e-8);
    CHECK(std::abs(c["contact_load_residual"].get<double>()) <= 1e-12);
    CHECK(c["contact_plastic_area"].get<double>() <= c["contact_area"].get<double>());
    // The paper's finding: the peak moves up under the asperities, above the smooth contact's.
    CHECK(scene.stress["stress_max_von_mises"].get<double>() >
          smooth().stress["stress_max_von_mises"].get<double>());
    CHECK(scene.stress["stress_max_depth"].get<double>() < 0.2 * a);
  }
}
