// What is measured: of files of instruments through the whole chain, of drawn surfaces, of contacts, of the paper's scene.
#include <limits>
#include <numeric>

#include "core/error.hpp"
#include "stats/measure/surface.hpp"
#include "tools/cli/table.hpp"
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

// ---- files of instruments ----

namespace {

struct Measurement {
  const char *file, *contact;
  double load;  // [N]
  Shape shape;
  double dx, dy;  // [m]
};

const Measurement measurements[] = {
    {ASPERITY_TEST_DATA "/profiler-96x96.x3p",
     "--radius 1mm --load 10mN",
     10e-3,
     {96, 96},
     1.27656509837346e-7,
     3.14582113527746e-7},
    {ASPERITY_TEST_DATA "/afm-64x48.txt",
     "--radius 10um --load 1mN",
     1e-3,
     {64, 48},
     2.5e-6 / 64,
     1.875e-6 / 48},
};

}  // namespace

// The spacing passes five files as a length of n points: a rounding or two each.
TEST_CASE("a measured map has a twin of its spacing and rms height, which bears its load in contact",
          "[measured][statistics]") {
  for (const Measurement& m : measurements) {
    CAPTURE(m.file);
    const std::string file = m.file;
    require("asperity-generate --like " + file +
            " --seed 1 -o twin.nc && asperity-contact twin.nc -o contact.nc " + m.contact + steel);
    const Grid grid = grid_of(read_dataset("contact.nc"));
    CHECK(grid.shape == m.shape);
    CHECK(relative_error(grid.dx, m.dx) <= 16 * epsilon);
    CHECK(relative_error(grid.dy, m.dy) <= 16 * epsilon);
    // The solver balances the load to 1e-12, and this sum adds a rounding for each cell.
    const double bearing = field_in("contact.nc", "pressure").sum() * grid.dx * grid.dy;
    CHECK(relative_error(bearing, m.load) <= 1e-12 + static_cast<double>(m.shape.cells()) * epsilon);
    // Both are estimates of one rms height, Sq/√(2 N_eff) from it, of fields so few correlation lengths wide that
    // the tool tells no errors.
    const Printed map = printed("asperity-stats " + file), twin = printed("asperity-stats twin.nc");
    auto error = [](const Printed& of) { return of.at("Sq") / std::sqrt(2 * of.at("N_eff")); };
    CHECK(std::abs(twin.at("Sq") - map.at("Sq")) <= 3 * std::hypot(error(map), error(twin)));
  }
}

// Sdq rests on 250 patches of the map of 17 lengths a side, √(1/2/250) = 4.5 %, and less on four twins; of a
// Gaussian surface 60 summits, 13 %, and their count varies less than Poisson's. The biased ACF had 33 % and a
// factor of 20.
TEST_CASE("twins of a map have its slopes and summits, and the pipe draws the same to the bit",
          "[measured][statistics]") {
  for (const std::string model : {"gaussian --length 60um", "exponential --length 60um"}) {
    require("asperity-generate --shape 256x200 --size 1mm,0.8mm --rq 0.4um --seed 5 -o m.nc --model " +
            model);
    require("asperity-generate -q --like m.nc --seed 8 --count 4 -o t_%d.nc");
    const Printed map = printed("asperity-stats -q --parameters hybrid m.nc"),
                  twins = printed("asperity-stats -q --parameters hybrid t_0.nc t_1.nc t_2.nc t_3.nc");
    CAPTURE(model);
    CHECK(std::abs(twins.at("Sdq", "mean") / map.at("Sdq") - 1) <= 0.10);
    CHECK(std::abs(std::log(twins.at("summit_density", "mean") / map.at("summit_density"))) <= std::log(1.3));
    require("asperity-acf --taper m.nc -o acf.nc && asperity-generate -q --acf acf.nc --seed 8 -o again.nc");
    CHECK(read_dataset("again.nc").at("heights").values == read_dataset("t_0.nc").at("heights").values);
    require("asperity-kernel -q --acf acf.nc | asperity-generate -q --kernel - --seed 8 -o filtered.nc");
    CHECK((field_in("filtered.nc", "heights") - field_in("t_0.nc", "heights")).abs().maxCoeff() <=
          1e-12 * 0.4e-6);
  }
}

TEST_CASE("a measured map comes back from every format that holds doubles to the last bit",
          "[measured][exact]") {
  for (const Measurement& m : measurements) {
    require(std::string("asperity-convert ") + m.file + " -o first.npy");
    for (const std::string back :
         {"a.nc", "a.txt --to gwyddion-text", "a.sdf", "a.nrrd", "a.x3p", "a.asc", "a.gwy"}) {
      CAPTURE(m.file, back);
      require(std::string("asperity-convert ") + m.file + " -o " + back + " && asperity-convert " +
              back.substr(0, back.find(' ')) + " -o again.npy && cmp first.npy again.npy");
    }
  }
}

// ---- drawn surfaces ----

namespace {

// Their kernels are wider than the surfaces, whose sides have tori of other lengths than twice their own.
const std::string textures[] = {
    "--shape 27x51 --size 270um,510um --length 25px,15px --angle 30deg",
    "--shape 32x40 --size 320um,400um --length 20px --skewness 1 --kurtosis 5",
    "--shape 40x32 --size 400um,320um --model exponential-cosine --wavelength 11px --length 40px,20px "
    "--acf-tolerance 0.01",
    "--shape 60x1 --size 600um,10um --length 30px",
};

void draw_texture(const std::string& texture, const std::string& more) {
  require("asperity-generate -q --rq 0.4um --seed 5 --no-history " + texture + " " + more);
}

}  // namespace

TEST_CASE("a drawn surface carries the lags that its errors ask for, and the kernel if asked for",
          "[carried][exact]") {
  for (const std::string& texture : textures) {
    CAPTURE(texture);
    draw_texture(texture, "-o s.nc");
    draw_texture(texture, "--add kernel -o whole.nc");
    const Dataset data = read_dataset("s.nc"), whole = read_dataset("whole.nc");
    CHECK(data.at("heights").values == whole.at("heights").values);
    CHECK(whole.has("kernel"));
    for (const char* gone : {"kernel", "k", "l"}) CHECK_FALSE(data.has(gone));
    for (const char* gone : {"k", "l"}) CHECK(data.length(gone) == -1);
    const Shape lags = lags_of_errors(grid_of(data));
    for (const char* name : {"acf_target", "acf_achieved"}) {
      const Field all = table_of(whole, name), carried = table_of(data, name);
      CHECK(std::min(all.rows() - lags.nx, all.cols() / 2 - lags.ny) >= 1);
      REQUIRE(shape_of(carried) == Shape{lags.nx + 1, 2 * lags.ny + 1});
      CHECK((carried == all.block(0, all.cols() / 2 - lags.ny, lags.nx + 1, 2 * lags.ny + 1)).all());
    }
    CHECK(numbers(data.at("q").values).at(static_cast<std::size_t>(lags.ny)) == 0);
  }
}

// Tables that end at the last lag of the field changed Sz's error, which twins give, and the tests of lengths.
TEST_CASE("the lags that are left out change no figure and no error", "[carried][exact][slow]") {
  for (const std::string& texture : textures) {
    draw_texture(texture, "-o s.nc");
    draw_texture(texture, "--add kernel -o whole.nc");
    for (const std::string measure : {"asperity-stats", "asperity-stats --parameters height,material",
                                      "asperity-stats --remove-form plane", "asperity-acf --result profiles",
                                      "asperity-psd --result radial", "asperity-pdf", "asperity-validate"}) {
      const Outcome run = shell(measure + " -q s.nc"), all = shell(measure + " -q whole.nc");
      CAPTURE(texture, measure, run.error);
      CHECK(run.exit == all.exit);
      CHECK(run.out == all.out);
    }
  }
}

TEST_CASE("what comes behind a drawn surface carries no kernel either", "[carried][contract]") {
  draw_texture(textures[0], "| asperity-contact -q --radius 10mm --load 0.1N" + steel +
                                "| asperity-stress -q --depths 0,5um -o rough.nc");
  const Dataset data = read_dataset("rough.nc");
  CHECK(data.has("von_mises"));
  CHECK_FALSE(data.has("kernel"));
  CHECK(table_of(data, "acf_target").rows() == lags_of_errors(grid_of(data)).nx + 1);
}

// Where the kernel is wider than the surface, the table ends far from zero.
TEST_CASE("the autocorrelation that a surface carries is a target again", "[carried][law]") {
  for (const std::string& texture :
       {textures[0], std::string("--shape 40x32 --size 1mm --model self-affine --rolloff 20px")}) {
    draw_texture(texture, "-o s.nc");
    require("asperity-generate -q --acf s.nc --seed 6 --acf-tolerance 1e-3 -o twin.nc");
    const Field own = table_of(read_dataset("s.nc"), "acf_target"),
                twin = table_of(read_dataset("twin.nc"), "acf_achieved");
    REQUIRE(shape_of(twin) == shape_of(own));
    CHECK(greatest_difference(twin, own) <= 1e-3 * 0.16e-12);
  }
}

// The standard errors and the bias of Sku were those of heights about a mean that is known: refused by 8 of 8 seeds.
TEST_CASE("periodic surfaces whose correlation is as long as they are have the kurtosis prescribed",
          "[strangers][validate][statistics][slow]") {
  for (const std::string seed : {"1", "2", "3", "4"}) {
    CAPTURE(seed);
    require("asperity-generate --shape 48x48 --size 48um --rq 1um --periodic --length 30px --seed " + seed +
            " --count 60 -q -o 'v_%02d.nc' && asperity-validate -q v_*.nc");
  }
}

// The surfaces that they are compared with lose the same to their means: 8 of 8 ensembles were found to differ in
// their kurtosis.
TEST_CASE("skewed surfaces whose mean takes much of the variance are not found to differ",
          "[strangers][validate][contract]") {
  const std::string skewed =
      "asperity-generate --shape 64x64 --size 64um --rq 1um --skewness -1 --seed 1 -q --count ";
  require(skewed + "3 --length 20px --periodic -o 'w_%d.nc'; " + skewed + "12 --length 6px -o 'u_%d.nc'; " +
          "asperity-validate -q w_*.nc && asperity-validate -q u_*.nc");
}

// ---- distributions of contacts ----

namespace {

void press_flat() {
  require(
      "asperity-generate -q --shape 128x96 --size 1mm,0.75mm --rq 0.4um --length 8px --periodic --seed 3 "
      "| asperity-contact -q --load 40N -o pressed.nc" +
      steel);
}

}  // namespace

TEST_CASE("the distribution of the pressure counts the cells in contact, that of the gap the open ones",
          "[pdf-tool][contact][law]") {
  press_flat();
  const double cells = 128 * 96, load = 40, cell = 1e-3 * 0.75e-3 / cells;
  const Field state = field_in("pressed.nc", "contact");
  double counted = 0;
  for (const std::string variable : {"pressure", "gap"}) {
    const bool loaded = variable == "pressure";
    const Printed table = printed("asperity-pdf pressed.nc --bins 200 --variable " + variable);
    const auto &value = table[variable], &count = table["count"];
    const double width = value[1] - value[0];
    double sum = 0, share = 0, integral = 0, mean = 0;
    for (std::size_t k = 0; k < value.size(); ++k) {
      sum += count[k], share += table["share"][k], integral += table["density"][k] * width;
      mean += count[k] * value[k];
    }
    const double expected = static_cast<double>(loaded ? (state > 0).count() : (state == 0).count());
    CHECK(sum == expected);
    CHECK(relative_error(share, expected / cells) <= 1e-12);
    CHECK(relative_error(integral, 1) <= 1e-12);
    // Half a width is the most that a value differs from its bin's centre.
    const double total = loaded ? load / cell : attribute("pressed.nc", "contact_mean_gap") * cells;
    CHECK(std::abs(mean - total) <= sum * width / 2);
    CHECK(table["standard_error"][20] > 0);
    counted += sum;
  }
  CHECK(counted == cells);
}

TEST_CASE("a part of the cells has quantiles", "[pdf-tool][contact][contract]") {
  press_flat();
  const Printed table = printed("asperity-pdf pressed.nc --variable pressure --estimate quantiles --rows 9");
  CHECK(std::ranges::is_sorted(table["pressure"]));
  CHECK(table["pressure"].front() > 0);
  CHECK(table["standard_error"][4] > 0);
}

// Over ever so many surfaces the intervals cover 94 to 99 % (stats/uncertainty/share_error.hpp), and 1.96 errors, less
// than Student's t, some two per cent less: of 40, three standard errors of 92 % less, 31.
TEST_CASE("the errors of quantiles are those of contact after contact",
          "[pdf-tool][contact][statistics][slow]") {
  struct Medians {
    std::vector<double> values = {}, errors = {};
  };
  std::map<std::string, Medians> all{{"pressure", {}}, {"gap", {}}};
  for (int seed = 0; seed < 40; ++seed) {
    require(
        "asperity-generate --shape 128x128 --size 1mm --rq 0.4um --length 8px --model gaussian --periodic "
        "--seed " +
        std::to_string(seed) + " | asperity-contact -q --load 100N --tolerance 1e-4 -o pressed.nc" + steel);
    for (auto& [variable, medians] : all) {
      const Printed table =
          printed("asperity-pdf pressed.nc -q --estimate quantiles --rows 1 --variable " + variable);
      medians.values.push_back(table[variable][0]);
      medians.errors.push_back(table["standard_error"][0]);
    }
  }
  for (const auto& [variable, m] : all) {
    const double mean = std::accumulate(m.values.begin(), m.values.end(), 0.0) / 40;
    int covered = 0;
    for (std::size_t k = 0; k < m.values.size(); ++k)
      covered += std::abs(m.values[k] - mean) <= 1.96 * m.errors[k];
    CAPTURE(variable);
    CHECK(covered >= 31);
  }
}

// ---- the scene of Creţu, Bălan & Urzică (2009): two steel spheres of 50 mm pressed together by 5 kN, smooth and with
// roughness of 0.4 µm, 128 × 128 points on 3 mm × 3 mm ----

namespace {

const std::string scene = "--radius 50mm,50mm --load 5000N --yield 1200MPa --tolerance 1e-8" + steel +
                          "| asperity-stress --depths 0:0.8mm:32 --maximum -o scene.nc";
const std::string smooth_scene = "asperity-contact --smooth --shape 128x128 --size 3mm " + scene;

// Hertz, from R = 25 mm, E* = E / (2 (1 - ν²)): p0³ = 6 Q E*² / (π³ R²), a = π p0 R / (2 E*), δ = a² / R.
const double composite_modulus = 208e9 / (2 * (1 - 0.09)), sphere_radius = 25e-3;
const double hertz_pressure = std::cbrt(6 * 5000 * composite_modulus * composite_modulus /
                                        (std::pow(M_PI, 3) * sphere_radius * sphere_radius));
const double hertz_width = M_PI * hertz_pressure * sphere_radius / (2 * composite_modulus);

double scene_number(const std::string& name) { return attribute("scene.nc", name); }

}  // namespace

// The bounds are the errors of Love's discretisation at 23.4 µm, of order 2 in the spacing (tests/contact).
TEST_CASE("the smooth scene is Hertz's contact to the error of its grid", "[paper][exact]") {
  require(smooth_scene);
  CHECK(relative_error(scene_number("contact_max_pressure"), hertz_pressure) <= 1.4e-4);
  CHECK(relative_error(scene_number("contact_approach"), hertz_width * hertz_width / sphere_radius) <=
        3.3e-5);
  CHECK(scene_number("contact_residual") <= 1e-8);
  CHECK(std::abs(scene_number("contact_load_residual")) <= 1e-12);
  CHECK(scene_number("contact_plastic_area") == 0);
}

// Huber's field: 0.620041 p0 at 0.480864 a on the axis.
TEST_CASE("the smooth scene's greatest von Mises stress is 0.6200 p0 at 0.48 a below the centre",
          "[paper][exact]") {
  require(smooth_scene);
  CHECK(relative_error(scene_number("stress_max_von_mises"), 0.620041 * hertz_pressure) <= 0.005);
  CHECK(std::abs(scene_number("stress_max_depth") / hertz_width - 0.4809) <= 0.01);
  CHECK(std::abs(scene_number("stress_max_x")) <= 3e-3 / 128);
  CHECK(std::abs(scene_number("stress_max_y")) <= 3e-3 / 128);
}

TEST_CASE("a rough contact keeps to its limit pressure, its load and its residual", "[paper][law]") {
  require(smooth_scene);
  const double smooth_stress = scene_number("stress_max_von_mises");
  for (const std::string lengths : {"17px,4px", "13px,13px"}) {
    CAPTURE(lengths);
    require("asperity-generate --shape 128x128 --size 3mm --rq 0.4um --seed 7 --length " + lengths +
            " | asperity-contact " + scene);
    CHECK(scene_number("contact_max_pressure") <= 3600e6);
    CHECK(scene_number("contact_residual") <= 1e-8);
    CHECK(std::abs(scene_number("contact_load_residual")) <= 1e-12);
    CHECK(scene_number("contact_plastic_area") <= scene_number("contact_area"));
    // The paper's finding: the peak moves up under the asperities, above the smooth contact's.
    CHECK(scene_number("stress_max_von_mises") > smooth_stress);
    CHECK(scene_number("stress_max_depth") < 0.2 * hertz_width);
  }
}

// ---- what leaves the range of doubles ----

TEST_CASE("a column of a table holds no other numbers than it says", "[finite][contract]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   infinite = std::numeric_limits<double>::infinity();
  const auto refusal_of = [](double value, double deviation, double end) -> std::string {
    try {
      cli::check_finite(
          {{{"value", "m"}, {"error", "m", cli::Holds::unknown}, {"end", "m", cli::Holds::open}},
           {{1.0, 1.0, 1.0}, {value, deviation, end}}});
      return "";
    } catch (const DataError& error) {
      return error.name;
    }
  };
  CHECK(refusal_of(1, nan, -infinite).empty());
  CHECK(refusal_of(nan, 1, 1) == "value");
  CHECK(refusal_of(infinite, 1, 1) == "value");
  CHECK(refusal_of(1, -infinite, 1) == "error");
}
