/// Whether the errors printed beside parameters are those that simulation finds, whatever the texture.
///
///     error_coverage [FIELDS [TEXTURE|translated|made|all [SHAPE [LENGTH [DEGREE [OUTLINE [SEED]]]]]]]
///
/// FIELDS (400) fields of each texture (textures.hpp: translated; made_textures.hpp: made) on SHAPE (128x128) points with correlation LENGTH (4, in
/// samples), a form of DEGREE (0: the mean) removed. The correlation is estimated from each field. Errors of
/// parameters are those of asperity-stats. OUTLINE is one of outlines.hpp, SEED (2026) that of the fields.
///
/// First table, one row a parameter and texture:
///
/// texture       of the fields
/// N_eff         of their true correlation
/// parameter     all of asperity-stats with an error, correlation lengths, densities at -1, 0 and 1 µm,
///               shares of half a µm (1 µm: Sq of Gaussian ones), some points of spectra
/// known         share of the fields that have an error, per cent
/// covered       share of these whose 95 % interval holds the truth, per cent; of the intervals
/// open          share without an upper end, per cent
/// ratio         rms of the stated errors over the true one, the standard deviation of the values with errors
/// bias          mean of the values less the truth, in true errors
///
/// Second table, one row a parameter: of the textures that have an error in more than half of the fields
/// (`textures`, `of` how many), the least and the greatest `covered` and `ratio`.
///
/// Third table, of the textures of N_eff 60 and more: how many `figures`, rows of the first table, have an error
/// in more than half of the fields, and the shares of these, in per cent, that are covered `below_90`, and whose
/// ratio is `below_0.8` and `above_1.3`.
///
/// The truth is the mean over eight fields of four times the sides, of effective sample sizes that of the
/// true correlation, and of spectra its transform; of what depends on the size (extremes, counts, profiles),
/// and of sizes and spectra of textures.hpp's made ones, the mean of the values. Spectra are measured on rectangles only.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "made_textures.hpp"
#include "outlines.hpp"
#include "spectrum_points.hpp"
#include "stats/height/distribution.hpp"
#include "stats/height/kernel_density.hpp"
#include "stats/measure.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "textures.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr double micrometre = 1e-6;
constexpr int large = 4, large_fields = 8;

struct Setting {
  int fields = 400;
  Shape shape{128, 128};
  double length = 4;
  int degree = 0;
  std::string outline = "rectangle";
  unsigned seed = 2026;

  // Beyond which no texture is correlated.
  Index reach() const { return static_cast<Index>(40 * length); }
};

Grid grid_of(Shape shape) { return {shape, micrometre, micrometre, false}; }

// Densities and shares of heights in units of 1 µm, the Sq of a Gaussian field.
void add_distribution(Parameters& out, const Sample& sample) {
  constexpr double bandwidth = 0.2 * micrometre, end = 20 * micrometre;
  const Field& z = sample.surface().heights;
  const double sq = sample.moments().sq;
  auto add = [&](std::string name, const Frequency& of) {
    out.push_back({std::move(name), of.value, "", of.error, "", of.interval});
  };
  std::vector<DensityPoint> curve =
      kernel_density(z, bandwidth, 41, HeightRange{3 * bandwidth - end, end - 3 * bandwidth});
  set_errors(curve, z, sample.grid(), sample.extent(), bandwidth, sq);
  for (const int k : {-1, 0, 1})
    add(fmt::format("density_{}", k), curve[static_cast<std::size_t>(20 + k)].frequency);
  std::vector<Bin> bins = histogram(z, 80, HeightRange{-end, end});
  set_errors(bins, z, sample.grid(), sample.extent(), sq);
  for (const double from : {-2.5, -1.0, 0.5, 2.0})
    add(fmt::format("share_{}", from), bins[static_cast<std::size_t>(40 + 2 * from)].share);
}

// All that has an error; the truth of spectra is not measured.
Parameters measured(const Field& heights, int degree, bool spectra) {
  const Grid grid = grid_of(shape_of(heights));
  MeasureOptions options;
  options.groups = {Group::height,  Group::quantiles, Group::material, Group::hybrid,
                    Group::spatial, Group::profiles,  Group::feature};
  options.quantiles = {0.02, 0.5, 0.9};
  options.material_heights = {{-micrometre, "-1um"}, {0.5 * micrometre, "0.5um"}, {2 * micrometre, "2um"}};
  options.pruning = {0.3 * micrometre, false};
  const Surface surface = prepared({grid, micrometre * heights}, {.form = {.degree = degree}});
  const Sample sample(surface);
  Parameters out;
  for (const Group group : options.groups)
    std::ranges::copy(measure(sample, group, options), std::back_inserter(out));
  add_distribution(out, sample);
  const AcfEstimate acf = AcfEstimate::of(surface, {.max_lag = default_max_lag(grid)});
  const LengthErrors lengths(acf, surface.heights, 0.1);
  std::ranges::copy(acf_lengths(acf, {{1 / std::exp(1.0), "e", ""}, {0.1, "10", ""}}, {}, {}, lengths),
                    std::back_inserter(out));
  const ProfileErrors errors = profile_errors(acf, surface.heights, true, false);
  const LagField structure = structure_function(surface.heights, grid, {16, 0});
  for (const Index lag : {1, 4, 16}) {
    auto add_lag = [&](const char* name, double value, double error, const Interval& interval) {
      out.push_back({fmt::format("{}_x_{}", name, lag), value, "1", error, "", interval});
    };
    const double S = structure(lag, 0);
    add_lag("acf", acf.rho(lag, 0), errors.acf(lag), errors.interval(acf.rho(lag, 0), lag));
    add_lag("structure", S, errors.structure(lag), errors.structure_interval(S, lag));
  }
  if (spectra) std::ranges::copy(spectrum_points(sample), std::back_inserter(out));
  return out;
}

bool depends_on_size(const std::string& name) {
  if (name.starts_with("S")) return name == "Sp" || name == "Sv" || name == "Sz" || name.ends_with("kx");
  return name.starts_with("N") || name.starts_with("P");
}

// Of the first table.
struct Row {
  double known = 0, covered = 0, open = 0, ratio = NAN, bias = NAN;
};

// Of one parameter in all fields.
struct Column {
  std::vector<Parameter> all;
  double truth = NAN;

  bool axial() const { return all[0].unit == "rad"; }
  double mean() const {
    if (!axial()) return mean_of([](const Parameter& p) { return p.value; });
    return 0.5 * std::atan2(mean_of([](const Parameter& p) { return std::sin(2 * p.value); }),
                            mean_of([](const Parameter& p) { return std::cos(2 * p.value); }));
  }
  // From b to a; axes have the period π.
  double difference(double a, double b) const {
    return axial() ? std::remainder(a - b, std::numbers::pi) : a - b;
  }
  double spread() const {
    const double m = mean();
    return std::sqrt(mean_of([&](const Parameter& p) { return std::pow(difference(p.value, m), 2); }));
  }
  Column with_errors() const {
    Column out;
    std::ranges::copy_if(all, std::back_inserter(out.all),
                         [](const Parameter& p) { return std::isfinite(p.standard_error); });
    return out;
  }
  template <class Of>
  double mean_of(Of of) const {
    double sum = 0, count = 0;
    for (const Parameter& p : all)
      if (const double value = of(p); std::isfinite(value)) sum += value, ++count;
    return sum / count;
  }

  Row row() const {
    const bool biased = std::isfinite(truth);
    const double aim = biased ? truth : mean();
    Row out;
    for (const Parameter& p : all) {
      if (!std::isfinite(p.standard_error)) continue;
      const Interval i = p.interval_95();
      const double at = p.value + difference(aim, p.value);
      ++out.known;
      out.covered += i.low <= at && at <= i.high;
      out.open += std::isinf(i.high);
    }
    const double stated =
        std::sqrt(mean_of([](const Parameter& p) { return p.standard_error * p.standard_error; }));
    return {100 * out.known / static_cast<double>(all.size()), 100 * out.covered / out.known,
            100 * out.open / out.known, out.known > 0 ? stated / with_errors().spread() : NAN,
            biased ? difference(mean(), aim) / spread() : NAN};
  }
};

struct Extremes {
  double least = INFINITY, most = -INFINITY;

  void add(double value) { least = std::min(least, value), most = std::max(most, value); }
};

// Of one parameter over the textures.
struct Range {
  int textures = 0, known = 0;
  Extremes covered = {}, ratio = {};

  void add(const Row& row) {
    ++textures;
    if (!(row.known > 50)) return;
    ++known;
    covered.add(row.covered), ratio.add(row.ratio);
  }
  void print(const std::string& name) const {
    fmt::print("{}\t{}\t{}", name, known, textures);
    if (known > 0)
      fmt::print("\t{:.0f}\t{:.0f}\t{:.2f}\t{:.2f}\n", covered.least, covered.most, ratio.least, ratio.most);
    else
      fmt::print("\t-\t-\t-\t-\n");
  }
};

struct Ranges {
  std::vector<std::string> names = {};
  std::map<std::string, Range> of = {};

  void add(const std::string& name, const Row& row) {
    if (!of.contains(name)) names.push_back(name);
    of[name].add(row);
  }
  void print() const {
    fmt::print("# parameter\ttextures\tof\tleast_covered\tmost_covered\tleast_ratio\tmost_ratio\n");
    for (const std::string& name : names) of.at(name).print(name);
  }
};

// The third table.
struct Tally {
  double figures = 0, uncovered = 0, low = 0, high = 0;

  void add(const Row& row) {
    if (!(row.known > 50)) return;
    ++figures, uncovered += row.covered < 90, low += row.ratio<0.8, high += row.ratio> 1.3;
  }
  void print() const {
    const double share = 100 / std::max(figures, 1.0);
    fmt::print("# figures\tbelow_90\tbelow_0.8\tabove_1.3\n{}\t{:.1f}\t{:.1f}\t{:.1f}\n", figures,
               share * uncovered, share * low, share * high);
  }
};

// The effective sample sizes of the true correlation.
std::map<std::string, double> true_sizes(const textures::Texture& texture, const Setting& setting) {
  const Grid grid = grid_of(setting.shape);
  const LagField rho = textures::correlation_of_heights(texture, longest_lags(grid), setting.reach());
  const EffectiveSampleSize size(rho, Pairs::of(outlines::points(setting.outline, setting.shape), grid));
  return {{"N_eff_mean", size.effective(1)},
          {"N_eff", size.effective(2)},
          {"N_eff_Ssk", size.effective(3)},
          {"N_eff_Sku", size.effective(4)}};
}

void judge(const textures::Texture& texture, const Setting& setting, Ranges& ranges, Tally& tally) {
  const auto [nx, ny] = setting.shape;
  std::mt19937_64 random(setting.seed);
  std::map<std::string, Column> columns;
  std::vector<std::string> names;
  const auto drawn = [&](Shape shape) -> std::function<Field()> {
    if (texture.make) return [&texture, &random, shape] { return texture.make(shape, random); };
    const auto draw = std::make_shared<textures::Draw>(texture, shape, setting.reach());
    return [draw, &random] { return (*draw)(random); };
  };
  const auto draw = drawn(setting.shape);
  const Field points = outlines::points(setting.outline, setting.shape);
  const bool complete = !has_missing(points);
  for (int f = 0; f < setting.fields; ++f)
    for (const Parameter& p : measured(points * draw(), setting.degree, complete)) {
      if (!columns.contains(p.name)) names.push_back(p.name);
      columns[p.name].all.push_back(p);
    }
  const auto wide = drawn({large * nx, large * ny});
  std::map<std::string, Column> truths;
  for (int f = 0; f < large_fields; ++f)
    for (const Parameter& p : measured(wide(), 0, false)) truths[p.name].all.push_back(p);
  std::map<std::string, double> sizes;
  double n_eff = columns["N_eff"].mean();
  if (texture.correlation) {
    for (const Parameter& p : true_spectrum_points(texture, setting.shape, micrometre, setting.reach()))
      truths[p.name].all.push_back(p);
    sizes = true_sizes(texture, setting);
    n_eff = static_cast<double>((!points.isNaN()).count()) /
            textures::correlated_points(texture, setting.reach());
  }
  for (const std::string& name : names) {
    Column& column = columns[name];
    if (sizes.contains(name)) column.truth = sizes.at(name);
    if (!depends_on_size(name) && truths.contains(name)) column.truth = truths[name].mean();
    const Row row = column.row();
    fmt::print("{}\t{:.0f}\t{}\t{:.0f}\t{:.1f}\t{:.1f}\t{:.2f}\t{:.2f}\n", texture.name, n_eff, name,
               row.known, row.covered, row.open, row.ratio, row.bias);
    ranges.add(name, row);
    if (n_eff >= 60) tally.add(row);
  }
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  Setting setting;
  if (argc > 1) setting.fields = std::max(2, std::atoi(argv[1]));
  const std::string only = argc > 2 ? argv[2] : "all";
  if (argc > 3) {
    char* end = nullptr;
    setting.shape.nx = std::strtol(argv[3], &end, 10);
    setting.shape.ny = std::strtol(end + 1, nullptr, 10);
  }
  if (argc > 4) setting.length = std::atof(argv[4]);
  if (argc > 5) setting.degree = std::atoi(argv[5]);
  if (argc > 6) setting.outline = argv[6];
  if (argc > 7) setting.seed = static_cast<unsigned>(std::atoi(argv[7]));
  fmt::print("# texture\tN_eff\tparameter\tknown\tcovered\topen\tratio\tbias\n");
  Ranges ranges;
  Tally tally;
  auto judge_all = [&](const std::vector<textures::Texture>& group, const std::string& name) {
    for (const textures::Texture& texture : group)
      if (only == "all" || only == name || only == texture.name) judge(texture, setting, ranges, tally);
  };
  judge_all(textures::all(setting.length), "translated");
  judge_all(textures::made(setting.length), "made");
  ranges.print();
  tally.print();
}
