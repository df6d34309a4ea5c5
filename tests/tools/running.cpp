// What a run tells while it goes on and when it is over, and that its bytes do not depend on how it is run.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <regex>

#include "support.hpp"
#include "tools/cli/progress.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity::test;

namespace {

const std::string draw =
    "asperity-generate --shape 64x48 --size 3mm --rq 0.4um --model gaussian --length 8px --seed 3 ";
const std::string fine = "asperity-generate --shape 512x512 --size 3mm --rq 0.4um --length 6px --seed 3 ";
const std::string press =
    "asperity-contact --radius 50mm --young 208GPa --poisson 0.3 --load 5kN --yield 1.2GPa ";
// Nothing to warn of: no limit pressure, and the largest stress lies deep.
const std::string smooth =
    "asperity-contact --smooth --shape 64x48 --size 3mm --radius 50mm --young 208GPa --poisson 0.3 --load "
    "5kN ";
const std::string wiped = "\r\033[K";

// The percentages of a tool's bar, in the order of their drawing.
std::vector<int> percentages(const std::string& transcript, const std::string& tool) {
  const std::regex form(tool + R"(: \[[#.]*\] +([0-9]+) %)");
  std::vector<int> out;
  for (std::sregex_iterator at(transcript.begin(), transcript.end(), form), end; at != end; ++at)
    out.push_back(std::stoi((*at)[1]));
  return out;
}

// What a terminal shows of each line before it is redrawn or ended.
std::vector<std::string> drawings(const std::string& transcript) {
  std::vector<std::string> out(1);
  for (std::size_t at = 0; at < transcript.size(); ++at)
    if (transcript[at] == '\r' || transcript[at] == '\n')
      out.emplace_back();
    else
      out.back() += transcript[at];
  return out;
}

// Of 1.52 s, CPU 2.9 s (2.7 s user, 0.2 s system), peak memory 61 MB the number of MB.
double peak_of(const std::string& told) {
  const std::regex form(
      R"(asperity-[a-z]+: [0-9.e-]+ s, CPU [0-9.e-]+ s \([0-9.e-]+ s user, [0-9.e-]+ s system\), peak memory ([0-9]+)MB\n)");
  std::smatch found;
  return std::regex_search(told, found, form) ? std::stod(found[1]) : NAN;
}

}  // namespace

// A surface of 64 MB that is kept, and by --memory one that is not; a program alone takes some 20.
TEST_CASE(
    "the option --time tells a peak of memory that holds the surface into a pipe, or none in strips",
    "[time][memory][law]") {
#ifdef __SANITIZE_ADDRESS__
  std::cout << "SKIPPED: the sanitizer takes memory of its own\n";
  return;
#endif
  const std::string large =
      "asperity-generate --shape 2048x4096 --size 3mm --rq 0.4um --length 6px --seed 3 ";
  const double whole = peak_of(shell(large + "--time | cat > large.nc").error);
  const double strips = peak_of(shell(large + "--time --memory 8MB -o large.nc").error);
  CAPTURE(whole, strips);
  CHECK(whole >= 67);
  CHECK(strips <= 60);
  CHECK(strips >= 4);
}

// Of a field of 1024 x 2048 points, 16.8 MB: the field, a half spectrum padded for lags up to half of it, one and
// a half, and half a field of lags; or the field, its half spectrum, and half a field of wave numbers. A
// quarter more for blocks and for megabytes that are rounded. A copy of the field was one more.
TEST_CASE("the ACF takes three fields of memory, a PSD two and a half", "[time][memory][law]") {
#ifdef __SANITIZE_ADDRESS__
  std::cout << "SKIPPED: the sanitizer takes memory of its own\n";
  return;
#endif
  constexpr double field = 16.8;
  const std::string heights = "asperity-generate --size 3mm --rq 0.4um --length 6px --seed 3 --shape ";
  require(heights + "1024x2048 -o large.nc; " + heights + "64x64 -o small.nc");
  for (const auto& [tool, fields] : {std::pair{"asperity-acf -o out.nc", 3.0},
                                     {"asperity-psd -o out.nc", 2.5},
                                     {"asperity-psd --result radial", 2.5},
                                     {"asperity-psd --result profiles", 2.5}}) {
    const std::string line = std::string(tool) + " --time --threads 1 ";
    const double large = peak_of(shell(line + "large.nc").error),
                 small = peak_of(shell(line + "small.nc").error);
    CAPTURE(tool, large, small);
    CHECK(large - small <= (fields + 0.25) * field);
  }
}

// The system's count of a process begins with the peak of the one that started it by vfork: 420 MB were told
// once.
TEST_CASE("the peak of memory is the run's own, whoever started it", "[time][memory][contract]") {
  const Outcome run = shell(draw +
                            "-o small.nc; python3 -c 'import subprocess; held = b\"x\" * 400_000_000; "
                            "subprocess.run([\"asperity-stats\", \"--time\", \"small.nc\"])'");
  CAPTURE(run.error);
  CHECK(run.exit == 0);
  CHECK(run.error.find("peak memory") != run.error.npos);
  CHECK(peak_of(run.error.substr(run.error.rfind("asperity-stats: "))) <= 200);
}

TEST_CASE("the option --time tells what a run took that failed or did not converge too", "[time][contract]") {
  const Outcome failed = shell("asperity-stats absent.nc --time");
  CHECK(failed.exit == 1);
  CHECK(lines(failed.error) == 2);
  CHECK(peak_of(failed.error) > 0);
  const Outcome unsolved =
      shell(draw + "| " + press + "--tolerance 1e-15 --max-convolutions 3 --time -o p.nc");
  CHECK(unsolved.exit == 3);
  CHECK(peak_of(unsolved.error) > 0);
}

TEST_CASE("streams of a seed drawn by two processes at a time are those drawn in a loop, to the byte",
          "[stream][law]") {
  require("export SOURCE_DATE_EPOCH=0; mkdir loop jobs; for k in 0 1 2 3; do (cd loop; " + draw +
          "--count 2 --stream $k -o s_${k}_%d.nc); done;"
          "cd jobs; seq 0 3 | xargs -P2 -I{} " +
          draw + "--count 2 --stream {} -o s_{}_%d.nc");
  const Outcome same =
      shell("diff -r loop jobs && ls jobs | wc -l && md5sum jobs/* | cut -c-32 | sort -u | wc -l");
  CHECK(same.out == "8\n8\n");
}

TEST_CASE("a dataset names seed, stream and surface, and they draw it again", "[stream][contract]") {
  require(draw + "--no-history --stream 5 --first 2 --count 2 -o s_%d.nc");
  const auto a = read_dataset("s_3.nc").attributes;
  CHECK(a.number("generate_seed", -1) == 3);
  CHECK(a.number("generate_stream", -1) == 5);
  CHECK(a.number("generate_surface", -1) == 3);
  require("export SOURCE_DATE_EPOCH=0; " + draw + "--no-history --stream 5 --first 3 -o one.nc; " + draw +
          "--no-history --stream 5 --first 2 --count 2 -o s_%d.nc; cmp one.nc s_3.nc");
  CHECK(shell(draw + "--stream -1 -o bad.nc").exit == 2);
}

TEST_CASE("the bytes of every stage do not depend on the number of threads", "[threads][law][slow]") {
  const Outcome run =
      shell("export SOURCE_DATE_EPOCH=0; for t in 1 2; do mkdir t$t; (cd t$t; export ASPERITY_THREADS=$t;" +
            draw + "--no-history -o s.nc;" + press +
            "--no-history s.nc -o p.nc;"
            "asperity-stress --no-history p.nc --depths 0:0.2mm:5 --maximum --components all -o v.nc;"
            "asperity-stats --parameters all s.nc > stats; asperity-acf s.nc --result profiles > acf;"
            "asperity-psd s.nc --result radial > psd; asperity-validate s.nc --significance 1e-9 > validate; "
            "asperity-pdf s.nc > pdf;"
            "asperity-report v.nc -o report.html); done; "
            "diff -r t1 t2 && ls t1 | wc -l");
  CAPTURE(run.error);
  CHECK(run.out == "9\n");
}

TEST_CASE("progress is a line that is wiped, on a terminal or by --progress always",
          "[progress][contract][slow]") {
  require(draw + "-o s.nc; " + press + "s.nc -o p.nc; " + smooth + "-o smooth.nc");
  const auto [command, told] = GENERATE(table<std::string, std::string>(
      {{draw + "-o a.nc", "Newton-Krylov, "},
       {draw + "--count 30 -o a_%d.nc", " of 30 surfaces"},
       {press + "s.nc -o a.nc", "64x48"},
       {press.substr(0, press.find("--load")) + "--sweep 2kN,5kN s.nc", " of 2 loads"},
       {"asperity-stats s.nc p.nc --compare", " of 2 surfaces"},
       {"asperity-stress smooth.nc --maximum -o a.nc", " layers searched"},
       {"asperity-stress smooth.nc --depths 0.2mm:1mm:30 -o a.nc", " of 30 layers"}}));
  CAPTURE(command);
  const Outcome always = shell(command + " --progress always");
  CHECK(always.exit == 0);
  CHECK_THAT(always.error, ContainsSubstring("\rasperity-") && ContainsSubstring(" %  "));
  CHECK_THAT(always.error, ContainsSubstring(told));
  CHECK(always.error.ends_with(wiped));
  CHECK(shell(command + " --progress always -q").error.empty());
  CHECK(shell(command).error.empty());
  CHECK(shell(command + " --progress never").error.empty());
  // `script` is a terminal on all three streams.
  const std::string on_terminal = "script -qec '" + command + "' /dev/null";
  CHECK_THAT(shell(on_terminal).out, ContainsSubstring("\rasperity-"));
  CHECK(shell(on_terminal + " --progress never").out.find("\rasperity-") == std::string::npos);
}

TEST_CASE("every iteration that a kernel takes has its progress, its name and its table",
          "[progress][contract][slow]") {
  const std::string cut =
      "asperity-kernel --length 31px --lags 31x31 -o cut.nc ";  // no kernel of these lags has it
  const std::string line = shell(cut + "--progress always").error, steps = shell(cut + "-v").error;
  for (const std::string name : {"Newton-Krylov", "projections", "least change"}) {
    CHECK_THAT(line, ContainsSubstring(name + ", "));
    CHECK_THAT(steps, ContainsSubstring(name + "\n"));
  }
}

TEST_CASE("the option --verbose tells each step of an iteration in a line under headings",
          "[progress][law]") {
  const Outcome kernel = shell("asperity-kernel --length 6px --lags 20x20 -v -o k.nc");
  CHECK_THAT(kernel.error, ContainsSubstring("     lags       step   products   residual\n"));
  const auto steps = read_dataset("k.nc").attributes.number("kernel_newton_iterations", -1);
  CHECK_THAT(kernel.error,
             ContainsSubstring("\n    20x20  " + std::string(8, ' ') + std::to_string(int(steps)) + "  "));

  const Outcome contact = shell(draw + "| " + press + "-v -o p.nc");
  CHECK_THAT(contact.error,
             ContainsSubstring("     grid  convolutions   residual  area [mm2]  greatest [MPa]\n"));
  CHECK_THAT(contact.error, ContainsSubstring("\n    64x48  "));

  const Outcome stress = shell(smooth + "| asperity-stress --depths 0:1mm:7 -v -o v.nc");
  CHECK(lines(stress.error) == 9);  // and the warning of the first layer
  CHECK_THAT(stress.error, ContainsSubstring("    layer  depth [um]  greatest von_mises [MPa]\n") &&
                               ContainsSubstring("\n        7        1000  "));
}

TEST_CASE("the bar never runs backwards: of grid after grid, and of one task after another",
          "[progress][law][slow]") {
  require(fine + "-o f.nc; " + smooth + "-o smooth.nc");
  const auto [command, first, last] = GENERATE(table<std::string, std::string, std::string>(
      {{press + "f.nc -o p.nc", "128x128", "512x512"},
       {fine + "--count 3 -o a_%d.nc", "Newton-Krylov", " of 3 surfaces"},
       {"asperity-stress smooth.nc --maximum --depths 0:1mm:30 -o a.nc", " searched", " of 30 layers"}}));
  const std::string line = require(command + " --progress always").error;
  CHECK_THAT(line, ContainsSubstring(first) && ContainsSubstring(last));
  const std::vector<int> percent = percentages(line, "asperity-[a-z]+");
  CAPTURE(line);
  CHECK(percent.size() >= 2);
  CHECK(std::ranges::is_sorted(percent));
}

TEST_CASE("of several tools in a pipe one at a time draws its progress on a terminal",
          "[progress][contract][slow]") {
  const std::string field = "asperity-generate --size 3mm --rq 0.4um ";
  const std::string pipe = field + "--shape 512x512 --length 40px --seed 2 | " + press + "-o p.nc; ";
  const std::string busy = field + "--shape 256x256 --length 6px --seed 1 --count 30 -o a_%d.nc & ";
  const std::string seen =
      require("script -qec 'stty cols 70; " + busy + pipe + "wait; echo alone; " + pipe + "' /dev/null").out;
  const std::string alone = seen.substr(seen.find("alone"));
  CHECK(seen.find("asperity-generate: [") != seen.npos);
  CHECK(alone.find("asperity-contact: [") != alone.npos);
  for (const std::string& drawn : drawings(seen)) {
    CAPTURE(drawn);
    CHECK(drawn.find("asperity-", 1 + drawn.find("asperity-")) == drawn.npos);
    if (drawn.find(" %") != drawn.npos) CHECK(drawn.substr(0, drawn.find('\033')).size() < 70);
  }
  CHECK(std::ranges::is_sorted(percentages(alone, "asperity-contact")));
}

TEST_CASE("a tool that finds the terminal taken draws nothing, and its messages clear the line",
          "[progress][contract]") {
  require(draw + "-o s.nc");
  const std::string run = press + "s.nc -o p.nc; ";
  const std::string seen =
      require("script -qec 'exec 9<$(tty); flock 9; " + run + "echo free; exec 9<&-; " + run + "' /dev/null")
          .out;
  CAPTURE(seen);
  const std::size_t drawn = seen.find("asperity-contact: [");
  CHECK(drawn != seen.npos);
  CHECK(drawn > seen.find("free"));
  CHECK_THAT(shell("script -qec 'asperity-stats absent.nc' /dev/null").out,
             Catch::Matchers::StartsWith(wiped + "asperity-stats: "));
}

TEST_CASE("the time left is shown when it can be, counts down, and rises when it is clearly too short",
          "[progress][law]") {
  asperity::cli::TimeLeft steady;
  steady.start(5, 0.2);
  CHECK_FALSE(steady.at(5.5, 0.3, 0.05));  // too early
  CHECK_FALSE(steady.at(7, 0.24, 0.05));   // too little
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-0.005, 0.005);
  double former = INFINITY;
  for (double t = 10; t < 45; t += 0.2) {
    const double left = steady.at(t, 0.2 + 0.8 * (t - 5) / 40 + jitter(random), 0.05).value();
    CHECK(left <= former);
    CHECK(std::abs(left - (45 - t)) < 4);
    former = left;
  }
  asperity::cli::TimeLeft slower;  // to a tenth of the rate at half of the work
  slower.start(0, 0);
  int rises = 0;
  former = INFINITY;
  for (double t = 1; t < 110; t += 0.2) {
    const double left = slower.at(t, t < 10 ? t / 20 : 0.5 + (t - 10) / 200, 0.05).value();
    rises += left > former;
    former = left;
  }
  CHECK(rises > 0);
  CHECK(rises < 40);
  CHECK(former < 5);
}
