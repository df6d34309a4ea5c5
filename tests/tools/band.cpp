// Surfaces with --cutoff and --rolloff, and --periodic kernels, as they are typed.
#include <array>
#include <complex>
#include <numbers>

#include "acf/radial.hpp"
#include "core/words.hpp"
#include "tools/kernel_runs.hpp"
#include "transform/plan.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr double turn = 2 * std::numbers::pi;

// |z^|²/(N M)² of the heights, half spectrum [j][k].
std::vector<double> powers(const Field& z) {
  const RealTransform2D transform(shape_of(z));
  AlignedVector<Complex> spectrum(size(transform.spectrum_size()));
  transform.forward(z.data(), spectrum.data());
  std::vector<double> out(spectrum.size());
  const double points = static_cast<double>(z.size());
  std::ranges::transform(spectrum, out.begin(), [&](Complex c) { return std::norm(c / points); });
  return out;
}

}  // namespace

// Each of the K waves (j,k), (-j,-k) taken together, has an exponentially distributed power: the mean of
// power over law is 1 with the standard error 1/√K. Rounding is ε log2(N M) < 16 ε of the rms height, squared.
TEST_CASE("a drawn surface has no power beyond its cut-off, and within it that of the law asked for",
          "[band][statistics]") {
  const Index n = 128;
  const double rolloff = 32, cutoff = 8, hurst = 0.8, rms = 1e-6;
  require(
      "asperity-generate -q --periodic --shape 128x128 --size 1mm --rq 1um --model self-affine --hurst 0.8 "
      "--rolloff 0.25mm --cutoff 8px --seed 1 -o b.nc");
  const Dataset data = read_dataset("b.nc");
  const std::vector<double> power = powers(field_of(data, "heights"));
  double total = 0;
  auto law = [&](double wave) { return std::pow(std::max(wave * rolloff / 128, 1.0), -2 * (1 + hurst)); };
  auto number_of = [&](Index j, Index k) {
    return std::hypot(static_cast<double>(2 * j > n ? j - n : j), static_cast<double>(k));
  };
  auto inside = [&](double wave) { return wave > 0 && wave <= 128 / cutoff * (1 + 1e-9); };
  for (Index j = 0; j < n; ++j)
    for (Index k = 0; k <= n / 2; ++k)
      if (inside(number_of(j, k))) total += (k == 0 ? 1 : 2) * law(number_of(j, k));
  for (const auto& [from, to] : {std::pair{0., 4.}, {4., 8.}, {8., 12.}, {12., 16.1}}) {
    double sum = 0, count = 0;
    for (Index j = 0; j < n; ++j)
      for (Index k = 0; k <= n / 2; ++k) {
        const double wave = number_of(j, k), own = power[size(j * (n / 2 + 1) + k)];
        if (!inside(wave)) CHECK(own <= std::pow(16 * epsilon * rms, 2));
        if (!inside(wave) || wave <= from || wave > to) continue;
        const double half = k == 0 ? 0.5 : 1;  // of k = 0 both of a pair are here
        sum += half * own / (law(wave) / total * rms * rms), count += half;
      }
    CAPTURE(from, to, count);
    CHECK(std::abs(sum / count - 1) <= 4 / std::sqrt(count));
  }
  CHECK(data.attributes.number("kernel_cutoff", 0) == 8);
  CHECK(data.attributes.number("kernel_error", 1) <= 1e-14);
  CHECK(data.attributes.number("kernel_converged", 0) == 1);
}

// Means of power over law, of K pairs of waves, as above; of a turned exponential that is flat below 16 × 10 of
// 64 samples. e < 1 is nearer to zero than the ellipse, where the law is that of the ellipse.
TEST_CASE("a drawn surface of any model is flat below its roll-off", "[band][statistics]") {
  const Index n = 64;
  require(
      "asperity-generate -q --periodic --shape 64x64 --size 64um --rq 1um --length 40px --length-level "
      "0.3678794411714423 --rolloff 16um,10um --angle 0.5rad --cutoff 4px --seed 5 -o b.nc");
  const Dataset data = read_dataset("b.nc");
  const std::vector<double> power = powers(field_of(data, "heights"));
  struct Sum {
    double power = 0, count = 0;
  };
  std::array<Sum, 3> sums;
  double total = 0;
  for (Index j = 0; j < n; ++j)
    for (Index k = 0; k <= n / 2; ++k) {
      const double qx = turn / 64 * static_cast<double>(2 * j > n ? j - n : j),
                   qy = turn / 64 * static_cast<double>(k);
      const double q = std::hypot(qx, qy), along = std::cos(0.5) * qx + std::sin(0.5) * qy,
                   across = std::cos(0.5) * qy - std::sin(0.5) * qx;
      if (q == 0 || q > turn / 4 * (1 + 1e-9)) continue;
      const double e = std::hypot(along * 16, across * 10) / turn;
      const double law = std::pow(1 + std::pow(40 * q / std::min(1.0, e), 2), -1.5), pairs = k == 0 ? 0.5 : 1;
      Sum& sum = sums[e < 1 ? 0 : e < 2 ? 1 : 2];
      sum.power += pairs * power[size(j * (n / 2 + 1) + k)] / law, sum.count += pairs;
      total += 2 * pairs * law;
    }
  for (const Sum& sum : sums)
    CHECK(std::abs(sum.power * total / (sum.count * 1e-12) - 1) <= 4 / std::sqrt(sum.count));
  CHECK(sums[0].count >= 19);
  CHECK(numbers(*data.attributes.find("kernel_rolloff")) == std::vector<double>{16, 10});
  CHECK(data.attributes.text("kernel_formulation") == "oriented");
  CHECK(data.attributes.number("kernel_error", 1) <= 1e-14);
}

// The variance of one surface about its mean has the standard error σ²√(Σ P²·2): below 0.2 of σ² of these 44
// pairs of waves, and a tenth of that of 100 surfaces.
TEST_CASE("the rms height is what was asked for after the cut, about a mean that is zero",
          "[band][statistics]") {
  require(
      "asperity-generate -q --periodic --shape 32x24 --size 32um,24um --rq 1um --model matern --length "
      "9px,4px "
      "--angle 30deg --cutoff 5px --seed 1 --count 100 -o r_%02d.nc");
  double sum = 0, squares = 0;
  for (int i = 0; i < 100; ++i) {
    const Field z =
        field_of(read_dataset(std::string("r_") + (i < 10 ? "0" : "") + std::to_string(i) + ".nc"),
                 "heights") /
        1e-6;
    CHECK(std::abs(z.mean()) <= 100 * epsilon);
    const double m = z.square().mean();
    sum += m / 100, squares += m * m / 100;
  }
  const double error = std::sqrt((squares - sum * sum) / 99);
  CHECK(error <= 0.05);
  CHECK(std::abs(sum - 1) <= 4 * error);
}

TEST_CASE("a roll-off is a length of the self-affine model by its corner", "[band][exact]") {
  const Field target = target_of("--model self-affine --hurst 0.7 --rolloff 20px,30px --acf-tolerance 0.05");
  const SelfAffineCorrelation rho(0.7);
  const Index middle = target.cols() / 2;
  for (const Index lag : {1, 3, 6}) {
    CHECK(std::abs(target(lag, middle) - rho(turn * static_cast<double>(lag) / 20)) <= 1e-11);
    CHECK(std::abs(target(0, middle + lag) - rho(turn * static_cast<double>(lag) / 30)) <= 1e-11);
  }
}

// Heights of both ways differ by the rounding of kernel and transform, 1e-13 of the rms height.
TEST_CASE("asperity-kernel --periodic solves what asperity-generate --periodic draws", "[band][contract]") {
  for (const std::string target :
       {"--model self-affine --rolloff 12px --cutoff 4px", "--length 9px --rolloff 12px,7px --angle 20deg",
        "--length 9px", "--length 3px",
        "--model exponential-cosine --length 8px,5px --wavelength 6px --angle 0.4rad --cutoff 3px"}) {
    CAPTURE(target);
    require("asperity-kernel -q --periodic --shape 24x20 " + target + " -o k.nc");
    require(
        "asperity-generate -q --periodic --kernel k.nc --shape 24x20 --size 24um,20um --rq 1um --seed 4 -o "
        "a.nc");
    require("asperity-generate -q --periodic --shape 24x20 --size 24um,20um --rq 1um --seed 4 -o b.nc " +
            target);
    const Field one = field_of(read_dataset("a.nc"), "heights"),
                two = field_of(read_dataset("b.nc"), "heights");
    CHECK((one - two).abs().maxCoeff() <= 1e-13 * 1e-6);
  }
  // The period is the shape, and the spacing of the lags the kernel's.
  require(
      "asperity-kernel -q --periodic --shape 24x20 --spacing 1um --rq 1um --model gaussian --length 6px "
      "--cutoff 4px | "
      "asperity-generate -q --periodic --seed 4 -o c.nc");
  const Dataset drawn = read_dataset("c.nc");
  CHECK(shape_of(field_of(drawn, "heights")) == Shape{24, 20});
  CHECK(grid_of(drawn).dx == Approx(1e-6).epsilon(1e-12));
  CHECK(grid_of(drawn).periodic.both());
  // A table of a whole period gives the shape too; of another period it is any surface's.
  require("asperity-acf c.nc --absolute -o t.nc; asperity-kernel -q --periodic --acf t.nc -o twin.nc");
  CHECK(numbers(*read_dataset("twin.nc").attributes.find("kernel_period")) == std::vector<double>{24, 20});
}

// Noise of some skewness through the same kernel: no other waves come in.
TEST_CASE("the option --method filter keeps the band of heights that are not Gaussian", "[band][exact]") {
  require(
      "asperity-generate -q --periodic --shape 64x64 --size 1mm --rq 1um --model gaussian --length 6px "
      "--cutoff 8px "
      "--skewness 0.05 --kurtosis 3.01 --method filter --seed 1 -o f.nc");
  const std::vector<double> power = powers(field_of(read_dataset("f.nc"), "heights"));
  for (Index j = 9; j <= 32; ++j) CHECK(power[size(j * 33)] <= std::pow(16 * epsilon * 1e-6, 2));
}

TEST_CASE("a cut-off or a roll-off that makes no sense is refused in one line that names its bound",
          "[band][contract]") {
  const std::string draw = "asperity-generate --size 64um --rq 1um --seed 1 --shape 64x64 ";
  const std::string periodic = draw + "--periodic --length 9px ";
  refused(draw + "--length 9px --cutoff 4px", 2, "--cutoff: 4px: needs --periodic");
  refused("asperity-kernel --length 9px --cutoff 4px", 2, "needs --periodic");
  refused("asperity-kernel --periodic --length 9px --cutoff 4px", 2, "--shape is required by --periodic");
  refused(periodic + "--cutoff 1.9px", 2, "--cutoff: 1.9px: below two samples, 2px");
  refused(periodic + "--cutoff 1900nm", 2, "below two samples, 2um");
  refused(periodic + "--cutoff 65px", 2, "above the shorter side of the surface, 64px");
  refused(periodic + "--cutoff 0.1mm", 2, "above the shorter side of the surface, 64um");
  refused(periodic + "--cutoff 4", 2, "has no unit");
  refused(periodic + "--cutoff nanpx", 2, "--cutoff");
  refused(periodic + "--cutoff=-4px", 2, "below two samples");
  refused(periodic + "--cutoff infpx", 2, "above the shorter side");
  refused(draw + "--length 9px --rolloff 20px", 2, "--rolloff needs --periodic, or --model self-affine");
  refused(draw + "--periodic --rolloff 20px", 2,
          "--length is required: --rolloff is the length of self-affine");
  refused(periodic + "--rolloff 65px", 2, "--rolloff: 65px: above the shorter side of the surface, 64px");
  refused(periodic + "--rolloff 20px,1px", 2, "--rolloff 20px,1px: 1px: below two samples, 2px");
  refused(periodic + "--rolloff 20px --cutoff 21px", 2, "--cutoff: 21px: above the roll-off, 20px");
  refused(periodic + "--model exponential-cosine --wavelength 12px --rolloff 10px", 2,
          "--rolloff: 10px: below --wavelength, 12px");
  refused(periodic + "--rolloff 20px --lags 9x9", 2, "--lags cannot be combined with --rolloff");
  refused(periodic + "--rolloff 20px --skewness 1", 2, "--skewness cannot be combined with --rolloff");
  refused(periodic + "--model stretched-exponential --rolloff 20px", 2, "--model: stretched-exponential");
  refused(periodic + "--model self-affine --rolloff 9px", 2, "--length cannot be combined with --rolloff");
  refused(periodic + "--model stretched-exponential --cutoff 4px", 2, "--model: stretched-exponential");
  refused(periodic + "--cutoff 4px --lags 9x9", 2, "--lags cannot be combined with --cutoff");
  refused(periodic + "--cutoff 4px --method spectral", 2, "--method: spectral");
  refused(periodic + "--cutoff 4px --skewness 1", 2, "--skewness cannot be combined with --cutoff");
  refused(periodic + "--cutoff 4px --memory 300kB", 2, "--memory");
  refused(draw + "--periodic --model self-affine --rolloff 12px --cutoff 13px", 2,
          "above the roll-off, 12px");
  refused(draw + "--periodic --model self-affine --rolloff 0px", 2, "--rolloff");
  refused(draw + "--periodic --model self-affine --cutoff 4px", 2, "is required");
  refused(
      "asperity-generate --periodic --size 64um,1um --rq 1um --seed 1 --shape 64x1 --length 9px --cutoff 4px",
      2, "--cutoff: 4px: needs a surface: the waves of 64x1 points run along one axis");
}
