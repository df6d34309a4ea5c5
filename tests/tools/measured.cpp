// Measured files go through the whole chain: their correlation, a kernel of it, a twin, its contact.
#include <nlohmann/json.hpp>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

struct Measurement {
  const char *file, *lags, *contact;
  double load;  // [N]
  Shape shape;
  double dx, dy;  // [m]
};

const Measurement measurements[] = {
    {"profiler-96x96.x3p",
     "8x8",
     "--radius 1mm --load 10mN",
     10e-3,
     {96, 96},
     1.27656509837346e-7,
     3.14582113527746e-7},
    {"afm-64x48.txt", "8x6", "--radius 10um --load 1mN", 1e-3, {64, 48}, 2.5e-6 / 64, 1.875e-6 / 48},
};

nlohmann::json statistics(const std::string& file) {
  return nlohmann::json::parse(shell("asperity-stats --json " + file).out);
}

}  // namespace

// The spacing passes five files as a length of n points: a rounding or two each.
TEST_CASE("a measured map has a twin of its spacing and rms height, which bears its load in contact",
          "[measured][statistics]") {
  for (const Measurement& m : measurements) {
    const std::string file = std::string(ASPERITY_TEST_DATA "/") + m.file;
    const Outcome run = shell("asperity-acf " + file + " --biased --max-lag " + m.lags +
                              " | asperity-kernel --acf - | asperity-generate --kernel "
                              "- --seed 1 -o twin.nc && "
                              "asperity-contact twin.nc --young 208GPa --poisson 0.3 -o contact.nc " +
                              m.contact);
    CAPTURE(m.file, run.error);
    REQUIRE(run.exit == 0);
    const Dataset contact = read_dataset("contact.nc");
    const Grid grid = grid_of(contact);
    CHECK(grid.shape == m.shape);
    CHECK(relative_error(grid.dx, m.dx) <= 16 * epsilon);
    CHECK(relative_error(grid.dy, m.dy) <= 16 * epsilon);
    // The solver balances the load to 1e-12, and this sum adds a rounding for each cell.
    const double bearing = field_of(contact, "pressure").sum() * grid.dx * grid.dy;
    CHECK(relative_error(bearing, m.load) <= 1e-12 + static_cast<double>(m.shape.cells()) * epsilon);
    // Both are estimates of one rms height, Sq/√(2 N_eff) from it, of fields so few correlation lengths wide
    // that the tool tells no errors.
    const auto measured = statistics(file), twin = statistics("twin.nc");
    auto value = [](const nlohmann::json& of, const char* name) { return of[name]["value"].get<double>(); };
    auto error = [&](const nlohmann::json& of) {
      return value(of, "Sq") / std::sqrt(2 * value(of, "N_eff"));
    };
    CHECK(std::abs(value(twin, "Sq") - value(measured, "Sq")) <=
          3 * std::hypot(error(measured), error(twin)));
  }
}

TEST_CASE("a measured map comes back from every format that holds doubles to the last bit",
          "[measured][exact]") {
  for (const Measurement& m : measurements) {
    const std::string file = std::string(ASPERITY_TEST_DATA "/") + m.file;
    REQUIRE(shell("asperity-convert " + file + " -o first.npy").exit == 0);
    for (const char* back : {"a.nc", "a.txt", "a.sdf", "a.nrrd", "a.x3p", "a.asc", "a.gwy"}) {
      const std::string to = std::string(back) == "a.txt" ? " --to gwyddion-text" : "";
      const Outcome run = shell("asperity-convert " + file + to + " -o " + back + " && asperity-convert " +
                                back + " -o again.npy && cmp first.npy again.npy");
      CAPTURE(m.file, back, run.error, run.out);
      CHECK(run.exit == 0);
    }
  }
}
