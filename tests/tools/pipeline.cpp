#include <nlohmann/json.hpp>

#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "support.hpp"
#include "tools/cli/toolbox.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string generate =
    "asperity-generate --shape 32x32 --size 3mm --rq 0.4um --model gaussian --length 8px --seed 7";
const std::string contact =
    "asperity-contact --radius 50mm,50mm --young 208GPa --poisson 0.3 --load 5000N --yield 1200MPa";
const std::string stress = "asperity-stress --depths 0:0.8mm:4";

}  // namespace

TEST_CASE("generate | contact | stress | stats ends in a table with the rms roughness asked for",
          "[pipeline][statistics]") {
  const Outcome run = shell(generate + " | " + contact + " | " + stress + " | asperity-stats --json");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  const auto sq = nlohmann::json::parse(run.out)["Sq"];
  // A surface of a few correlation lengths: within five of the standard errors that the tool itself states.
  CHECK(std::abs(sq["value"].get<double>() - 0.4e-6) <= 5 * sq["standard_error"].get<double>());
  CHECK(lines(run.error) == 2);
  CHECK_THAT(run.error, ContainsSubstring("asperity-stress: warning: 1 of 4 layers lie less than") &&
                            ContainsSubstring("asperity-stress: warning: von Mises stress reaches"));
}

TEST_CASE("each tool of a chain leaves one line of history, the newest first", "[pipeline][contract]") {
  REQUIRE(shell(generate + " | " + contact + " | " + stress + " -o chain.nc").exit == 0);
  const std::string history = read_dataset("chain.nc").attributes.text("history");
  CHECK(std::count(history.begin(), history.end(), '\n') == 2);
  CHECK(history.find("asperity-stress") < history.find("asperity-contact"));
  CHECK(history.find("asperity-contact") < history.find("asperity-generate"));
}

TEST_CASE("a chain passes on the target and whatever it does not understand", "[pipeline][contract]") {
  REQUIRE(shell(generate + " -o rough.nc").exit == 0);
  Dataset data = read_dataset("rough.nc");
  data.put({"note", {}, std::vector<float>{2.5F}, {}});
  data.attributes.set("operator", "a person");
  write_dataset(data, "noted.nc");
  REQUIRE(shell(contact + " noted.nc | " + stress + " -o noted-chain.nc").exit == 0);
  const Dataset back = read_dataset("noted-chain.nc");
  CHECK(back.at("note").values == Values(std::vector<float>{2.5F}));
  CHECK(back.attributes.text("operator") == "a person");
  CHECK(back.has("acf_target"));
}

TEST_CASE("the same seed gives the same bytes, whatever the number of threads", "[pipeline][law]") {
  const std::string chain = " --no-history --threads ";
  auto bytes = [&](const std::string& threads) {
    const Outcome run = shell(generate + chain + threads + " | " + contact + chain + threads + " | " +
                              stress + chain + threads + " -o t" + threads + ".nc");
    INFO(run.error);
    REQUIRE(run.exit == 0);
    Dataset data = read_dataset("t" + threads + ".nc");
    for (const char* timing :
         {"kernel_seconds", "generate_seconds", "contact_setup_seconds", "contact_seconds", "stress_seconds"})
      data.attributes.erase(timing);
    return encode_netcdf(data);
  };
  CHECK(bytes("1") == bytes("2"));
}

TEST_CASE("a reader that closes the pipe ends a tool by SIGPIPE, without a word", "[pipeline][contract]") {
  const Outcome run =
      shell("asperity-generate --shape 512x512 --size 3mm --rq 1um --length 4px --seed 1 | head -c 10");
  CHECK(run.exit == 128 + 13);
  CHECK(run.error.empty());
}

TEST_CASE("a full disk is an error of every tool that writes", "[pipeline][contract]") {
  REQUIRE(shell(generate + " | " + contact + " -o pressed.nc").exit == 0);
  for (const std::string& line :
       {generate, contact + " pressed.nc", stress + " pressed.nc", std::string("asperity-stats pressed.nc"),
        std::string("asperity-acf pressed.nc"), std::string("asperity-pdf pressed.nc"),
        std::string("asperity-psd pressed.nc"), std::string("asperity-kernel -q --length 4px"),
        std::string("asperity-stats --help")}) {
    const Outcome run = shell(line + " > /dev/full");
    CAPTURE(line, run.error);
    CHECK(run.exit == 1);
    CHECK(lines(run.error) == 1);
  }
}

TEST_CASE("a named output is whole or absent", "[pipeline][contract]") {
  CHECK(shell(generate + " -o no-such-folder/a.nc").exit == 1);
  REQUIRE(shell(generate + " -o kept.nc").exit == 0);
  const Outcome failed =
      shell("ulimit -f 4; trap '' XFSZ; " + generate + " --shape 256x256 -o kept.nc; echo $? > code; ls");
  CAPTURE(failed.error, failed.out);
  CHECK(grid_of(read_dataset("kept.nc")).shape == Shape{32, 32});
  CHECK(failed.out.find(".part") == std::string::npos);
}

// A link used to be replaced by the file itself; run as root, with /dev/stdout, that damaged the machine.
TEST_CASE("an output that is a symbolic link stays one, and its target is written", "[pipeline][contract]") {
  REQUIRE(shell("ln -sf target.nc link.nc && " + generate + " -o link.nc && test -L link.nc").exit == 0);
  CHECK(grid_of(read_dataset("target.nc")).shape == Shape{32, 32});
  CHECK(shell("asperity-generate --shape 4x4 --size 3mm --rq 1um --length 2px -o x.nc --report /dev/stdout > "
              "out.json; "
              "test -L /dev/stdout && grep -q generate_seed out.json")
            .exit == 0);
}

TEST_CASE("wrong usage is exit 2 and one line that names the tool and the option", "[contract]") {
  const std::pair<std::string, std::string> wrong[] = {
      {"asperity-generate --bogus", "--bogus"},
      {"asperity-generate --shape 32x32 --size 3mm --rq 0.4um --length=-4px", "--length"},
      {"asperity-generate --shape 32x32 --size 3mm --rq=-1um --length 4px", "--rq"},
      {"asperity-generate --shape 0x32 --size 3mm --rq 1um --length 4px", "--shape"},
      {"asperity-generate --shape 32x32 --size 3 --rq 1um --length 4px", "--size"},
      {"asperity-generate --shape 32x32 --size 3mm --rq 1um --length 4px --seed=-1", "--seed"},
      {"asperity-kernel --length 4px --length-level 1.5", "--length-level"},
      {generate + " | asperity-contact --radius 50 --young 208GPa --poisson 0.3 --load 5000N", "--radius"},
      {generate + " | asperity-contact --radius 50mm --young 208GPa --poisson 0.6 --load 5000N", "--poisson"},
      {generate + " | asperity-contact --radius 50mm --young 208GPa --poisson 0.3 --load=-1N", "--load"},
      {generate + " | asperity-contact --radius 50mm --young 208GPa --poisson 0.3 --load 1MN --yield 1200MPa",
       "--load"},
      {generate + " | " + contact + " | asperity-stress --depths=-1mm,2mm", "--depths"},
      {generate + " | " + contact + " | asperity-stress --depths 0:1mm:0", "--depths"},
  };
  for (const auto& [line, option] : wrong) {
    const Outcome run = shell(line);
    CAPTURE(line, run.error);
    CHECK(run.exit == 2);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring("asperity-") && ContainsSubstring(option));
  }
}

TEST_CASE("a load beyond what the limit pressure carries names the largest load", "[contract]") {
  const Outcome run = shell(
      generate +
      " | asperity-contact --radius 50mm --young 208GPa --poisson 0.3 --load 50kN --limit-pressure 1GPa");
  CHECK(run.exit == 2);
  CHECK_THAT(run.error, ContainsSubstring("9000"));  // 1 GPa · 9 mm²
}

// Of an exponential that has hardly fallen at its cut the nearest autocorrelation is farther than the tolerance.
TEST_CASE("what did not converge is exit 3, a warning and a dataset that says so", "[contract]") {
  const std::pair<std::string, std::string> unsolved[] = {
      {"asperity-kernel --length 40px --lags 4x4 --infeasible nearest -o unsolved.nc", "kernel_converged"},
      {"asperity-generate --shape 96x96 --size 1mm --rq 1um --length 40px --lags 4x4 "
       "--infeasible nearest -o unsolved.nc",
       "kernel_converged"},
      {generate + " | " + contact + " --tolerance 1e-9 --max-convolutions 2 -o unsolved.nc",
       "contact_converged"},
  };
  for (const auto& [line, attribute] : unsolved) {
    const Outcome run = shell("rm -f unsolved.nc; " + line);
    CAPTURE(line, run.error);
    CHECK(run.exit == 3);
    CHECK(lines(run.error) == 1);
    CHECK(read_dataset("unsolved.nc").attributes.number(attribute, 1) == 0);
  }
}

TEST_CASE("bad data is exit 4 and one line that names the variable", "[contract]") {
  REQUIRE(shell(generate + " -o good.nc").exit == 0);
  Dataset data = read_dataset("good.nc");
  std::get<std::vector<double>>(data.find("heights")->values)[5] = std::nan("");
  write_dataset(data, "nan.nc");
  data.erase("heights");
  write_dataset(data, "none.nc");
  const std::pair<std::string, std::string> bad[] = {
      {"head -c 5000 good.nc | " + contact, "cut short"},
      {"head -c 50 good.nc | " + contact, "dataset"},
      {"echo hello > hello.txt; " + contact + " hello.txt", "map"},
      {contact + " nan.nc", "heights"},
      {contact + " none.nc", "heights"},
      {"asperity-stats none.nc", "heights"},
      {"asperity-acf none.nc", "heights"},
      {"asperity-pdf none.nc", "heights"},
      {"asperity-psd none.nc", "heights"},
      {stress + " --poisson 0.3 good.nc", "pressure"},
  };
  for (const auto& [line, variable] : bad) {
    const Outcome run = shell(line);
    CAPTURE(line, run.error);
    CHECK(run.exit == 4);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring(variable));
  }
}

TEST_CASE("the command line comes before the environment, and that before the file", "[contract]") {
  const std::string base = "asperity-generate --shape 8x8 --size 3mm --rq 1um --length 2px -o s.nc ";
  auto seed = [&](const std::string& before, const std::string& after) {
    const Outcome run = shell("echo 'seed = 1' > three.toml; " + before + base + after);
    INFO(run.error);
    REQUIRE(run.exit == 0);
    return read_dataset("s.nc").attributes.number("generate_seed", -1);
  };
  CHECK(seed("", "--config three.toml") == 1);
  CHECK(seed("ASPERITY_GENERATE_SEED=2 ", "--config three.toml") == 2);
  CHECK(seed("ASPERITY_GENERATE_SEED=2 ", "--config three.toml --seed 3") == 3);
  CHECK(shell("echo 'sede = 1' > bad.toml; " + base + "--config bad.toml").exit == 2);
}

TEST_CASE("SOURCE_DATE_EPOCH and a seed make two runs equal to the byte", "[contract]") {
  const std::string run = "SOURCE_DATE_EPOCH=0 " + generate + " -o a.nc";
  REQUIRE(shell(run + " && mv a.nc b.nc").exit == 0);
  await_next_second();  // which another history would tell
  REQUIRE(shell(run).exit == 0);
  CHECK(shell("cmp a.nc b.nc").exit == 0);
  CHECK_THAT(read_dataset("a.nc").attributes.text("history"),
             ContainsSubstring("1970-01-01T00:00:00Z: asperity-generate"));
}

TEST_CASE("every tool tells its help, with its groups and an example, and its version", "[contract]") {
  for (const cli::Summary& summary : cli::toolbox) {
    const std::string tool(summary.tool);
    CAPTURE(tool);
    const Outcome help = shell(tool + " --help");
    CHECK(help.exit == 0);
    CHECK(help.error.empty());
    CHECK_THAT(help.out, ContainsSubstring("Common:") && ContainsSubstring("Example:") &&
                             ContainsSubstring("Accuracy:"));
    const Outcome version = shell(tool + " --version");
    CHECK(version.exit == 0);
    CHECK_THAT(version.out, ContainsSubstring("FFTW") && ContainsSubstring("NetCDF"));
  }
}

TEST_CASE("a kernel made apart draws the same surface as one made on the way", "[pipeline][law]") {
  REQUIRE(shell(generate + " --no-history -o direct.nc").exit == 0);
  const Outcome piped = shell(
      "asperity-kernel --model gaussian --length 8px --rq 0.4um | asperity-generate --kernel - --shape 32x32 "
      "--size 3mm "
      "--seed 7 --no-history -o piped.nc");
  INFO(piped.error);
  REQUIRE(piped.exit == 0);
  const Field direct = field_of(read_dataset("direct.nc"), "heights"),
              apart = field_of(read_dataset("piped.nc"), "heights");
  // Scaling before or behind the sum: a rounding each of some thousand terms.
  CHECK((direct - apart).abs().maxCoeff() <= 1e-12 * direct.abs().maxCoeff());
}
