// Tests whether surfaces have the prescribed heights, slopes, autocorrelation and lengths.
#include <algorithm>
#include <cmath>
#include <optional>

#include "acf/kernel.hpp"
#include "acf/table.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "marginal/prescribed.hpp"
#include "stats/hypothesis/specification.hpp"
#include "tools/cli/ensemble_input.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/cli/table.hpp"
#include "tools/measure/field_options.hpp"
#include "tools/surface/acf_table.hpp"

using namespace asperity;

namespace {

constexpr int not_as_prescribed = 5;

struct Options {
  cli::EnsembleInput surfaces;
  std::string target, variable = "heights";
  double rq = NAN, skewness = NAN, kurtosis = NAN, significance = 0.01;

  void declare(cli::Tool& tool) {
    const std::string asked = "Prescribed", answer = "Answer";
    surfaces.declare(tool);
    tool.text("--variable", variable, "NAME",
              "Field on (x, y) to measure. Missing points (mask, _FillValue, NaN) are left out", "Field");
    tool.text(
        "--acf", target, "FILE",
        "Prescribed autocorrelation. A table as asperity-kernel --acf reads it. Default: acf_target of the "
        "first surface",
        asked);
    tool.quantity("--rq", rq, "m", "Prescribed rms height. Default: that of the target, if it has one",
                  asked);
    tool.number("--skewness", skewness,
                "Prescribed skewness. Default: that the first surface was drawn with, else 0", asked);
    tool.number(
        "--kurtosis", kurtosis,
        "Prescribed kurtosis. Default: that the first surface was drawn with, else 3 + 1.5 SKEWNESS^2, "
        "which is 3 for a Gaussian",
        asked);
    tool.number("--significance", significance,
                "Largest rate of false alarms of all rows together; between 0 and 0.5", answer);
  }

  void check() const {
    if (!std::isnan(rq)) check_rms(rq);
    if (significance > 0 && significance < 0.5) return;
    throw ParameterError("significance",
                         "'" + shortest(significance) + "' is not a number between 0 and 0.5");
  }
};

// From --acf.
Specification from_file(const cli::Tool& tool, const std::string& name, const Grid& grid) {
  const cli::AcfTable table = cli::read_acf_table(name, tool.memory_bound());
  for (const std::size_t axis : {0U, 1U}) {
    const double step = axis == 0 ? grid.dx : grid.dy, lag = table.spacing ? (*table.spacing)[axis] : step;
    if (std::abs(lag - step) > 1e-6 * step)
      throw DataError("acf_target",
                      "its lags are " + shortest(lag) + " m apart, but the heights " + shortest(step) + " m");
  }
  return {.correlation = LagField(table.half_plane), .sq = table.rms};
}

Specification carried(const Dataset& data, const Grid& grid) {
  const std::optional<LagField> rho = cli::carried_correlation(data, "acf_target", grid);
  if (!rho) throw DataError("acf_target", "the first surface has none for its grid; name a table with --acf");
  const bool height = cli::has_height(data.at("acf_target"));
  const Field table = known_lags(table_of(data, "acf_target", height ? "m2" : "1", Missing::not_a_number));
  return {.correlation = *rho, .sq = height ? std::sqrt(table(0, table.cols() / 2)) : NAN};
}

// Of a surface that is drawn on a torus of up to twice its sides.
double drawing_bytes(Shape shape) { return 110 * static_cast<double>(shape.cells()); }

// As many as there is memory for.
int threads_for(const cli::Tool& tool, const Grid& grid) {
  const double most = static_cast<double>(tool.memory()) / drawing_bytes(grid.shape);
  return static_cast<int>(std::clamp(most, 1.0, static_cast<double>(tool.thread_count())));
}

SpecificationTest test_for(const cli::Tool& tool, const Options& o, const Dataset& first,
                           cli::Progress& progress) {
  const Grid grid = grid_of(first);
  if (!o.target.empty()) tool.reads(o.target);
  Specification asked = o.target.empty() ? carried(first, grid) : from_file(tool, o.target, grid);
  if (!std::isnan(o.rq)) asked.sq = o.rq;
  auto expected = [&](double given, const char* attribute, double gaussian) {
    return std::isnan(given) ? first.attributes.number(attribute, gaussian) : given;
  };
  asked.ssk = expected(o.skewness, "generate_skewness_expected", 0);
  asked.sku = expected(o.kurtosis, "generate_kurtosis_expected", gamma_kurtosis(asked.ssk));
  asked.threads = threads_for(tool, grid);
  asked.simulated = [&](Index done, Index of) {
    progress.count(static_cast<double>(done), static_cast<double>(of), "simulated surfaces");
  };
  SpecificationTest test(asked, grid);  // refuses before a warning is due
  cli::warn_of_few(tool, EffectiveSampleSize(asked.correlation, grid));
  return test;
}

void add(const cli::Tool& tool, const Dataset& data, const std::string& variable, SpecificationTest& test) {
  const Field heights = field_of(data, variable, "m", Missing::not_a_number);
  const Grid grid = grid_of(data);
  cli::warn_of_proportions(tool, Proportions(heights, grid));
  test.add(heights, grid);
}

std::string unit_of(const std::string& quantity) {
  return quantity == "Sq" ? "m" : quantity == "summit_density" ? "m-2" : "1";
}

cli::Table table_of_results(const std::vector<TestResult>& results, double significance) {
  auto verdict = [](double p, double level) { return p <= level ? "differs" : "agrees"; };
  cli::Table out{{{"quantity", ""},
                  {"unit", ""},
                  {"prescribed", "SI", cli::Holds::unknown},
                  {"mean", "SI", cli::Holds::unknown},
                  {"standard_error", "SI", cli::Holds::unknown},
                  {"z", "1", cli::Holds::open},
                  {"p", "1"},
                  {"verdict", ""}},
                 {}};
  const double level = significance / static_cast<double>(results.size());
  for (const TestResult& c : results) {
    const std::string lag = "(" + std::to_string(c.lag_x) + "," + std::to_string(c.lag_y) + ")";
    out.rows.push_back({c.quantity == "ACF" ? "ACF" + lag : c.quantity, unit_of(c.quantity), c.prescribed,
                        c.mean, c.standard_error, c.z, c.p, verdict(c.p, level)});
  }
  const double joint = joint_p(results);
  out.rows.push_back({"all", "1", NAN, NAN, NAN, NAN, joint, verdict(joint, significance)});
  return out;
}

int validate(const cli::Tool& tool, Options& options) {
  options.check();
  std::optional<SpecificationTest> test;
  cli::Progress progress(tool);
  options.surfaces.for_each(
      tool, [](cli::EnsembleMember&& member) { return std::move(member); },
      [&](const cli::EnsembleMember& member, const std::string& name) {
        if (!test) test = test_for(tool, options, member.data, progress), tool.reads(name);
        if (member.alone()) tool.detail(name);
        add(tool, member.data, options.variable, *test);
      },
      {.on_one_grid = "the test"});
  const Shape drawn = test->drawn_shape();
  tool.require_memory(drawing_bytes(drawn), "memory", "simulating " + text(drawn) + " points",
                      ": allow more, or cut the surfaces first (asperity-filter --crop)");
  const std::vector<TestResult> results = test->results();
  tool.note(counted(test->surfaces(), "surface") + ", " + counted(test->lags(), "lag") + ", errors from " +
            counted(test->drawn(), "simulated surface"));
  cli::print(tool, table_of_results(results, options.significance));
  return joint_p(results) <= options.significance ? not_as_prescribed : int{cli::done};
}

void document(cli::Tool& tool) {
  tool.exit_status(not_as_prescribed, "the surfaces differ from the prescription");
  tool.essential({"--acf", "--rq", "--skewness", "--kurtosis", "--significance", "--variable", "--json",
                  "--output", "--threads"});
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 12px --seed 1 --count 20 -o "
      "s_%02d.nc && asperity-validate s_*.nc");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-validate",
      "Tests whether one or more surfaces have the prescribed rms height, skewness, kurtosis, rms slope, "
      "density of summits, autocorrelation and lengths. Each row shows a quantity: its prescribed value, the "
      "mean over the surfaces with its "
      "standard error, their difference z in standard errors, the p-value, and the verdict at --significance "
      "shared among the rows. Sdq and summit_density are prescribed by the autocorrelation at lags up to 2 "
      "samples, as differences on this grid show them; without a prescribed rms height, or without these "
      "lags, they are left out. The ACF is tested over all its lags in one row, which shows the lag (x, y in "
      "samples) of the largest deviation. The lengths of the ACF are tested together in the next row, as "
      "factors of the prescribed ones: it shows that along x (length_x), along y (length_y), the mean of "
      "both "
      "(length), or their ratio (length_x/length_y), whichever deviates most. Without a length, as for white "
      "noise, the row is left out. The row 'all' gives the overall result.");
  Options options;
  options.declare(tool);
  tool.table();
  tool.threads();
  document(tool);

  return tool.run(argc, argv, [&] { return validate(tool, options); });
}
