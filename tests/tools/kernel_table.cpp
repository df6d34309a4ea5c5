// Tables of measured autocorrelations as targets.
#include <cmath>

#include "acf/kernel.hpp"
#include "tools/kernel_runs.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("a table of columns has its units, any order of columns and other columns beside",
          "[kernel][exact]") {
  write_text(
      "columns.txt",
      "# by hand\n# acf [um2]\tlag_y [um]\tnoise\tlag_x [um]\n4;0;0;0\n1;2;0;0\n\n2;0;0;5\r\n0,5;2;9;5\n");
  const Attributes a = solved("--acf columns.txt --lags 2x2");
  const Dataset data = read_dataset("solved.nc");
  CHECK(a.text("kernel_target") == "table");
  CHECK(a.number("kernel_rms", 0) == Approx(2e-6).epsilon(1e-14));
  CHECK(data.at("acf_target").attributes.text("units") == "m2");
  CHECK(numbers(data.at("p").values)[1] == Approx(5e-6).epsilon(1e-14));
  CHECK(numbers(data.at("q").values).back() / 7 == Approx(2e-6).epsilon(1e-14));  // of a kernel of 7 columns
  const Field target = known_lags(table_of(data, "acf_target", "", Missing::not_a_number));
  CHECK(target(1, 0) == Approx(0.5e-12).epsilon(1e-14));
  CHECK(solved("--acf columns.txt --rq 1um").number("kernel_rms", 0) == Approx(1e-6).epsilon(1e-14));
}

TEST_CASE("a plain matrix is a quadrant in samples, from standard input too", "[kernel][exact]") {
  write_text("matrix.txt", "1 0.4 0.1\n0.5 0.2 0.05\n");
  const Field target = target_of("--acf matrix.txt");
  Field half(2, 5);
  half << 0.1, 0.4, 1, 0.4, 0.1, 0.05, 0.2, 0.5, 0.2, 0.05;
  CHECK((target == half).all());
  CHECK((target_of("--acf - < matrix.txt") == half).all());
  CHECK(read_dataset("solved.nc").at("p").attributes.text("units") == "1");
  refused("asperity-generate --acf matrix.txt --shape 9x9 --size 1mm", 2, "--rq");
  refused("asperity-generate --acf matrix.txt --rq 1um --size 1mm", 2, "--shape");
  CHECK(shell("asperity-generate --acf matrix.txt --rq 1um --shape 9x9 --size 9um -o drawn.nc").exit == 0);
}

TEST_CASE("a text that is no autocorrelation is exit 4 and one line that names acf", "[kernel][contract]") {
  const std::string bad[] = {"",
                             "\n\n",
                             "# lag_x lag_y acf\n",
                             "0 0.5\n0.5 0.2\n",
                             "-1 0\n",
                             "1 1.5\n0.5 0.2\n",
                             "1 nan\n",
                             "1 inf\n",
                             "1 1e400\n",
                             "1 0.5\n0.5\n",
                             "1 0.5 x\n",
                             "%PDF-1.7 \x01\x02\xff",
                             std::string("\0\0\0\0", 4),
                             "# lag_x acf\n0 1\n",
                             "# lag_x [um] lag_y acf\n0 0 1\n",
                             "# lag_x [s] lag_y [s] acf\n0 0 1\n1 0 .5\n",
                             "# lag_x lag_y acf\n0 0 1\n1 0 .5\n3 0 .2\n",
                             "# lag_x lag_y acf\n0 0 1\n1 0 .5\n2.5 0 .2\n",
                             "# lag_x lag_y acf\n0 0 1\n1e-300 0 .5\n1e300 0 .2\n",
                             "# lag_x lag_y acf\n0 0 1\n0 1 .5\n0 -1 .4\n",
                             "# lag_x lag_y acf\n0 0\n",
                             "# lag_x lag_y acf\n0,0,1\n1,,0.5\n",  // once two numbers on a line
                             "1,5;0\n0,5 0\n"};
  for (const std::string& text : bad) {
    write_text("bad.txt", text);
    CAPTURE(text);
    refused("asperity-kernel --acf bad.txt", 4, text.empty() ? "bad.txt: it is empty" : "acf");
  }
  CHECK(shell("asperity-kernel --acf no-such-file -o absent.nc").exit == 1);
}

TEST_CASE("a dataset whose table is none, or does not fit its grid, is exit 4", "[kernel][contract]") {
  const Grid grid{{8, 8}, 1e-6, 1e-6, false};
  auto write = [&](const Field& acf, Axis row, Axis column) {
    Dataset data;
    set_grid(data, grid);
    set_table(data, "acf", acf, row, column, {"1", "autocorrelation"}, Missing::not_a_number);
    write_dataset(data, "table.nc");
  };
  Field acf(2, 3);
  acf << 0.5, 1, 0.5, 0.2, 0.5, 0.2;
  write(acf, {"lag_x", 0, 1e-6, "m"}, {"lag_y", -1, 1e-6, "m"});
  REQUIRE(shell("asperity-kernel --acf table.nc -o fits.nc").exit == 0);
  refused("asperity-kernel --acf table.nc --spacing 2um", 2, "--spacing");
  for (const char* option : {"--length 4px", "--model gaussian", "--angle 3deg", "--length-level 0.2"})
    refused("asperity-kernel --acf table.nc " + std::string(option), 2, "--acf");
  refused("asperity-kernel --acf table.nc --lags 3x2", 2, "--lags");
  refused("asperity-generate --acf table.nc --kernel fits.nc --rq 1um", 2, "--acf");

  write(acf, {"lag_x", 0, 2e-6, "m"}, {"lag_y", -1, 1e-6, "m"});
  refused("asperity-kernel --acf table.nc", 4, "acf");
  write(acf, {"lag_x", 1, 1e-6, "m"}, {"lag_y", -1, 1e-6, "m"});
  refused("asperity-kernel --acf table.nc", 4, "acf");
  write(acf, {"lag_x", 0, 1e-6, "s"}, {"lag_y", -1, 1e-6, "s"});
  refused("asperity-kernel --acf table.nc", 4, "acf");
  write(acf.leftCols(2), {"lag_x", 0, 1e-6, "m"}, {"lag_y", -1, 1e-6, "m"});
  refused("asperity-kernel --acf table.nc", 4, "acf");
  acf(1, 2) = std::nan("");
  write(acf, {"lag_x", 0, 1e-6, "m"}, {"lag_y", -1, 1e-6, "m"});
  refused("asperity-kernel --acf table.nc", 4, "acf");
  Dataset none;
  set_grid(none, grid);
  write_dataset(none, "none.nc");
  refused("asperity-kernel --acf none.nc", 4, "acf");
}

// No surface: E(z0 + z1 + z2)² would be negative. Neither answer is within the tolerance that was asked for.
TEST_CASE("a table that no surface has is exit 4, or the nearest with exit 3 and a warning",
          "[kernel][contract]") {
  write_text("wave.txt", "1 0.9 -0.9\n0.9 -0.9 0.9\n-0.9 0.9 0.9\n");
  refused("asperity-kernel --acf wave.txt", 4, "acf");
  refused("asperity-kernel --acf wave.txt --infeasible error", 4, "acf");
  const Outcome run = shell("asperity-kernel -q --acf wave.txt --infeasible nearest -o nearest.nc");
  CAPTURE(run.error);
  CHECK(run.exit == 3);
  CHECK((lines(run.error) == 1 && run.error.find("exceeds --acf-tolerance 0.001") != std::string::npos));
  const Attributes a = read_dataset("nearest.nc").attributes;
  CHECK(a.text("kernel_answer") == "nearest");
  CHECK(a.number("kernel_change", 0) > 1e-2);
  CHECK(a.number("kernel_converged", 1) == 0);
}

// One lag of 35 was kept of this kind of table, said to be solved, and the twin had 0.20 where 0.91 was asked
// for.
TEST_CASE("the twin of a levelled and filtered map has its autocorrelation at every lag of the table",
          "[kernel][contract][slow]") {
  const std::string measured =
      " " ASPERITY_TEST_DATA "/profiler-96x96.x3p --remove-form 2 --lambda-s 1um --lambda-c 12um";
  for (const std::string more : {" --biased", " --biased --max-lag 20x15"}) {
    REQUIRE(shell("asperity-acf" + measured + more + " -o a.nc").exit == 0);
    const Outcome run = shell("asperity-generate --acf a.nc --seed 1 --add kernel -o t.nc");
    CAPTURE(more, run.error);
    CHECK(run.exit == 0);
    const Dataset twin = read_dataset("t.nc");
    const Field asked = table_of(read_dataset("a.nc"), "acf"), kernel = table_of(twin, "kernel");
    const Index middle = asked.cols() / 2;
    const double variance = kernel.square().sum();
    const Field drawn = autocorrelation(kernel, asked.rows(), asked.cols()) / variance;
    CHECK((drawn - asked / asked(0, middle)).abs().maxCoeff() <= 1e-3);
    CHECK(twin.attributes.number("kernel_error", 1) <= 1e-3);
    CHECK(twin.attributes.number("kernel_converged", 0) == 1);
    // As far as the kernel reaches, and no farther than it is known what was asked for.
    const Field achieved = table_of(twin, "acf_achieved"),
                target = table_of(twin, "acf_target", "", Missing::not_a_number);
    CHECK(achieved.rows() == kernel.rows() + 1);
    CHECK(shape_of(known_lags(target)) == shape_of(asked));
    // A twin's own target is a table again.
    CHECK(shell("asperity-kernel -q --acf t.nc -o again.nc").exit == 0);
  }
}

// The far lags of an unbiased estimate are mostly noise. Whatever is made of them is judged by the error over
// them all.
TEST_CASE("a table under noise is refused or not converged, by its error over all lags, -q or not",
          "[kernel][contract]") {
  std::string rows;
  unsigned random = 1;  // a linear congruence of numbers between -1 and 1
  for (int p = 0; p < 12; ++p) {
    for (int q = 0; q < 12; ++q) {
      random = random * 1664525u + 1013904223u;
      const double noise = p + q == 0 ? 0 : 0.05 * (random / 2147483648.0 - 1);
      rows += std::to_string(std::exp(-std::hypot(p, q) / 3) + noise) + " ";
    }
    rows += "\n";
  }
  write_text("noisy.txt", rows);
  refused("asperity-kernel -q --acf noisy.txt", 4, "a biased estimate");
  const Outcome run = shell("asperity-kernel -q --acf noisy.txt --infeasible nearest -o noisy.nc");
  CAPTURE(run.error);
  CHECK(run.exit == 3);
  // A change within the tolerance was silent for a table.
  const Outcome tolerated = shell("asperity-kernel -q --acf noisy.txt --acf-tolerance 0.5 -o tolerated.nc");
  CHECK((tolerated.exit == 0 && lines(tolerated.error) == 1));
  CHECK_THAT(tolerated.error,
             ContainsSubstring("the kernel of the nearest feasible one changes it by up to"));
  const Attributes a = read_dataset("noisy.nc").attributes;
  CHECK(numbers(*a.find("kernel_lags")) == std::vector<double>{12, 12});
  CHECK(a.number("kernel_error", 0) > 1e-2);
  // Fewer lags are met, and it is said that the others are not.
  const Outcome few = shell("asperity-kernel -q --acf noisy.txt --lags 3x3 -o few.nc");
  CHECK(few.exit == 0);
  CHECK((lines(few.error) == 1 && few.error.find("only the 3x3 prescribed lags") != std::string::npos));
}

// 24 × 20 lags were given, 15 × 18 used, without a word.
TEST_CASE("the table of a periodic surface is used as a whole", "[kernel][contract]") {
  REQUIRE(shell("asperity-generate --shape 48x40 --size 48um,40um --length 3px --rq 1um --periodic --seed 2 "
                "-o p.nc")
              .exit == 0);
  REQUIRE(shell("asperity-acf p.nc -o pa.nc").exit == 0);
  const Outcome run = shell("asperity-kernel -q --acf pa.nc -o pk.nc");
  CAPTURE(run.error);
  const Attributes a = read_dataset("pk.nc").attributes;
  CHECK(numbers(*a.find("kernel_lags")) == std::vector<double>{25, 21});
  CHECK((a.number("kernel_converged", 0) == 1) == (a.number("kernel_error", 1) <= 1e-3));
  CHECK((run.exit == 0) == (a.number("kernel_error", 1) <= 1e-3));
}

TEST_CASE("a table of columns may hold (0,q) and (0,-q), equal to round-off", "[kernel][contract]") {
  write_text("both.txt", "# lag_x lag_y acf\n0 0 1\n0 1 1e-17\n0 -1 -1e-17\n1 0 0.5\n1 1 0.2\n1 -1 0.2\n");
  CHECK(shell("asperity-kernel -q --acf both.txt -o both.nc").exit == 0);
  write_text("differ.txt", "# lag_x lag_y acf\n0 0 1\n0 1 1e-7\n0 -1 -1e-7\n1 0 0.5\n1 1 0.2\n1 -1 0.2\n");
  refused("asperity-kernel --acf differ.txt", 4, "acf");
}

// A moving average of 400 × 300 points; its own ACF, biased and so positive definite but for the cut at 24
// lags, is the target of the twin. The ensemble of the twin has acf_achieved, which is within kernel_error of
// it.
TEST_CASE("a surface's autocorrelation flows into a kernel and on into a twin", "[kernel][law]") {
  REQUIRE(
      shell(
          "asperity-generate --shape 400x300 --size 0.4mm,0.6mm --rq 0.4um --length 6px,3px --seed 3 -o s.nc")
          .exit == 0);
  Dataset own = read_dataset("s.nc");
  own.attributes.set("instrument", "kept");
  write_dataset(own, "s.nc");
  const Outcome run = shell(
      "asperity-acf s.nc --biased --max-lag 24x16 | asperity-kernel --acf -"
      " | asperity-generate --seed 4 > twin.nc");
  CAPTURE(run.error);
  REQUIRE(run.exit == 0);
  const Dataset twin = read_dataset("twin.nc");
  const Grid grid = grid_of(twin);
  CHECK(grid.shape == Shape{400, 300});
  CHECK(grid.dx == Approx(1e-6).epsilon(1e-12));
  CHECK(grid.dy == Approx(2e-6).epsilon(1e-12));
  CHECK(twin.attributes.text("instrument") == "kept");
  CHECK(twin.attributes.text("kernel_target") == "table");
  CHECK_FALSE(twin.has("acf"));
  CHECK(twin.attributes.find("acf_variance") == nullptr);
  CHECK(twin.attributes.find("kernel_length") == nullptr);
  for (const char* tool : {"asperity-acf", "asperity-kernel", "asperity-generate"})
    CHECK_THAT(twin.attributes.text("history"), ContainsSubstring(tool));
  CHECK_FALSE(numbers(twin.at("heights").values) == numbers(own.at("heights").values));

  REQUIRE(shell("asperity-acf s.nc --biased --absolute --max-lag 24x16 -o a.nc").exit == 0);
  const Field wanted = table_of(read_dataset("a.nc"), "acf"), achieved = table_of(twin, "acf_achieved");
  const double variance = wanted(0, 16), error = twin.attributes.number("kernel_error", 1);
  const Field near = achieved.block(0, achieved.cols() / 2 - 16, 25, 33);
  CHECK((wanted - near).abs().maxCoeff() <= (error + 1e-12) * variance);
  CHECK(error <= 1e-3);
}

TEST_CASE("a kernel's own target is a table for --acf, which finds the same kernel again", "[kernel][law]") {
  const Field target = target_of("--length 5px,3px --rq 1um --spacing 1um --lags 15x9");
  REQUIRE(shell("mv solved.nc own.nc; asperity-kernel -q --acf own.nc --lags 15x9 -o again.nc").exit == 0);
  const Dataset own = read_dataset("own.nc"), again = read_dataset("again.nc");
  const Field a = table_of(own, "kernel"), b = table_of(again, "kernel");
  REQUIRE(shape_of(a) == shape_of(b));
  CHECK((a - b).abs().maxCoeff() <= 1e-8 * a.abs().maxCoeff());
  CHECK(shape_of(target) == shape_of(table_of(again, "acf_target")));
}
