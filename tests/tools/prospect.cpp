// What a surface will be and cost is told, or refused, before its kernel is solved for.
#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string square = "asperity-generate --shape 64x64 --size 1mm --rq 1um --seed 1 -o s.nc ";

void refused(const std::string& line, std::initializer_list<std::string> words) {
  const Outcome run = shell("rm -f s.nc; " + line);
  CAPTURE(line, run.error);
  CHECK(run.exit == 2);
  CHECK(lines(run.error) == 1);
  for (const std::string& word : words) CHECK_THAT(run.error, ContainsSubstring(word));
  CHECK(shell("ls s.nc").exit != 0);
}

// One line, though every step of an iteration would be one too.
void refused_before_any_step(const std::string& line, std::initializer_list<std::string> words) {
  refused(line + " -v", words);
}

// The only line of a run that succeeds.
std::string warned(const std::string& line) {
  const Outcome run = shell(line);
  CAPTURE(line, run.error);
  CHECK(run.exit == 0);
  CHECK(lines(run.error) <= 1);
  return run.error;
}

}  // namespace

// 5 mm on 1 mm took a minute and 590 MB for a surface that was flat but for an offset.
TEST_CASE("a surface that would be an offset more than rough is refused before its kernel is solved for",
          "[prospect][contract]") {
  refused_before_any_step(square + "--length 5mm", {"--length", "79 %"});
  refused_before_any_step(square + "--length 320px", {"--length", "79 %"});
  refused_before_any_step(square + "--model gaussian --length 5mm", {"--length"});
  refused_before_any_step("asperity-kernel --shape 64x64 --size 1mm --length 5mm -o s.nc", {"--length"});
  refused_before_any_step("asperity-generate --shape 1x64 --size 1mm --rq 1um --length 5mm -o s.nc",
                          {"--length"});
  REQUIRE(shell("asperity-kernel -q --length 40px,4px -o k.nc").exit == 0);
  refused_before_any_step("asperity-generate --kernel k.nc --shape 10x2 --size 1mm --rq 1um -o s.nc",
                          {"--shape"});
  CHECK(shell("asperity-generate --shape 1x1 --size 1mm --rq 1um --length 5mm -o one.nc").exit == 0);
  const Outcome corner = shell(square + "--periodic --model self-affine --rolloff 16mm");
  CHECK(
      (corner.exit == 2 && corner.error.find("--rolloff: the correlation is too long") != std::string::npos));
  REQUIRE(shell("printf '1 1 1\\n1 1 1\\n1 1 1\\n' > flat.txt").exit == 0);
  refused_before_any_step("asperity-generate --acf flat.txt --shape 3x3 --size 1mm --rq 1um -o s.nc",
                          {"--acf"});
}

TEST_CASE("a kernel or a drawing that the memory does not hold is refused before the kernel is solved for",
          "[prospect][contract]") {
  const std::string wide = "asperity-generate --shape 512x512 --size 1mm --rq 1um --length 0.3mm -o s.nc ";
  refused_before_any_step(wide + "--memory 100MB", {"--memory", "100MB", "lags needs some", "acf-tolerance"});
  refused_before_any_step("asperity-kernel --length 154px -o s.nc --memory 100MB", {"--memory"});
  // Gigabytes were told as "1e+03MB".
  refused_before_any_step("asperity-kernel --length 1000px -o s.nc --memory 1500MB", {"--memory", "1500MB"});
  refused_before_any_step(
      "asperity-generate --shape 64x1048576 --size 64mm,1048576mm --rq 1um --length 20px -o s.nc "
      "--memory 100MB",
      {"--memory", "does not hold one strip"});
}

// It falls from 5e-3 to 1e-3 over nearly as many lags again, all of which are tried in turn, for minutes.
TEST_CASE("a correlation that falls slowly is told what it may take before it is solved for",
          "[prospect][contract][slow]") {
  const Outcome slow = shell("asperity-kernel -q --model self-affine --length 77px --memory 190MB -o s.nc");
  CAPTURE(slow.error);
  CHECK(slow.exit == 2);
  CHECK_THAT(slow.error, Catch::Matchers::StartsWith(
                             "asperity-kernel: warning: a kernel of 651x651 lags may need minutes"));
  CHECK(shell("asperity-kernel -q --length 77px -o s.nc").error.empty());
  REQUIRE(shell("asperity-kernel -q --length 20px --lags 100x100 -o table.nc").exit ==
          0);  // whose table has 200 x 200
  const Outcome table = shell("asperity-kernel -q --acf table.nc -o s.nc");
  CHECK(table.exit == 0);
  CHECK_THAT(table.error,
             ContainsSubstring("200x200 lags may need minutes") && ContainsSubstring("--max-lag"));
}

TEST_CASE("the default of --memory is told in words that are the same on every machine",
          "[prospect][contract]") {
  for (const char* tool : {"kernel", "generate", "stats", "stress"}) {
    const Outcome help = shell(std::string("asperity-") + tool + " --help | tr -s ' \\n' ' '");
    CAPTURE(tool);
    CHECK_THAT(help.out, ContainsSubstring("--memory SIZE "));
    CHECK_THAT(help.out, ContainsSubstring("Default: half of the machine's"));
  }
}

// Over u = 0 … 1 of the length the mean of 10^(-u) weighed by 2 (1 - u) is 0.53; the lags of 64 points come
// within 0.01.
TEST_CASE("a lay longer than the surface is warned of with what heights share along it",
          "[prospect][exact]") {
  CHECK_THAT(warned(square + "--length 1mm,40um"),
             ContainsSubstring("reaches across the surface along x: heights correlate by 0.53 there"));
  CHECK_THAT(warned(square + "--length 1mm"), ContainsSubstring("along x and y"));
  CHECK_THAT(warned(square + "-q --length 40um,1mm"), ContainsSubstring("along y"));
  CHECK(warned(square + "--length 0.8mm,40um").empty());
  CHECK(warned("asperity-generate --shape 64x1 --size 1mm --rq 1um --length 0.8mm -o s.nc").empty());
}

TEST_CASE("a correlation that ends within a sample is warned of as white noise", "[prospect][contract]") {
  CHECK_THAT(warned(square + "--length 0.1px"), ContainsSubstring("below a sample along x and y"));
  CHECK_THAT(warned(square + "-q --length 1um,40um"), ContainsSubstring("below a sample along x:"));
  CHECK_THAT(warned("asperity-kernel -q --length 4px,0.4px -o k.nc"),
             ContainsSubstring("below a sample along y:"));
  CHECK(warned(square + "--length 0.6px").empty());
  CHECK(warned("asperity-generate --shape 64x1 --size 64um,1mm --rq 0.1um --length 4um -o s.nc").empty());
}

TEST_CASE("a wave of less than two samples along an axis is refused, for it would look like a longer one",
          "[prospect][contract]") {
  const std::string cosine = "--model exponential-cosine --length 6px --lags 8x8 ";
  refused_before_any_step(square + cosine + "--wavelength 1.5px", {"--wavelength", "1.5", "at least 2"});
  refused_before_any_step(square + cosine + "--wavelength 20um", {"--wavelength", "1.28 samples"});
  refused_before_any_step("asperity-kernel --spacing 2um,1um -o s.nc " + cosine + "--wavelength 3um",
                          {"--wavelength"});
  // Across x it is the samples of y that count.
  CHECK(
      shell("asperity-kernel --spacing 2um,1um -o s.nc " + cosine + "--angle 90deg --wavelength 3um").exit ==
      0);
  CHECK(shell(square + cosine + "--wavelength 2px").exit == 0);
}

TEST_CASE("an angle of more than a turn is refused", "[prospect][contract]") {
  const std::string kernel = "asperity-kernel --length 4px,2px --lags 4x4 -o s.nc --angle ";
  refused_before_any_step(kernel + "361deg", {"--angle", "360"});
  refused_before_any_step(kernel + "-7rad", {"--angle", "360"});
  refused_before_any_step(kernel + "1e300deg", {"--angle", "360"});
  for (const char* angle : {"360deg", "-360deg", "6.283185307179586rad"})
    CHECK(shell(kernel + angle).exit == 0);
}

// Its square is infinite, and a surface of NaN was written.
TEST_CASE("an rms height or a size whose square is no number is refused", "[prospect][contract]") {
  const std::string draw = "asperity-generate --shape 8x8 -o s.nc ";
  for (const char* rq : {"1e300m", "1e-300m", "infm", "0m", "-1um"}) {
    refused_before_any_step(draw + "--size 1mm --length 2px --rq=" + rq, {"--rq"});
    REQUIRE(shell("asperity-kernel -q --length 2px -o k.nc").exit == 0);
    refused(draw + "--size 1mm --kernel k.nc --rq=" + rq, {"--rq"});
  }
  refused(draw + "--size 1e300m --kernel k.nc --rq 1um", {"--size"});
}

// A kernel that reached around the surface was averaged with itself: 4.2 um of Sq in place of 1. At (32, 0)
// of 64 x 64 points the next period adds R(32, 0) = 0.0251 and 2 R(32, 64) = 0.0005.
TEST_CASE("a periodic surface that the correlation reaches around says how much that changes",
          "[prospect][contract]") {
  CHECK_THAT(warned(square + "-q --length 20px --periodic"),
             ContainsSubstring("changes the autocorrelation by up to 0.026 of the variance"));
  CHECK_THAT(warned(square + "--length 9px --periodic"), ContainsSubstring("by up to 0.00028 of"));
  CHECK(warned(square + "--length 2px --periodic").empty());
}
