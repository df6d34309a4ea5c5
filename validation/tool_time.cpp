/// What a tool costs beyond its library: start-up, reading, copies, printing.
///
///     tool_time [N...]       512 2048 unless given
///
/// A surface of N × N heights, exponential autocorrelation of 10 % length 20 cells, is drawn into a file
/// beside that. Every tool then works on this file, one thread, and the library does the same work on heights
/// in memory:
///     version           nothing: the tool starts and ends
///     heights           moments of asperity-stats without errors
///     errors            height parameters with errors by theory; of less than half a million heights the tool
///                       simulates those of extremes too
///     acf               the autocorrelation at lags up to half the field, written as a dataset
///     lengths           its lengths with errors, printed
///     psd               the power spectral density, written as a dataset
///     plane             asperity-filter --remove-form plane
///     matrix            asperity-convert to npy: no work
/// tool, library   seconds; ratio: tool over library
/// fields          peak memory of the tool beyond that of `version`, in fields of N × N doubles
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "acf/table.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/sample/moments.hpp"
#include "stats/spectrum/spectrum.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

using Words = std::vector<std::string>;

struct Cost {
  Seconds seconds;
  double megabytes = NAN;
};

// One run, its output thrown away.
Cost run(Words words) {
  words.front() = std::string(ASPERITY_BIN "/asperity-") + words.front();
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::fflush(stdout);
  const Stopwatch watch;
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int fd : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(::open("/dev/null", O_WRONLY), fd);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  int status = 0;
  rusage used{};
  if (child < 0 || ::wait4(child, &status, 0, &used) != child || status != 0)
    throw std::runtime_error(words[0] + " fails");
  const double seconds = watch.seconds();
  return {{seconds, seconds}, static_cast<double>(used.ru_maxrss) * 1024e-6};
}

Cost several_runs(const Words& words) {
  Runs runs;
  double megabytes = 0;
  repeat([&] {
    const Cost one = run(words);
    runs.add(one.seconds);
    megabytes = std::max(megabytes, one.megabytes);
  });
  return {runs.seconds(), megabytes};
}

struct Work {
  std::string name;
  Words tool;
  std::function<void(const Surface&)> alone;
};

void height_errors(const Surface& surface) {
  MeasureOptions options;
  measure(Sample(surface), Group::height, options);
}

void acf(const Surface& surface) {
  const AcfEstimate found = AcfEstimate::of(surface, {.max_lag = default_max_lag(surface.grid)});
  acf_lengths(found, {{1 / std::numbers::e, "e", "1/e"}}, {}, {}, {});
}

void lengths(const Surface& surface) {
  const AcfEstimate found = AcfEstimate::of(surface, {.max_lag = default_max_lag(surface.grid)});
  const LengthErrors errors(found, surface.heights, 0.1, 1);
  acf_lengths(found, {{0.1, "10", "10 %"}, {1 / std::numbers::e, "e", "1/e"}}, {}, {}, errors);
}

std::vector<Work> works(const std::string& file, const std::string& folder) {
  const std::string out = folder + "/out.nc";
  return {
      {"version", {"stats", "--version"}, nullptr},
      {"heights",
       {"stats", file, "--parameters", "height", "--errors", "none"},
       [](const Surface& s) { moments(s.heights); }},
      {"errors", {"stats", file, "--parameters", "height"}, height_errors},
      {"acf", {"acf", file, "-o", out}, acf},
      {"lengths", {"acf", file, "--result", "lengths"}, lengths},
      {"psd",
       {"psd", file, "-o", out},
       [](const Surface& s) { power_spectrum(s.heights, s.grid, default_windows(s.grid)); }},
      {"plane",
       {"filter", file, "--remove-form", "plane", "-o", out},
       [](const Surface& s) { remove_form(s.heights, 1); }},
      {"matrix", {"convert", file, "-o", folder + "/out.npy"}, nullptr},
  };
}

// With the correlation that the heights were drawn with, which the tools find in the file.
Surface surface_in(const std::string& file) {
  const Dataset data = open_netcdf(file);
  Surface out{.grid = grid_of(data), .heights = field_of(data, "heights")};
  out.correlation = LagField(known_lags(table_of(data, "acf_achieved"))).normalised();
  return prepared(std::move(out), {});
}

// The tools first: a child begins with the memory of this process, which counts as its own.
void print(Index n, const std::string& folder) {
  const std::string file = fmt::format("{}/{}.nc", folder, n);
  run({"generate", "--shape", fmt::format("{}x{}", n, n), "--size", "3mm", "--rq", "0.4um", "--length",
       "20px", "--seed", "1", "-o", file});
  const std::vector<Work> all = works(file, folder);
  std::vector<Cost> tools;
  for (const Work& work : all) {
    Words words = work.tool;
    if (work.name != "version" && work.name != "matrix") words.insert(words.end(), {"--threads", "1"});
    tools.push_back(several_runs(words));
  }
  const Surface surface = surface_in(file);
  const double field = static_cast<double>(n * n) * sizeof(double) / 1e6;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Seconds library = all[k].alone ? seconds_of([&] { all[k].alone(surface); }) : Seconds{NAN, NAN};
    fmt::print("{}\t{}\t{:.2g}\t{:.2g}\t{:.2g}\t{:.2g}\n", all[k].name, n, tools[k].seconds, library,
               tools[k].seconds / library, (tools[k].megabytes - tools[0].megabytes) / field);
    std::fflush(stdout);
  }
  std::filesystem::remove(file);
}

// In a process of its own, without the memory of what was measured before.
void print_apart(Index n, const std::string& folder) {
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    print(n, folder);
    std::fflush(stdout);
    ::_exit(0);
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child || status != 0)
    throw std::runtime_error(fmt::format("{0} x {0} fails", n));
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("asperity-tool-time-{}", ::getpid());
  std::filesystem::create_directory(folder);
  fmt::print("# case\tN\ttool\ttool_spread\tlibrary\tlibrary_spread\tratio\tfields\n");
  if (argc < 2) {
    for (const Index n : {512, 2048}) print_apart(n, folder);
  } else {
    for (int k = 1; k < argc; ++k) print_apart(std::atoi(argv[k]), folder);
  }
  std::filesystem::remove_all(folder);
}
