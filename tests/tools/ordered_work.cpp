// Several datasets worked on at once: the output is that of one after the other.
#include "tools/cli/ordered_work.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <vector>

#include "core/parallel.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

using std::chrono::milliseconds;

// t_01.nc … t_12.nc, of 32 x 24 cells; of several the warnings differ in their numbers.
void draw() {
  static const bool drawn = shell(
                                "asperity-generate -q --shape 32x24 --size 1mm --rq 0.4um --length 3px "
                                "--seed 1 --first 1 --count 12 "
                                "-o t_%02d.nc")
                                .exit == 0;
  REQUIRE(drawn);
}

const std::string fixed_date = "export SOURCE_DATE_EPOCH=0; ";

// A line in which THREADS stands for a number, as one worker and as four do it.
struct Both {
  Outcome one, four;
};
Both both(const std::string& line) {
  auto with = [&](const std::string& threads) {
    std::string out = fixed_date + line;
    for (std::size_t at = 0; (at = out.find("THREADS", at)) != out.npos;) out.replace(at, 7, threads);
    return shell(out);
  };
  return {with("1"), with("4")};
}

void check_alike(const std::string& line, int exit) {
  const auto [one, four] = both(line);
  CAPTURE(line, one.error, four.error);
  CHECK(one.exit == exit);
  CHECK(four.exit == exit);
  CHECK(four.out == one.out);
  CHECK(four.error == one.error);
}

}  // namespace

// The later, the sooner done: each waits for those before it.
TEST_CASE("results that are ready in any order are taken in that of the work, few of them waiting",
          "[ordered_work][law]") {
  constexpr int at_once = 4, datasets = 40;
  std::vector<int> order;
  std::atomic<int> begun = 0, taken = 0, most = 0;
  cli::OrderedWork all(at_once);
  for (int k = 0; k < datasets; ++k)
    all.add([&, k] {
      const int under_way = ++begun - taken;
      if (under_way > most) most = under_way;
      std::this_thread::sleep_for(milliseconds(k % at_once == 0 ? 8 : 1));
      return [&, k] {
        order.push_back(k);
        ++taken;
      };
    });
  all.finish();
  REQUIRE(order.size() == datasets);
  for (int k = 0; k < datasets; ++k) CHECK(order[static_cast<std::size_t>(k)] == k);
  CHECK(most <= 2 * at_once);
  CHECK(most >= at_once);  // they do go on at once
}

TEST_CASE("an error comes in order, after what its work has said, and nothing of later work is seen",
          "[ordered_work][contract]") {
  std::vector<int> said, taken;
  const auto run = [&] {
    cli::OrderedWork all(3);
    for (int k = 0; k < 20; ++k)
      all.add([&, k] {
        std::this_thread::sleep_for(milliseconds(k == 5 ? 10 : 0));
        cli::in_order([&, k] { said.push_back(k); });
        if (k == 5 || k == 6) throw std::runtime_error("dataset " + std::to_string(k));
        return [&, k] { taken.push_back(k); };
      });
    all.finish();
  };
  CHECK_THROWS_WITH(run(), "dataset 5");
  CHECK(said == std::vector<int>{0, 1, 2, 3, 4, 5});
  CHECK(taken == std::vector<int>{0, 1, 2, 3, 4});
}

TEST_CASE("a thread that works alone begins no others, and takes one for all of the machine",
          "[ordered_work][contract]") {
  cli::OrderedWork all(2);
  std::vector<int> workers, threads;
  for (int k = 0; k < 2; ++k)
    all.add([&] {
      int pieces = 0;
      parallel_ranges(100, 8, [&](Index, Index, int) { ++pieces; });
      return [&, pieces, resolved = resolve_threads(0)] {
        workers.push_back(pieces);
        threads.push_back(resolved);
      };
    });
  all.finish();
  CHECK(workers == std::vector<int>{1, 1});
  CHECK(threads == std::vector<int>{1, 1});
  CHECK(!works_alone());
}

TEST_CASE("tables and messages of many surfaces are the same from one worker and from four",
          "[ordered_work][law]") {
  draw();
  const std::string press = "--radius 5mm --young 208GPa --poisson 0.3 --threads THREADS ";
  const std::string head = "asperity-", all = " --threads THREADS t_*.nc ";
  for (const std::string tool :
       {"stats --parameters height,hybrid,spatial", "stats --json --parameters material",
        "acf --result lengths", "acf --result profiles --add structure_function", "psd --result radial",
        "psd --result profiles", "pdf", "pdf --estimate kernel", "pdf --estimate quantiles", "validate"})
    check_alike(head + tool + all + "-o -", 0);
  check_alike("asperity-contact " + press + "--sweep 1N,2N,4N t_*.nc", 0);
  check_alike("asperity-contact " + press + "--load 2N --yield 1GPa --add grid_errors t_*.nc", 0);
  check_alike("ls t_*.nc | asperity-contact -q --files-from - --load 2N " + press +
                  "--each p_%d.nc; asperity-stress --maximum" +
                  " --threads THREADS p_*.nc; asperity-stress --result maxima --depths 1um:20um:3 p_*.nc",
              0);
}

// The history has the number of threads.
TEST_CASE("datasets of many surfaces are the same from one worker and from four", "[ordered_work][law]") {
  draw();
  const std::string sums =
      " ; for f in d_*.nc; do echo $f $(LC_ALL=C sed 's/threads [14]/threads N/' $f | md5sum); done; rm "
      "d_*.nc";
  for (const std::string line :
       {"generate --shape 32x24 --size 1mm --rq 0.4um --length 3px --seed 1 --exact-rq --add noise,kernel "
        "--count 9 -o d_%d.nc",
        "generate --shape 32x24 --size 1mm --rq 0.4um --length 3px --periodic --skewness 1 --seed 1 --count "
        "9 "
        "--memory 2MB -o d_%d.nc",
        "filter t_*.nc --lambda-c 0.3mm --outliers 3 --fill laplace -o d_%d.nc",
        "contact t_*.nc --radius 5mm --young 208GPa --poisson 0.3 --load 2N --each d_%d.nc",
        "acf t_*.nc --add acf_error -o d_1.nc", "psd t_*.nc -o d_1.nc"})
    check_alike("asperity-" + line + " --threads THREADS" + sums, 0);
}

// Of surfaces on a sphere, each before the other: a window that one has left would do for the other.
TEST_CASE("a contact has the same bits whatever surfaces were pressed before it",
          "[ordered_work][contact][law]") {
  require(
      "for rq in 0.1 0.4 0.8 1.6; do asperity-generate -q --shape 128x128 --size 3mm --rq ${rq}um "
      "--model gaussian --length 12px --seed 3 -o w_$rq.nc; done");
  const std::string press =
      "asperity-contact -q --radius 50mm --young 208GPa --poisson 0.3 --load 400N --threads 1 ";
  const auto row = [&](const std::string& names, const std::string& of) {
    return require(press + names + " 2>/dev/null | grep ^" + of).out;
  };
  for (const std::string first : {"w_0.8.nc", "w_1.6.nc"})
    for (const std::string second : {"w_0.1.nc", "w_0.4.nc"}) {
      CAPTURE(first, second);
      CHECK(row(first + " " + second, second) == row(second + " " + first, second));
    }
}

TEST_CASE("the error of a surface among others comes in order", "[ordered_work][contract]") {
  draw();
  require(
      "cp t_05.nc u_05.nc; for k in 1 2 3 4 6 7 8 9; do cp t_0$k.nc u_0$k.nc; done; "
      "head -c 700 t_05.nc > u_05.nc");
  // The mean over surfaces needs all of them.
  check_alike("asperity-stats --threads THREADS u_*.nc", 4);
  check_alike("asperity-acf --threads THREADS --result lengths u_*.nc", 4);
  // The others go on.
  check_alike("asperity-contact --radius 5mm --young 208GPa --poisson 0.3 --load 2N --threads THREADS u_*.nc",
              4);
  check_alike(
      "asperity-filter --remove-form plane --threads THREADS u_*.nc -o v_%d.nc; code=$?; md5sum v_*.nc | "
      "wc -l; ls v_*; rm v_*; exit $code",
      4);
  // That of another spacing ends the run, where scales are in its steps.
  require("asperity-generate -q --shape 32x24 --size 2mm --rq 0.4um --length 3px --seed 1 -o u_05.nc");
  check_alike("asperity-psd --result scales --threads THREADS u_*.nc", 4);
}

// Those of the first were said to be about "-".
TEST_CASE("messages of the files before standard input name these files", "[ordered_work][contract]") {
  draw();
  check_alike(
      "cat t_02.nc | asperity-filter --scale 2 t_01.nc - t_03.nc --threads THREADS -o piped_%d.nc; rm "
      "piped_*",
      0);
  check_alike("cat t_05.nc | head -c 700 | asperity-stats --threads THREADS t_01.nc t_02.nc - t_03.nc", 4);
}

// A limit of the size of files, which the third one exceeds.
TEST_CASE("what comes before a failed write is written, and nothing after it", "[ordered_work][contract]") {
  require(
      "for k in 1 2 3 4 5 6 7 8; do side=32; [ $k = 3 ] && side=128; asperity-generate -q --shape "
      "${side}x$side --size 1mm --rq 0.4um --length 3px --seed $k -o x_$k.nc; done");
  check_alike(
      "ulimit -f 40; asperity-filter --remove-form plane --threads THREADS x_*.nc -o y_%d.nc; code=$?; "
      "ls y_*.nc; rm y_*.nc; exit $code",
      1);
  CHECK(
      both("ulimit -f 40; asperity-filter --remove-form plane --threads THREADS x_*.nc -o y_%d.nc; ls y_*.nc")
          .four.out == "y_1.nc\ny_2.nc\n");
}

TEST_CASE("contacts that do not converge are blank in the table, and the run ends with 3",
          "[ordered_work][contract]") {
  draw();
  check_alike(
      "asperity-contact --radius 5mm --young 208GPa --poisson 0.3 --load 2N --max-convolutions 3 --threads "
      "THREADS t_*.nc",
      3);
}

// The second comes when the first has been written, which else is never.
TEST_CASE("the first map is written before the second has come", "[ordered_work][contract]") {
  draw();
  const Outcome run = shell(
      "rm -f z_*.nc; mkfifo slow; trap 'rm slow' EXIT; asperity-filter --threads 2 --remove-form plane "
      "t_01.nc "
      "slow t_02.nc -o z_%d.nc & for k in $(seq 200); do [ -e z_1.nc ] && break; sleep 0.05; done; "
      "[ -e z_1.nc ] && echo first; cat t_03.nc > slow; wait; ls z_*.nc");
  CHECK(run.out == "first\nz_1.nc\nz_2.nc\nz_3.nc\n");
}

// Nobody ever writes into the pipe, and a thread that reads it would never end.
TEST_CASE("an error ends the run though the next surface has not come", "[ordered_work][contract]") {
  draw();
  const Outcome run = shell(
      "head -c 700 t_05.nc > cut.nc; mkfifo never; trap 'rm never' EXIT; timeout 20 asperity-stats --threads "
      "2 "
      "t_01.nc cut.nc never");
  CHECK(run.exit == 4);
  CHECK_THAT(run.error, ContainsSubstring("asperity-stats: cut.nc: "));
}
