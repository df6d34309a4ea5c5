// The options of the target and of the solution, as a user types them.
#include "acf/kernel.hpp"

#include <cmath>
#include <numbers>

#include "tools/kernel_runs.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("every target is at --length-level at its lengths, and its kernel has it over all lags",
          "[kernel][law]") {
  const std::pair<std::string, std::string> shapes[] = {
      {"exponential", ""},
      {"gaussian", ""},
      {"matern", " --smoothness 1.5"},
      {"stretched-exponential", " --exponent 0.7 --acf-tolerance 0.02"},
      {"self-affine", " --hurst 0.8 --acf-tolerance 0.02"}};
  for (const auto& [name, shape] : shapes) {
    const Attributes a = solved("--model " + name + shape + " --length 6px,3px --length-level 0.3");
    const Dataset data = read_dataset("solved.nc");
    const Field target = table_of(data, "acf_target"), achieved = table_of(data, "acf_achieved");
    const Index middle = target.cols() / 2;
    CAPTURE(name);
    CHECK(std::abs(target(6, middle) - 0.3) <= 1e-9);
    CHECK(std::abs(target(0, middle + 3) - 0.3) <= 1e-9);
    CHECK((target - achieved).abs().maxCoeff() <= a.number("kernel_acf_tolerance", 0));
    CHECK(a.text("kernel_target") == name);
    CHECK(a.number("kernel_level", 0) == 0.3);
  }
}

// 0.3 is its envelope's; at half a wavelength along the first axis the cosine is -1.
TEST_CASE("exponential-cosine oscillates with its wavelength below the envelope", "[kernel][exact]") {
  const Field target = target_of(
      "--model exponential-cosine --length 6px,4px --length-level 0.3 --wavelength 12px --acf-tolerance "
      "1e-2");
  CHECK(std::abs(target(6, target.cols() / 2) + 0.3) <= 1e-12);
  CHECK(std::abs(target(0, target.cols() / 2 + 4) - 0.3) <= 1e-12);
}

TEST_CASE("the shape of a target is recorded beside its name", "[kernel][contract]") {
  const std::string length = " --length 4px --acf-tolerance 0.05";
  CHECK(solved("--model matern --smoothness 2" + length).number("kernel_smoothness", 0) == 2);
  CHECK(solved("--model stretched-exponential --exponent 1.5" + length).number("kernel_exponent", 0) == 1.5);
  CHECK(solved("--model self-affine --hurst 0.7" + length).number("kernel_hurst", 0) == 0.7);
  CHECK(solved("--model exponential-cosine --wavelength 9px" + length).number("kernel_wavelength", 0) == 9);
  CHECK(solved("--length 4px").find("kernel_hurst") == nullptr);
}

// 20 µm and 5 µm on samples of 5 µm and 2.5 µm are 4 and 2 samples along the axes: at 30° the point (2√3, 4)
// in samples is 20 µm from the origin along the first axis, which no sample hits; but (p, q) = (2, 4) lies at
// 45°.
TEST_CASE("an angle turns the lengths in metres, in degrees or radians", "[kernel][exact]") {
  const std::string turned = "--length 20um,5um --spacing 5um,2.5um --acf-tolerance 0.01 --angle ";
  const Field target = target_of(turned + "45deg");
  const Index middle = target.cols() / 2;
  const double first = 2 * 5e-6 * std::numbers::sqrt2 / 20e-6, second = 2 * 5e-6 * std::numbers::sqrt2 / 5e-6;
  CHECK(target(2, middle + 4) == Approx(std::pow(0.1, first)).epsilon(1e-12));
  CHECK(target(2, middle - 4) == Approx(std::pow(0.1, second)).epsilon(1e-12));
  CHECK((target_of(turned + "0.78539816339744828rad") - target).abs().maxCoeff() <= 1e-14);
  CHECK(read_dataset("solved.nc").attributes.text("kernel_formulation") == "oriented");
  CHECK(
      (target_of("--length 4px,2px --spacing 5um,2.5um --acf-tolerance 0.01 --angle 45deg") == target).all());
}

TEST_CASE("an option that the target does not use, or cannot, is exit 2 and names the option",
          "[kernel][contract]") {
  const std::string kernel = "asperity-kernel --length 4px ";
  const std::pair<std::string, std::string> bad[] = {
      {"--hurst 0.5", "--hurst"},
      {"--model gaussian --smoothness 1", "--smoothness"},
      {"--model matern --exponent 1", "--exponent"},
      {"--model self-affine --wavelength 9px", "--wavelength"},
      {"--model exponential-cosine", "--wavelength"},
      {"--model exponential-cosine --wavelength 9um", "--wavelength"},
      {"--model exponential-cosine --wavelength 9", "--wavelength"},
      {"--model exponential-cosine --wavelength=-9px", "--wavelength"},
      {"--model bessel", "--model"},
      {"--model matern --smoothness 0", "--smoothness"},
      {"--model stretched-exponential --exponent 2.1", "--exponent"},
      {"--model self-affine --hurst nan", "--hurst"},
      {"--angle north", "--angle"},
      {"--angle 3mm", "--angle"},
      {"--angle inf", "--angle"},
      {"--formulation diagonal", "--formulation"},
      {"--method bisection", "--method"},
      {"--infeasible ignore", "--infeasible"},
      {"--acf-tolerance 0", "--acf-tolerance"},
      {"--tolerance 0", "--tolerance"},
      {"--length-level 0", "--length-level"}};
  for (const auto& [options, words] : bad) refused(kernel + options, 2, words);
  refused("asperity-kernel", 2, "--length");
  refused("asperity-kernel --length 4px,2px --angle 20deg --formulation symmetric", 2, "--formulation");
  refused("asperity-kernel --length 1mm", 2, "--length");
}

TEST_CASE("the lags that were chosen are told with their error, which keeps to --acf-tolerance",
          "[kernel][contract]") {
  const Outcome run = shell("asperity-kernel --length 9px,4px --acf-tolerance 1e-4 -o chosen.nc");
  REQUIRE(run.exit == 0);
  const Attributes a = read_dataset("chosen.nc").attributes;
  const std::vector<double> lags = numbers(*a.find("kernel_lags"));
  CHECK(lines(run.error) == 1);
  CHECK(run.error.starts_with("asperity-kernel: " + std::to_string(static_cast<int>(lags[0])) + "x" +
                              std::to_string(static_cast<int>(lags[1])) +
                              " lags chosen: error over all lags "));
  CHECK(a.number("kernel_error", 1) <= 1e-4);
  CHECK_THAT(shell("asperity-kernel --length 9px,4px --lags 20x9 -o given.nc").error,
             ContainsSubstring("only the 20x9 prescribed lags are met"));
  CHECK(shell("asperity-generate --length 9px,4px --shape 18x18 --size 1mm --rq 1um -o silent.nc")
            .error.empty());
  CHECK_THAT(
      shell("asperity-generate -v --length 9px,4px --shape 18x18 --size 1mm --rq 1um -o aloud.nc").error,
      ContainsSubstring("lags chosen"));
}

// Three lags of an exponential of six were met, and nothing said of the fourth, which was off by 0.15.
TEST_CASE("lags that were given are met, and what lies beyond them is told where it matters",
          "[kernel][contract]") {
  const Outcome few = shell("asperity-kernel -q --length 6px --lags 3x3 -o few.nc");
  CHECK(few.exit == 0);
  CHECK(
      (lines(few.error) == 1 && few.error.find("only the 3x3 prescribed lags are met") != std::string::npos));
  CHECK(shell("asperity-kernel -q --length 6px --lags 15x15 -o enough.nc").error.empty());
  // Of a table all lags are judged, those too that the kernel does not reach.
  write_text("far.txt", "1 0.5 0 0 0 0\n0.5 0.25 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0.3\n");
  const Outcome far = shell("asperity-kernel -q --acf far.txt --lags 2x2 -o far.nc");
  CHECK(far.error.find("error over all lags is 0.3 ") != std::string::npos);
}

// An exponential of which 10 % are left at the last of 31 lags has no kernel of 31 × 31.
TEST_CASE("a target without a kernel of these lags is met by a wider one, or refused", "[kernel][contract]") {
  const std::string cut = "asperity-kernel --length 31px --lags 31x31 -o cut.nc ";
  const Outcome wider = shell(cut);
  CAPTURE(wider.error);
  REQUIRE(wider.exit == 0);
  CHECK_THAT(wider.error, ContainsSubstring("wider") && ContainsSubstring("error over all lags is 0.00596"));
  const Dataset data = read_dataset("cut.nc");
  CHECK(data.attributes.text("kernel_answer") == "wider");
  CHECK(data.attributes.number("kernel_change", 1) <= 1e-9);
  CHECK(table_of(data, "kernel").rows() > 61);
  CHECK(lines(shell(cut + "-q").error) == 1);
  refused("asperity-kernel --length 31px --lags 31x31 --infeasible error", 2, "--lags");
}

TEST_CASE("an iteration that ends in no kernel leaves its library silent", "[kernel][contract]") {
  refused(
      "asperity-kernel --spacing 1um --formulation patir --model gaussian --lags 2x2 --length 2px,2px "
      "--length-level 0.1 --infeasible error",
      2, "no kernel of 2x2 lags");
}

TEST_CASE("the methods that moved to validation are refused with those that remain", "[kernel][contract]") {
  const std::string kernel = "asperity-kernel --length 6px --lags 9x9 ";
  refused(kernel + "--method conjugate-gradient", 2, "newton-krylov|spectral");
  refused(kernel + "--infeasible least-squares", 2, "auto|error|nearest");
}

TEST_CASE("every method and formulation is recorded, and the equations hold", "[kernel][law]") {
  for (const char* formulation : {"symmetric", "oriented", "patir"}) {
    const Outcome run =
        shell(std::string("asperity-kernel -q --length 4px,3px --lags 11x9 -o solved.nc --formulation ") +
              formulation);
    CAPTURE(formulation, run.error);
    REQUIRE(run.exit == 0);
    // Patir's mirrored lags are off by a tenth, which is said.
    CHECK((lines(run.error) == 1) == (std::string(formulation) == "patir"));
    const Attributes a = read_dataset("solved.nc").attributes;
    CHECK(a.text("kernel_method") == "newton-krylov");
    CHECK(a.text("kernel_formulation") == formulation);
    CHECK(a.number("kernel_residual", 1) <= 1e-10);
  }
  const Outcome root = shell("asperity-kernel -q --length 4px,3px --method spectral -o solved.nc");
  CHECK_THAT(root.error, ContainsSubstring("the root of the spectrum changes the autocorrelation by up to"));
  CHECK(read_dataset("solved.nc").attributes.text("kernel_answer") == "spectral");
}

// ---- tables ----
