// Another program as a reader: what it gets, what it may take, and what is left of it.
#include "tools/cli/program.hpp"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include "dataset/layout.hpp"
#include "formats/format.hpp"
#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;
using cli::ProgramRun;

namespace {

constexpr std::size_t memory = std::size_t{1} << 30;

ProgramRun sh(const std::string& script, std::string_view input = {},
              cli::ProgramLimits limits = {10, memory}) {
  return cli::run_program("/bin/sh", {"-c", script}, input, limits);
}

std::string output_of(const std::string& script, std::string_view input = {}) {
  const ProgramRun run = sh(script, input);
  CHECK(run.end == ProgramRun::End::done);
  return std::string(std::string_view(run.output));
}

bool gone(const std::string& process) {
  for (int tries = 0; tries < 200; ++tries) {
    if (::kill(std::stoi(process), 0) != 0) return true;
    std::ifstream status("/proc/" + process + "/stat");
    if (std::string line; std::getline(status, line) && line.find(") Z ") != line.npos) return true;
    ::usleep(10'000);
  }
  return false;
}

// A program `gwyddion` in folder bin, which the tools find first.
void write_gwyddion(const std::string& script) {
  std::filesystem::create_directories(scratch("bin"));
  std::ofstream(scratch("bin/gwyddion")) << "#!/bin/sh\n" << script;
  std::filesystem::permissions(scratch("bin/gwyddion"), std::filesystem::perms::owner_all);
}

const std::string first = "PATH=" + scratch("bin") + ":$PATH ";

void write_unknown(const std::string& name) {
  std::ofstream(scratch(name), std::ios::binary) << std::string("\1\2\3\0\4", 5);
}

}  // namespace

TEST_CASE("a program makes one file of another, in memory, without the user's environment",
          "[program][contract]") {
  CHECK(output_of("cat /proc/self/fd/4 > /proc/self/fd/3", "bytes") == "bytes");
  CHECK(output_of("echo $HOME $TMPDIR $XDG_CONFIG_HOME $DISPLAY > /proc/self/fd/3") ==
        "/dev/null /dev/null /dev/null\n");
  CHECK(output_of("cat > /proc/self/fd/3").empty());
  CHECK(output_of("ls /proc/self/fd > /proc/self/fd/3") == "0\n1\n2\n3\n4\n5\n");  // 5 is ls's own
  const ProgramRun run = sh("echo one; echo two >&2; exit 3");
  CHECK(run.end == ProgramRun::End::failed);
  CHECK(run.messages == "one\ntwo\n");
  CHECK(run.output.size() == 0);
  CHECK(cli::run_program("/dev/null", {}, {}, {10, memory}).end == ProgramRun::End::not_started);
}

// The shell's own child sleeps for longer than a test.
TEST_CASE("a program that takes too long is ended with its children", "[program][contract]") {
  const auto begin = std::chrono::steady_clock::now();
  for (const char* script :
       {"sleep 1000 & echo $!; wait", "sleep 1000 >/dev/null 2>&1 & echo $!; exec >&- 2>&-; wait"}) {
    const ProgramRun run = sh(script, {}, {1, memory});
    CHECK(run.end == ProgramRun::End::too_long);
    CHECK(gone(run.messages.substr(0, run.messages.find('\n'))));
  }
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(60));
  CHECK(sh("while :; do :; done", {}, {1, memory}).end == ProgramRun::End::too_long);
  const ProgramRun left = sh("sleep 1000 >/dev/null 2>&1 & echo $!");
  CHECK(left.end == ProgramRun::End::done);
  CHECK(gone(left.messages.substr(0, left.messages.find('\n'))));
}

TEST_CASE("a program that writes or prints without end is ended, and takes no more than is allowed",
          "[program][contract]") {
  CHECK(sh("exec cat /dev/zero > /proc/self/fd/3", {}, {30, std::size_t{64} << 20}).end ==
        ProgramRun::End::too_large);
  const ProgramRun loud = sh("exec cat /dev/zero", {}, {1, memory});
  CHECK(loud.end == ProgramRun::End::too_long);
  CHECK(loud.messages.size() <= 32768);
}

TEST_CASE("a file that no reader knows is read through Gwyddion, and history and a note name it",
          "[program][contract]") {
  const Map map{.values = random_field({6, 4}, 3), .spacing = {1e-6, 1e-6}, .units = "m", .title = "heights"};
  std::ofstream(scratch("made.gwy"), std::ios::binary) << format::gwy.encode(map, Order::xy);
  write_unknown("scan.dat");
  write_gwyddion("case $1 in --version) echo Gwyddion 9.87; exit;; esac\n[ -s \"$2\" ] || exit 1\ncat " +
                 scratch("made.gwy") + " > ${1#--convert-to-gwy=}\n");
  for (const char* line : {"asperity-convert scan.dat -o a.nc", "asperity-convert - -o a.nc < scan.dat",
                           "asperity-convert scan.dat --from gwyddion -o a.nc"}) {
    const Outcome run = shell(first + line);
    CAPTURE(line, run.error);
    REQUIRE(run.exit == 0);
    CHECK_THAT(run.error,
               ContainsSubstring("read through another program: gwyddion 9.87 --convert-to-gwy=OUT.gwy "));
    const Dataset data = read_dataset("a.nc");
    CHECK((field_of(data, "heights") == map.values).all());
    const std::string history = data.attributes.text("history");
    CHECK_THAT(history, ContainsSubstring("asperity-convert "));
    CHECK_THAT(history, ContainsSubstring(": gwyddion 9.87 --convert-to-gwy=OUT.gwy "));
    CHECK(history.find("asperity-convert") < history.find("gwyddion 9.87"));
  }
  const Outcome run = shell(first + "asperity-stats scan.dat -v");
  CHECK(run.exit == 0);
  CHECK_THAT(run.error,
             ContainsSubstring("scan.dat is read as gwyddion: its first bytes are of none of netcdf, "));
}

// Gwyddion 2.62 takes 1 µm for 1 nm in a file whose heights are in nm.
TEST_CASE(
    "a size that Gwyddion takes otherwise than the head of a WSxM file says is refused until it is told",
    "[program][contract]") {
  const Map map{.values = random_field({6, 4}, 3), .spacing = {1e-6 / 6, 1e-6 / 4}, .units = "m"};
  std::ofstream(scratch("made.gwy"), std::ios::binary) << format::gwy.encode(map, Order::xy);
  write_gwyddion("cat " + scratch("made.gwy") + " > ${1#--convert-to-gwy=}\n");
  for (const auto& [size, exit] : {std::pair{"1 \xb5m", 0}, {"1 \u00b5m", 0}, {"1000 nm", 0}, {"1 mm", 4}}) {
    std::ofstream(scratch("a.stp")) << "WSxM file copyright UAM\r\n[Control]\r\n    X Amplitude: " << size
                                    << "\r\n    Y Amplitude: 1 um\r\n[Header end]\r\n"
                                    << std::string(8, '\1');
    const Outcome run = shell(first + "asperity-convert a.stp -o a.nc");
    CAPTURE(size, run.error);
    CHECK(run.exit == exit);
    if (exit == 4) CHECK_THAT(run.error, ContainsSubstring("takes X Amplitude '1 mm' for 1e-06 m"));
  }
  CHECK(shell(first + "asperity-convert a.stp --size 1mm,1um -o a.nc").exit == 0);
}

TEST_CASE("what Gwyddion cannot read, or where there is none, is refused in one line",
          "[program][contract]") {
  write_unknown("scan.dat");
  const auto refused = [](const std::string& script, const std::string& words) {
    write_gwyddion(script);
    const Outcome run = shell(first + "asperity-stats scan.dat");
    CAPTURE(script, run.error);
    CHECK(run.exit == 4);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring(words));
  };
  refused("echo \"$2: No module can load this file type.\" >&2; exit 1",
          "Gwyddion cannot read the file either: No module can load this file type.");
  refused("exit 0", "Gwyddion cannot read the file either");
  refused("echo GWYPnonsense > ${1#--convert-to-gwy=}", "cut short");
  refused("kill -SEGV $$", "Gwyddion cannot read the file either");
  const Outcome none = shell(
      "mkdir -p alone && ln -sf $(command -v "
      "asperity-stats) alone/ && PATH=" +
      scratch("alone") + " asperity-stats scan.dat");
  CHECK(none.exit == 4);
  CHECK(lines(none.error) == 1);
  CHECK_THAT(none.error, ContainsSubstring("package gwyddion of Debian"));
}

TEST_CASE("text is given to Gwyddion only where --from says so", "[program][contract]") {
  std::ofstream(scratch("strange.txt")) << "Some Instrument 3\nwith words\n";
  write_gwyddion("touch " + scratch("asked") + "; exit 1");
  const Outcome run = shell(first + "asperity-stats strange.txt");
  CHECK(run.exit == 4);
  CHECK(!std::filesystem::exists(scratch("asked")));
  CHECK(shell(first + "asperity-stats strange.txt --from gwyddion").exit == 4);
  CHECK(std::filesystem::exists(scratch("asked")));
}

TEST_CASE("a channel chooses a map by name or number, and is refused where there is one map alone",
          "[program][contract]") {
  const Map map{.values = random_field({6, 4}, 3), .spacing = {1e-6, 1e-6}, .units = "m", .title = "Height"};
  std::ofstream(scratch("one.gwy"), std::ios::binary) << format::gwy.encode(map, Order::xy);
  CHECK(shell("asperity-convert one.gwy --channel Height -o a.nc").exit == 0);
  const Outcome other = shell("asperity-stats one.gwy --channel Phase");
  CHECK(other.exit == 4);
  CHECK_THAT(other.error, ContainsSubstring("the file has no channel 'Phase', only 0 'Height'"));
  for (const char* line : {"asperity-convert a.nc --channel 0 -o b.nc", "asperity-stats a.nc --channel 0",
                           "asperity-convert a.nc -o a.x3p && asperity-stats a.x3p --channel 0"}) {
    const Outcome run = shell(line);
    CAPTURE(line, run.error);
    CHECK(run.exit == 2);
    CHECK_THAT(run.error, ContainsSubstring("--channel"));
  }
}
