// Tools under mpirun: the files and tables of one process, and what happens when a rank fails.
#include <algorithm>
#include <cmath>
#include <vector>

#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string contact = "asperity-contact --young 208GPa --poisson 0.3 --no-history --progress never ";

// Of more ranks than cores, some run as root: what a launcher has to be told.
std::string mpirun(int ranks) {
  return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 timeout 120 mpirun -q --oversubscribe "
         "-n " +
         std::to_string(ranks) + " ";
}

// In words that skipped() knows.
bool no_mpirun() {
  return skipped(ASPERITY_HAS_MPI
                     ? shell("command -v mpirun >/dev/null || echo SKIPPED: mpirun is not installed")
                     : shell("echo SKIPPED: a build without MPI"));
}

void draw() {
  static const bool drawn = shell(
                                "asperity-generate -q --shape 576x540 --size 1mm,0.9mm --rq 0.2um --length "
                                "20um --seed 3 -o s.nc && "
                                "asperity-generate -q --periodic --shape 576x540 --size 1mm,0.9mm --rq 0.2um "
                                "--length 20um --seed 3 -o p.nc")
                                .exit == 0;
  REQUIRE(drawn);
}

// The text of a dataset, without what depends on time.
std::string text_of(const std::string& names) {
  return "for f in " + names + "; do ncdump -p 9,17 $f.nc | sed 1d | grep -v _seconds >$f.txt; done; ";
}

// What a command writes to OUT.nc, prints and warns of, by one process and by ranks.
void check_same(const std::string& command, std::size_t ranks, std::size_t threads) {
  CAPTURE(command, ranks, threads);
  auto run = [&](const std::string& launcher, const std::string& name, std::size_t of_each) {
    std::string line = launcher + command + " --threads " + std::to_string(of_each);
    if (const auto at = line.find("OUT"); at != line.npos) line.replace(at, 3, name);
    return shell(line);
  };
  const Outcome one = run("", "one", 1), several = run(mpirun(static_cast<int>(ranks)), "several", threads);
  REQUIRE(one.exit == 0);
  CAPTURE(several.error);
  CHECK(several.exit == 0);
  CHECK(several.error == one.error);
  CHECK(several.out == one.out);
  if (command.find("OUT") == command.npos) return;
  CHECK(shell(text_of("one several") +
              "cmp one.txt several.txt && [ $(stat -c %s one.nc) -eq $(stat -c %s several.nc) ]")
            .exit == 0);
}

// On 2 to 4 ranks in turn.
void check_same(const std::vector<std::string>& commands) {
  for (std::size_t k = 0; k < commands.size(); ++k) check_same(commands[k], 2 + k % 3, 1 + k % 2);
}

}  // namespace

TEST_CASE("several ranks write the file of one, byte for byte but for times", "[ranks][contact][slow]") {
  if (no_mpirun()) return;
  draw();
  check_same({
      contact + "s.nc --load 20N --radius 20mm --add contact_stiffness,patches,elastic_energy -o OUT.nc",
      contact + "s.nc --load 20N --radius 20mm --yield 1GPa --add heights_residual,contact_ratios -o OUT.nc",
      contact + "s.nc --approach 1um --radius 20mm -o OUT.nc",
      contact + "p.nc --load 50N --add contact_stiffness -o OUT.nc",
      contact + "--smooth --shape 600x600 --size 1mm --radius 20mm --load 1N -o OUT.nc",
  });
}

TEST_CASE("several ranks print the table of one, and one dataset a load", "[ranks][contact][slow]") {
  if (no_mpirun()) return;
  draw();
  const std::string run = "s.nc --sweep 5N,20N,10N --radius 20mm --yield 1GPa --each ";
  const Outcome one = shell(contact + run + "one_%d.nc --threads 1"),
                three = shell(mpirun(3) + contact + run + "three_%d.nc --threads 1");
  CHECK(one.exit == 0);
  CHECK(three.exit == 0);
  CHECK(three.out == one.out);
  for (const std::string k : {"1", "2", "3"})
    CHECK(shell(text_of("one_" + k + " three_" + k) + "cmp one_" + k + ".txt three_" + k + ".txt").exit == 0);
}

TEST_CASE("several ranks write the stresses of one, and print its tables", "[ranks][stress][slow]") {
  if (no_mpirun()) return;
  draw();
  REQUIRE(shell(contact + "s.nc --load 20N --radius 20mm --yield 3GPa -o c.nc").exit == 0);
  check_same({
      "asperity-stress --no-history c.nc --depths 0,6um,24um --components all --above 0.1pmax -o OUT.nc",
      "asperity-stress --no-history c.nc --depths 0:20um:3 --section y=max --components von_mises,xz "
      "--friction 0.3 -o "
      "OUT.nc",
      "asperity-stress --no-history c.nc --maximum -o OUT.nc",
      "asperity-stress c.nc --depths 1um,6um --result maxima --of max_shear",
  });
  // Into a pipe: the result is kept, or computed again for its variable.
  for (const std::string memory : {"1GB", "1kB"}) {
    const std::string piped =
        "asperity-stress c.nc --no-history --progress never --depths 1um,6um --memory " + memory;
    CHECK(shell(piped + " >one.nc && " + mpirun(2) + piped + " | cat >several.nc; " + text_of("one several") +
                "cmp one.txt several.txt")
              .exit == 0);
  }
}

TEST_CASE("a failure under mpirun is one line and an exit code, and leaves no file",
          "[ranks][contact][slow]") {
  if (no_mpirun()) return;
  draw();
  Dataset map = read_dataset("s.nc");
  std::get<std::vector<double>>(map.find("heights")->values).at(570 * 540 + 3) =
      NAN;  // in the rows of the second
  write_dataset(map, "bad.nc");
  const Outcome data = shell(mpirun(2) + contact + "bad.nc --load 20N --radius 20mm -o bad_out.nc");
  CAPTURE(data.error);
  CHECK(data.exit == 4);
  CHECK(lines(data.error) == 1);
  const Outcome usage =
      shell(mpirun(2) + contact + "s.nc --load 20N --radius 20mm --accuracy 1% -o bad_out.nc");
  CAPTURE(usage.error);
  CHECK(usage.exit == 2);
  CHECK(lines(usage.error) == 1);
  for (const std::string option : {"--points p.txt", "--maximum --add grid_errors"}) {
    const Outcome refused = shell(mpirun(2) + "asperity-stress s.nc -o bad_out.nc " + option);
    CAPTURE(option, refused.error);
    CHECK(refused.exit == 2);
    CHECK(lines(refused.error) == 1);
    CHECK_THAT(refused.error, ContainsSubstring("by 2 ranks: start one process"));
  }
  const Outcome full = shell(mpirun(2) + contact + "s.nc --load 20N --radius 20mm -o /dev/full");
  CAPTURE(full.error);
  CHECK(full.exit == 1);
  CHECK(lines(full.error) == 1);
  CHECK(shell("test -e bad_out.nc").exit != 0);
}

// While they solve: behind the first of ten and more rounds on the finest grid, of which -v tells each.
TEST_CASE("when a rank is killed the others end, and no file is left", "[ranks][contact][slow]") {
  if (no_mpirun()) return;
  const Outcome killed = shell(
      "asperity-generate -q --shape 1536x1536 --size 1mm --rq 0.2um --length 20um --seed 3 -o killed_s.nc; "
      "ranks() { for p in $(pgrep -f 'killed[.]nc'); do "
      "[ \"$(cat /proc/$p/comm 2>/dev/null)\" = asperity-contac ] && echo $p; done; }; " +
      mpirun(3) + contact +
      "killed_s.nc --load 20N --radius 20mm --tolerance 1e-12 --threads 1 -v -o killed.nc 2>told & "
      "while kill -0 $! && ! grep -q 1536x1536 told; do sleep 0.02; done; "
      "kill -9 $(ranks | tail -1) || exit 0; wait $!");
  CAPTURE(killed.error);
  CHECK(killed.exit != 0);
  CHECK(shell("ls -A | grep 'killed[.]'").exit != 0);
}

TEST_CASE("a tool that runs as one process refuses to be copied by a launcher", "[ranks][contract]") {
  for (const std::string tool :
       {"asperity-filter s.nc", "asperity-acf s.nc", "asperity-psd s.nc", "asperity-stats s.nc",
        "asperity-generate --shape 8x8 --size 1mm --rq 1um --length 1px"}) {
    const Outcome refused = shell("OMPI_COMM_WORLD_SIZE=2 " + tool + " -o copied.nc");
    CAPTURE(tool, refused.error);
    CHECK(refused.exit == 2);
    CHECK(lines(refused.error) == 1);
    CHECK_THAT(refused.error, ContainsSubstring("2 copies were started") &&
                                  ContainsSubstring("with threads, or several surfaces as an array job"));
  }
  CHECK(shell("test -e copied.nc").exit != 0);
  CHECK(shell("OMPI_COMM_WORLD_SIZE=1 asperity-filter --version").exit == 0);
}
