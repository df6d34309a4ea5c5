// Where results go: through links, devices and pipes, in place of files with their rights, and never over
// what is read.
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support.hpp"
#include "tools/cli/stream.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

namespace fs = std::filesystem;

const std::string generate =
    "asperity-generate --shape 16x12 --size 1mm --rq 0.4um --length 3px --seed 7 --no-history -q ";

std::string content(const std::string& name) {
  std::ifstream in(scratch(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string drawn() {
  if (!fs::exists(scratch("own.nc"))) REQUIRE(shell(generate + "-o own.nc").exit == 0);
  return content("own.nc");
}

// SOURCE_DATE_EPOCH leaves no seconds in a dataset.
Outcome dated(const std::string& line) { return shell("export SOURCE_DATE_EPOCH=1; " + line); }

}  // namespace

// A process keeps its number through exec, so that the link stands exactly where the temporary name used to
// be.
TEST_CASE("a link or a file planted at a temporary name is neither followed nor removed",
          "[outputs][contract]") {
  drawn();
  for (const std::string& without :
       {std::string(), std::string("unshare -rm sh -c 'mount -t tmpfs none /proc && ")}) {
    if (!without.empty() && shell(without + "true'").exit != 0) continue;
    const Outcome run = shell(
        "rm -rf planted; mkdir planted; echo precious > planted/victim; cat > plant <<'END'\n"
        "for i in 0 1 2 3 4 5 6 7 8 9; do ln -s victim planted/out.nc.part$(($$+i)); done\n"
        "exec " +
        generate + "-o planted/out.nc\nEND\n" + (without.empty() ? "bash plant" : without + "bash plant'") +
        "; cat planted/victim; ls planted | grep -c part");
    CAPTURE(without, run.error);
    CHECK(run.out == "precious\n10\n");
    CHECK(fs::exists(scratch("planted/out.nc")));
  }
}

TEST_CASE("a file that is replaced keeps its mode, and one that may not be written is not replaced",
          "[outputs][contract]") {
  drawn();
  for (const char* mode : {"600", "640", "664", "444"}) {
    const Outcome run = shell("cp own.nc kept.nc; chmod " + std::string(mode) + " kept.nc; " + generate +
                              "-o kept.nc; s=$?; stat -c %a kept.nc; rm -f kept.nc; exit $s");
    CAPTURE(mode, run.error);
    const bool refused = std::string(mode) == "444" && ::geteuid() != 0;
    CHECK(run.exit == (refused ? 1 : 0));
    CHECK(run.out == std::string(mode) + "\n");
  }
  CHECK(shell("umask 027; " + generate + "-o fresh.nc; stat -c %a fresh.nc").out == "640\n");
  if (::geteuid() != 0) return;
  const Outcome owned = shell("cp own.nc other.nc; chown 1234:5678 other.nc; chmod 640 other.nc; " +
                              generate + "-o other.nc; stat -c '%u:%g %a' other.nc");
  CHECK(owned.out == "1234:5678 640\n");
  const Outcome refused = shell(
      "mkdir -m 777 open; cp own.nc open/p.nc; chmod 755 .; chown 1234 open/p.nc; chmod 444 open/p.nc;"
      "setpriv --reuid 1234 --clear-groups " +
      std::string(ASPERITY_BIN) +
      "/asperity-stats own.nc -o open/p.tsv "
      "> /dev/null; cp open/p.nc open/p.tsv; chown 1234 open/p.tsv; chmod 444 open/p.tsv;"
      "setpriv --reuid 1234 --clear-groups " +
      std::string(ASPERITY_BIN) + "/asperity-stats own.nc -o open/p.tsv");
  CAPTURE(refused.error);
  if (refused.error.find("cannot") != refused.error.npos) return;  // the tools are out of that user's reach
  CHECK(refused.exit == 1);
  CHECK(refused.error.find("open/p.tsv: Permission denied") != std::string::npos);
}

TEST_CASE("a file below /dev is a file, and what is none is written as it is", "[outputs][contract]") {
  const std::string expected = dated(generate).out;
  REQUIRE(expected.size() > 1000);
  const std::string shared = "/dev/shm/asperity-test-" + std::to_string(::getpid()) + ".nc";
  if (fs::is_directory("/dev/shm")) {
    CHECK(
        dated(generate + "-o " + shared + "; s=$?; cat " + shared + "; rm -f " + shared + "; exit $s").out ==
        expected);
  }
  for (const char* to : {"-o /dev/stdout", "-o /dev/fd/1", "-o /proc/self/fd/1", "-o >(cat >&3)",
                         "-o /dev/fd/5 5>&1", "-o fifo & cat fifo"}) {
    const Outcome run = dated("rm -f fifo; mkfifo fifo; { " + generate + to + "; } 3>&1 | cat");
    CAPTURE(to, run.error);
    CHECK((run.out == expected));
  }
  // A descriptor is written from where it stands.
  dated("{ printf head; " + generate + "-o /dev/stdout; printf tail; } > around");
  CHECK((content("around") == "head" + expected + "tail"));
  dated("ln -sf end.nc first.nc; ln -sf first.nc second.nc; " + generate + "-o second.nc");
  CHECK((content("end.nc") == expected));
  CHECK(fs::is_symlink(scratch("first.nc")));
  CHECK(shell(generate + "-o /dev/null").exit == 0);
}

TEST_CASE("where nothing can be written is said in one line before the work", "[outputs][contract]") {
  drawn();
  fs::create_directory(scratch("folder"));
  for (const auto& [to, words] :
       {std::pair("-o missing/k.nc", "missing/k.nc: No such file"),
        std::pair("-o folder", "folder: Is a directory"),
        std::pair("-o /dev/full", "/dev/full: No space left"),
        std::pair("> /dev/full", "standard output: No space left"),
        std::pair("-o unwritten.nc --report missing/r.json", "missing/r.json: No such file")}) {
    const Outcome run = shell(generate + to);
    CAPTURE(to, run.error);
    CHECK(run.exit == 1);
    CHECK(lines(run.error) == 1);
    CHECK(run.error.find(words) != std::string::npos);
  }
  CHECK_FALSE(fs::exists(scratch("unwritten.nc")));
}

TEST_CASE("two outputs of one run are two files, whatever they are called", "[outputs][contract]") {
  drawn();
  const std::string press = "asperity-contact own.nc --radius 50mm --young 208GPa --poisson 0.3 -q ";
  shell("ln -sf same sym; echo former > hard; ln -f hard hard2; mkdir -p d; mkfifo f");
  for (const std::string& run :
       {generate + "-o same --report same", generate + "-o same --report ./same",
        generate + "-o same --report sym", generate + "-o hard --report hard2",
        generate + "-o same --report d/../same", generate + "--report -",
        generate + "-o /dev/fd/1 --report -", generate + "-o f --report ./f",
        press + "--sweep 1N,2N --each p%d -o p2", press + "--load 1N -o q --report $PWD/q"}) {
    const Outcome out = shell(run + " | cat");
    CAPTURE(run, out.error);
    CHECK(out.exit == 2);
    CHECK(out.error.find("give it another name") != std::string::npos);
    CHECK(lines(out.error) == 1);
    CHECK(out.out.empty());
  }
  for (const char* none : {"same", "p1", "p2", "q"}) CHECK_FALSE(fs::exists(scratch(none)));
  CHECK(content("hard") == "former\n");
  CHECK(shell(generate + "-o /dev/null --report /dev/null").exit == 0);
}

TEST_CASE("an output does not take the place of what is read, but for a dataset that passes it on",
          "[outputs][contract][slow]") {
  const std::string before = drawn();
  const std::string bodies = " --radius 50mm --young 208GPa --poisson 0.3 --load 1N -q ";
  shell(
      "cp own.nc own; cp own.nc c; ln -sf own link; ln -f own hardlink; printf '1 2\\n3 4\\n' > text; echo "
      "'0 0 "
      "1um' > points;"
      "asperity-contact own.nc" +
      bodies + "-o pressed.nc; asperity-acf own.nc -o acf");
  for (const std::string& run : {std::string("asperity-stats own -o own"),
                                 std::string("asperity-stats own -o ./own"),
                                 std::string("asperity-stats own -o link"),
                                 std::string("asperity-stats own -o hardlink"),
                                 std::string("asperity-stats -o own < own"),
                                 std::string("asperity-stats own >> own"),
                                 std::string("asperity-stats own.nc own -o own"),
                                 std::string("echo own | asperity-stats --files-from - -o own"),
                                 std::string("asperity-validate own -o own"),
                                 std::string("asperity-pdf own -o own"),
                                 std::string("asperity-acf own --result lengths -o own"),
                                 std::string("asperity-psd own --result radial -o own"),
                                 std::string("asperity-report own -o own"),
                                 std::string("asperity-plot own --kind map --to svg -o own"),
                                 std::string("asperity-convert own --to gsf -o own"),
                                 std::string("asperity-convert text -o text"),
                                 "asperity-contact own" + bodies + "-o p.nc --report own",
                                 "asperity-contact own.nc --counter own" + bodies + "-o own",
                                 "asperity-contact text" + bodies + "-o text",
                                 std::string("asperity-stress pressed.nc --points points -o points"),
                                 generate + "--marginal own -o own",
                                 std::string("asperity-validate own.nc --acf acf -o acf")}) {
    const Outcome out = shell(run);
    CAPTURE(run, out.error, out.out);
    CHECK(out.exit == 2);
    CHECK(lines(out.error) == 1);
    CHECK((content("own") == before));
    CHECK(content("text") == "1 2\n3 4\n");
    CHECK(content("points") == "0 0 1um\n");
  }
  // To add to a dataset is to write it over itself.
  for (const std::string& run :
       {std::string("asperity-acf own -o own"), std::string("asperity-acf own -o link"),
        std::string("asperity-psd -o own < own"), "asperity-contact own" + bodies + "-o own",
        std::string("asperity-stress own --poisson 0.3 --depths 0:0.1mm:3 -o own -q"),
        std::string("asperity-filter own --crop 0:8,0:8 -o own -q"),
        std::string("asperity-convert text --to text -o text"),
        std::string("asperity-kernel --acf acf -q -o acf")}) {
    const Outcome out = shell(run);
    CAPTURE(run, out.error);
    CHECK((out.exit == 0 || out.exit == 3));
  }
  CHECK(read_dataset("own").has("von_mises") == false);  // dropped with the cut
  CHECK(read_dataset("own").has("heights"));
  CHECK((content("c") == before));
}

// 8 KiB are less than the dataset, but for the header, and nothing is written but into the pipe.
TEST_CASE("a limit on the size of files does not reach pipes, and ends the writing of a file in one line",
          "[outputs][contract]") {
  const std::string large =
      "asperity-generate --shape 64x64 --size 1mm --rq 0.4um --length 3px --seed 7 --no-history -q ";
  const std::string expected = dated(large).out;
  for (const char* blocks : {"8", "1", "0"}) {
    const Outcome piped = dated("(ulimit -f " + std::string(blocks) + "; " + large + ") | cat");
    CAPTURE(blocks, piped.error);
    CHECK(piped.exit == 0);
    CHECK((piped.out == expected));
  }
  const Outcome file =
      shell("ulimit -f 8; mkdir limited; " + large + "-o limited/k.nc; s=$?; ls -A limited; exit $s");
  CHECK(file.exit == 1);
  CHECK(file.out.empty());
  CHECK(file.error == "asperity-generate: limited/k.nc: File too large\n");
}

// The limit went on to gnuplot, which wrote so much and no more, and was content.
TEST_CASE("a figure beyond a limit on the size of files is an error, not a part of it",
          "[outputs][contract]") {
  drawn();
  const Outcome run =
      shell("(ulimit -f 8; asperity-plot own.nc --kind map --to svg -o - 2> why) | wc -c; cat why");
  CAPTURE(run.out);
  CHECK(run.out.starts_with("0\nasperity-plot: "));
  CHECK(lines(run.out) == 2);
}

TEST_CASE("NetCDF-4 is read under a limit on the size of files", "[outputs][contract]") {
  const Outcome free = shell("asperity-stats " ASPERITY_TEST_DATA "/../corpus/netcdf4/whole"),
                bounded = shell("(ulimit -f 0; asperity-stats " ASPERITY_TEST_DATA
                                "/../corpus/netcdf4/whole) | cat");
  CAPTURE(bounded.error);
  CHECK(bounded.exit == free.exit);
  CHECK((bounded.out == free.out));
}

TEST_CASE("without /proc datasets are written and NetCDF-4 is read", "[outputs][contract]") {
  if (shell("unshare -rm mount -t tmpfs none /proc").exit != 0) return;  // not permitted here
  const std::string expected = dated(generate).out;
  const std::string within = "unshare -rm bash -c 'mount -t tmpfs none /proc && ";
  for (const std::string& run : {generate + "| cat", generate + "-o bare.nc; cat bare.nc"}) {
    const Outcome out = dated(within + run + "'");
    CAPTURE(run, out.error);
    CHECK((out.out == expected));
  }
  CHECK(shell("ls bare.nc.part* 2> /dev/null").out.empty());
  const std::string read = "asperity-stats " ASPERITY_TEST_DATA "/../corpus/netcdf4/whole";
  CHECK(shell(within + read + "'").out == shell(read).out);
}

// Messages go to the descriptor 2, which a file that is opened would otherwise get: -v says a line for each
// layer.
TEST_CASE("no message gets into a file when a standard stream is closed", "[outputs][contract]") {
  drawn();
  REQUIRE(
      shell("asperity-contact own.nc --radius 50mm --young 208GPa --poisson 0.3 --load 1N -q -o t.nc").exit ==
      0);
  const std::string layers = "asperity-stress t.nc --depths 0:0.1mm:9 --no-history -v ";
  REQUIRE(dated(layers + "-o open.nc 2> /dev/null").exit == 0);
  for (const char* closed : {"2>&-", "1>&- 2>&-", "0<&- 1>&- 2>&-"}) {
    CAPTURE(closed);
    CHECK(dated(layers + "-o closed.nc " + closed).exit == 0);
    CHECK((content("closed.nc") == content("open.nc")));
  }
}
