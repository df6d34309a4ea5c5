// What a drawn surface carries of the autocorrelation that it was drawn with.
#include "dataset/layout.hpp"
#include "stats/measure/surface.hpp"
#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Their kernels are wider than the surfaces, whose sides have tori of other lengths than twice their own.
const std::string textures[] = {
    "--shape 27x51 --size 270um,510um --length 25px,15px --angle 30deg",
    "--shape 32x40 --size 320um,400um --length 20px --skewness 1 --kurtosis 5",
    "--shape 40x32 --size 400um,320um --model exponential-cosine --wavelength 11px --length 40px,20px "
    "--acf-tolerance 0.01",
    "--shape 60x1 --size 600um,10um --length 30px",
};

void draw(const std::string& texture, const std::string& more) {
  require("asperity-generate -q --rq 0.4um --seed 5 --no-history " + texture + " " + more);
}

}  // namespace

TEST_CASE("a drawn surface carries the lags that its errors ask for, and the kernel if asked for",
          "[carried][exact]") {
  for (const std::string& texture : textures) {
    CAPTURE(texture);
    draw(texture, "-o s.nc");
    draw(texture, "--add kernel -o whole.nc");
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
TEST_CASE("the lags that are left out change no figure and no error", "[carried][exact]") {
  for (const std::string& texture : textures) {
    draw(texture, "-o s.nc");
    draw(texture, "--add kernel -o whole.nc");
    for (const std::string measure : {"asperity-stats", "asperity-stats --parameters height --errors twins",
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
  draw(textures[0],
       "| asperity-contact -q --radius 10mm --young 208GPa --poisson 0.3 --load 0.1N | "
       "asperity-stress -q --depths 0,5um -o rough.nc");
  const Dataset data = read_dataset("rough.nc");
  CHECK(data.has("von_mises"));
  CHECK_FALSE(data.has("kernel"));
  CHECK(table_of(data, "acf_target").rows() == lags_of_errors(grid_of(data)).nx + 1);
}

TEST_CASE("a surface is drawn again from the kernel that was kept with it, else the answer says what to give",
          "[carried][contract]") {
  draw(textures[0], "-o s.nc");
  draw(textures[0], "--add kernel,noise -o whole.nc");
  CHECK(read_dataset("whole.nc").has("noise"));
  require("asperity-generate -q --seed 5 < whole.nc > again.nc");
  CHECK(read_dataset("again.nc").at("heights").values == read_dataset("s.nc").at("heights").values);
  CHECK_FALSE(read_dataset("again.nc").has("kernel"));
  CHECK_THAT(require("asperity-generate --seed 5 < whole.nc > again.nc").error, !ContainsSubstring("kernel"));
  for (const char* line :
       {"asperity-generate --seed 5 -o absent.nc < s.nc", "asperity-generate --kernel s.nc -o absent.nc"}) {
    const Outcome run = shell(line);
    CAPTURE(line, run.error);
    CHECK(run.exit == 4);
    CHECK(lines(run.error) == 1);
    for (const char* words : {"kernel: ", "--add kernel", "--acf"})
      CHECK_THAT(run.error, ContainsSubstring(words));
  }
  CHECK(shell("ls absent.nc").exit != 0);
}

// Where the kernel is wider than the surface, the table ends far from zero.
TEST_CASE("the autocorrelation that a surface carries is a target again", "[carried][law]") {
  for (const std::string& texture :
       {textures[0], std::string("--shape 40x32 --size 1mm --model self-affine --rolloff 20px")}) {
    draw(texture, "-o s.nc");
    require("asperity-generate -q --acf s.nc --seed 6 --acf-tolerance 1e-3 -o twin.nc");
    const Field own = table_of(read_dataset("s.nc"), "acf_target"),
                twin = table_of(read_dataset("twin.nc"), "acf_achieved");
    REQUIRE(shape_of(twin) == shape_of(own));
    CHECK((twin - own).abs().maxCoeff() <= 1e-3 * 0.16e-12);
  }
}
