#include <fcntl.h>
#include <unistd.h>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string draw =
    "asperity-generate --shape 1500x40 --size 15mm,0.4mm --rq 0.4um --length 4px --seed 7 --no-history";
// The surface takes 480 kB, which this does not leave for it beside a strip.
const std::string tight = " --memory 1100kB";

// All but the clock.
std::string bytes_of(const std::string& name) {
  Dataset data = read_dataset(name);
  for (const char* timing : {"kernel_seconds", "generate_seconds"}) data.attributes.erase(timing);
  return encode_netcdf(data);
}

}  // namespace

TEST_CASE(
    "the bytes of a surface depend neither on the memory, nor on the threads, nor on whether they go to a "
    "file "
    "or a pipe",
    "[generate][law][slow]") {
  for (const std::string option : {"", " --exact-rq", " --add noise", " --periodic --add noise --exact-rq"}) {
    require(draw + option + " -o whole.nc");
    const std::string whole = bytes_of("whole.nc");
    for (const std::string& how :
         {draw + option + tight + " --threads 1 -o other.nc",
          draw + option + tight + " --threads 5 -o other.nc", draw + option + " | cat > other.nc",
          draw + option + tight + " | cat > other.nc", draw + option + tight + " > other.nc",
          "rm other.nc; " + draw + option + tight + " >> other.nc"}) {
      require(how);
      CAPTURE(how);
      CHECK(bytes_of("other.nc") == whole);
    }
  }
}

TEST_CASE("a surface that goes to a file as it is made tells its range and the seconds that it took",
          "[generate][exact]") {
  require(draw + tight + " --add noise -o strips.nc");
  const Dataset data = read_dataset("strips.nc");
  for (const char* name : {"heights", "noise"}) {
    const Field field = field_of(data, name);
    CHECK(numbers(*data.at(name).attributes.find("actual_range")) ==
          std::vector<double>{field.minCoeff(), field.maxCoeff()});
  }
  CHECK(data.attributes.number("generate_seconds", 0) > 0);
}

TEST_CASE("too little memory is exit 2 and names the least, which is enough", "[generate][contract]") {
  require("asperity-kernel --rq 0.4um --length 4px --spacing 10um -o kernel.nc");
  const std::string draw = "asperity-generate --kernel kernel.nc --shape 1500x40 --seed 7 --no-history";
  const Outcome refused = shell(draw + " --memory 20kB -o absent.nc; echo $?; ls absent.nc");
  CHECK(refused.out == "2\n");
  const std::string words = "--memory: 20kB does not hold one strip of this surface: ";
  REQUIRE_THAT(refused.error, ContainsSubstring(words));
  const auto begin = refused.error.find(words) + words.size();
  const std::string least = refused.error.substr(begin, refused.error.find(' ', begin) - begin);
  require(draw + " --memory " + least + " -o least.nc");
  require(draw + " -o whole.nc");
  CHECK(bytes_of("least.nc") == bytes_of("whole.nc"));
}

TEST_CASE("a size of memory without a unit, with that of bits, or that is none is refused",
          "[generate][contract]") {
  for (const char* size : {"512", "512Mb", "-1GB", "0B", "1e400GB", "nanMB", "infGB", "MB", "1e9TB", "''"}) {
    const Outcome run = shell(draw + " --memory=" + size + " -o absent.nc");
    CAPTURE(size, run.error);
    CHECK(run.exit == 2);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring("--memory"));
  }
}

TEST_CASE("a drawing that fails midway leaves what was there, and no part", "[generate][contract]") {
  require(draw + " --stream 1 -o kept.nc");
  const Outcome failed = shell("ulimit -f 200; trap '' XFSZ; " + draw + tight + " -o kept.nc; echo $?; ls");
  CAPTURE(failed.error);
  CHECK(failed.out.starts_with("1\n"));
  CHECK(lines(failed.error) == 1);
  CHECK(failed.out.find(".part") == std::string::npos);
  CHECK(read_dataset("kept.nc").attributes.number("generate_stream", 0) == 1);
  CHECK(shell(draw + tight + " > /dev/full").exit == 1);
}

// Two gigabytes, killed when a megabyte of them is written. Some file systems know no files without a name: there
// it has one, and nothing is claimed.
TEST_CASE("a drawing that is killed leaves nothing", "[generate][contract][slow]") {
  const int nameless = ::open(scratch(".").c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0600);
  if (nameless < 0) {
    WARN("this file system knows no files without a name");
    return;
  }
  ::close(nameless);
  for (const char* signal : {"TERM", "KILL"}) {
    const Outcome run = shell(
        "mkdir -p killed; asperity-generate --shape 524288x512 --size 5m,5mm --rq 1um --length 4px"
        " --seed 1 --memory 64MB -o killed/s.nc & written() { stat -L -c '%s %h' /proc/$!/fd/* 2>/dev/null |"
        " awk '$2 == 0 && $1 > 1e6'; }; for i in $(seq 400); do [ -n \"$(written)\" ] && break; sleep 0.05;"
        " done; [ -n \"$(written)\" ] && echo part; kill -" +
        std::string(signal) + " $!; wait $!; echo $?; ls -A killed");
    CAPTURE(signal, run.error);
    CHECK(run.out == std::string("part\n") + (std::string(signal) == "TERM" ? "143\n" : "137\n"));
  }
}

TEST_CASE("a kernel on standard input needs no option, and its grid is the surface's",
          "[generate][contract]") {
  require(draw + " --add kernel -o first.nc");
  require("asperity-generate --seed 7 --no-history < first.nc > second.nc");
  const Dataset first = read_dataset("first.nc"), second = read_dataset("second.nc");
  CHECK((field_of(first, "heights") == field_of(second, "heights")).all());
  CHECK(first.at("x").values == second.at("x").values);
  require(
      "asperity-kernel --length 4px --rq 0.4um --spacing 10um | asperity-generate --shape 20x30 -o piped.nc");
  const Grid grid = grid_of(read_dataset("piped.nc"));
  CHECK(grid.shape == Shape{20, 30});
  CHECK(relative_error(grid.dx, 10e-6) <= 4 * epsilon);
}

TEST_CASE("what is missing beside a kernel on standard input is named", "[generate][contract]") {
  require("asperity-kernel --length 4px -o samples.nc");
  require("asperity-kernel --length 4px --spacing 1um -o spaced.nc");
  const std::pair<std::string, std::string> lacking[] = {
      {"asperity-generate -o absent.nc < samples.nc", "--shape"},
      {"asperity-generate --shape 8x8 -o absent.nc < spaced.nc", "--rq"},
      {"asperity-generate --shape 8x8 --rq 1um -o absent.nc < samples.nc", "--size"},
      {"asperity-generate --shape 8x8 --rq 1um --size 3um -o absent.nc < spaced.nc", "--size"},
      {"asperity-generate --shape 8x8 --rq 1um --size 3um -o absent.nc < /dev/null", "--length"},
      {"asperity-generate --shape 8x8 --rq 1um --length-level 0.5 -o absent.nc < spaced.nc", "--length"},
      {"asperity-generate --shape 8x8 --rq 1um --kernel spaced.nc --length-level 0.5 -o absent.nc",
       "--length-level"},
  };
  for (const auto& [line, option] : lacking) {
    const Outcome run = shell(line);
    CAPTURE(line, run.error);
    CHECK(run.exit == 2);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring(option));
  }
}
