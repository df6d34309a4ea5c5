// What the tools do where there is less memory than they need, at every limit of a whole range.
#include <iostream>

#include "support.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// In kB, the least at which the program itself is loaded, to some 100; below, its libraries speak.
int least_to_load() {
  int low = 1000, high = 4'000'000;
  while (high - low > 100) {
    const int middle = (low + high) / 2;
    const Outcome run =
        shell("ulimit -v " + std::to_string(middle) + "; asperity-kernel --length 2px -o least.nc");
    (run.exit == 0 && run.error.find("GnuTLS") == std::string::npos ? high : low) = middle;
  }
  return high;
}

// Whether the address sanitizer, which wants terabytes of addresses, keeps from limits.
bool limits_are_kept_off() {
#ifdef __SANITIZE_ADDRESS__
  std::cout << "SKIPPED: the sanitizer takes memory of its own\n";
  return true;
#else
  return false;
#endif
}

}  // namespace

// N_VClone wrote into vectors that it was not given, KINInit freed twice, and FFTW aborts: a third of the
// limits ended in signal 11 or 6. The steps, in kB, stop what takes 3 to 150 MB above the program at all of
// its stages.
TEST_CASE("a tool that is given too little memory by the system says so in one line, and exits with 1",
          "[memory][contract][slow]") {
  if (limits_are_kept_off()) return;
  const int least = least_to_load();
  const std::string kernel = "asperity-kernel -q -o o.nc --length ";
  struct Case {
    std::string line;
    int expected, step;
  };
  for (const auto& [line, expected, step] :
       {Case{kernel + "90px", 0, 700}, Case{kernel + "90px --formulation oriented", 0, 900},
        Case{kernel + "30px --lags 60x60 --formulation patir", 0, 150},
        Case{kernel + "60px --method spectral", 0, 2000}, Case{kernel + "60px --lags 60x60", 0, 500},
        Case{"asperity-generate -q -o o.nc --shape 400x400 --size 1mm --rq 1um --length 60px --seed 1 "
             "--threads 2",
             0, 900},
        Case{"asperity-generate -q -o o.nc --shape 256x256 --size 1mm --rq 1um --length 70px --seed 1 "
             "--periodic",
             0, 900}}) {
    int refused = 0, done = 0;
    for (int above = 100; done < 2 && above < 400000; above += step) {
      const Outcome run = shell("ulimit -c 0 -v " + std::to_string(least + above) + "; " + line);
      CAPTURE(line, least, above, run.exit, run.error);
      if (run.exit == expected) {
        ++done;
        continue;
      }
      ++refused;
      done = 0;
      CHECK(run.exit == 1);
      CHECK_THAT(run.error, ContainsSubstring("out of memory\n"));
    }
    CAPTURE(line);
    CHECK(refused >= 5);
    CHECK(done == 2);
  }
}
