// Parameters of a surface with their standard errors.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>

#include "stats/measure/instrument_noise.hpp"
#include "stats/measure/pooled_maps.hpp"
#include "tools/cli/ensemble_table.hpp"
#include "tools/measure/height_tables.hpp"
#include "tools/measure/stats_options.hpp"

using namespace asperity;

namespace {

// Of one surface.
struct Measured {
  Parameters rows;
  Grid grid = {};
  double area = 0;
  std::optional<EffectiveSampleSize> size = {};  ///< none of a flat one
  std::optional<MapSums> sums = {};              ///< of one of several, that is not flat
  std::vector<MaterialHeight> heights = {};
  double noise = 0;                      ///< that was taken off some rows; none: 0
  Field points = {};                     ///< of one of two that are compared
  std::string units = {};                ///< of these
  std::string missing = {}, doubt = {};  ///< why it has no hybrid parameters; what they are doubted for
};

// Warnings that are given once for all surfaces.
struct Warnings {
  std::optional<EffectiveSampleSize> fewest = {};  ///< of the surface with the fewest independent heights
  std::set<std::string> missing = {};
  std::string doubt = {};  ///< of the first surface that has one

  void add(const Measured& one) {
    if (!one.missing.empty()) missing.insert(one.missing);
    if (doubt.empty()) doubt = one.doubt;
    if (one.size && (!fewest || one.size->effective(2) < fewest->effective(2))) fewest = one.size;
  }
  void print(const cli::Tool& tool) const {
    for (const std::string& group : missing) tool.warn(group);
    if (!doubt.empty()) tool.warn(doubt);
    if (fewest) warn_of_few(tool, *fewest);
  }
};

// The groups asked for; whether there are directions depends on errors.
Measured measured(const cli::Tool& tool, const std::string& variable, const MeasureOptions& asked,
                  Sample& sample, bool errors) {
  Measured out{.rows = {},
               .grid = sample.grid(),
               .area = measured_area(sample.surface().heights, sample.grid()),
               .size = sample.size()};
  for (const Group group : asked.groups) {
    sample.need_errors(errors || group == Group::spatial);
    const Parameters rows = measure(sample, group, asked);
    if (group == Group::hybrid || group == Group::feature) {
      if (const std::string why = missing(rows); !why.empty()) {
        // The other groups are still printed.
        if (asked.groups.size() == 1) throw DataError(variable, why);
        out.missing += (out.missing.empty() ? variable + ": " : "; ") +
                       (group == Group::hybrid ? "no hybrid" : "no feature") + " parameters: " + why;
      }
    }
    if (group == Group::hybrid) {
      if (const std::string doubt = doubt_of_steps(sample); !doubt.empty())
        out.doubt = variable + ": " + doubt;
    }
    if (group == Group::spatial) warn_of_decays(tool, rows, asked.sal_level, sample.grid());
    out.rows.insert(out.rows.end(), rows.begin(), rows.end());
  }
  return out;
}

void drop_errors(Parameters& all) {
  for (Parameter& p : all) {
    p.standard_error = NAN, p.interval.reset();
    if (std::isfinite(p.value)) p.why.clear();  // else why there is no value
  }
}

Measured measured(const cli::Tool& tool, const cli::StatsOptions& options, MeasureOptions asked,
                  const cli::EnsembleMember& member) {
  const cli::FieldOptions& field = options.field;
  if (member.alone()) tool.detail(member.name);
  if (const auto part = cli::counted_cells(member.data, field.variable)) tool.note(part->words_for_all());
  Surface surface = field.read_flat(tool, member.data);
  asked.material_heights = options.heights_in(surface.units);
  if (surface.flat) {
    if (!options.noise.empty()) throw DataError(surface.variable, "is flat: --noise takes nothing off it");
    Measured out{.rows = {}, .grid = surface.grid, .area = measured_area(surface.heights, surface.grid)};
    for (const Group group : asked.groups)
      for (Parameter& row : measure_flat(surface, group, asked)) out.rows.push_back(std::move(row));
    return out;
  }
  Sample sample(std::move(surface), tool.thread_count());
  Measured out = measured(tool, field.variable, asked, sample, options.errors != "none");
  if (options.errors == "none") drop_errors(out.rows);
  if (!member.alone() && !options.compare) out.sums = map_sums(sample, out.rows, asked);
  out.heights = asked.material_heights;
  if (options.compare && member.of == 2)
    out.points = sample.surface().heights, out.units = sample.surface().units;
  if (options.noise.empty()) return out;
  out.noise = cli::parse_quantity("noise", options.noise, sample.surface().units);
  check_noise(out.noise, sample);
  const Parameters freed = without_noise(out.rows, out.noise, out.grid, asked.direction);
  out.rows.insert(out.rows.end(), freed.begin(), freed.end());
  return out;
}

// Pooled, where no surface is flat.
class Mean {
 public:
  /// By their areas, or else alike.
  Mean(const MeasureOptions& asked, bool by_area) : asked_(asked), by_area_(by_area) {}
  void add(const Measured& one) {
    const double weight = weights_.of(by_area_ ? one.area : 1, !one.size || one.size->gives_errors());
    if (weights_.maps() == 1) first_ = one.grid;
    one_spacing_ &= same_spacing(first_, one.grid);
    means_.add(one.rows, weight);
    if (one.sums) pool_.add(*one.sums, weight);
    heights_ = one.heights, noise_ = one.noise;
  }
  const EnsembleParameters& of_estimates() const { return means_; }
  const AreaWeights& weights() const { return weights_; }
  std::vector<EnsembleParameter> pooled() const {
    std::vector<EnsembleParameter> out = means_.all();
    if (pool_.maps() < means_.surfaces()) {
      if (one_spacing_) return out;
      throw DataError(
          "heights",
          "a surface is flat, and the spacings differ: nothing is pooled; measure them separately");
    }
    const auto of_acf = [&](const LagField& rho, const Grid& grid) {
      return lobe_lengths(rho, grid, asked_.sal_level);
    };
    Parameters pooled = pool_.all({asked_.quantiles, asked_.material_ratios, heights_, of_acf});
    if (noise_ > 0)
      std::ranges::copy(without_noise(pooled, noise_, pool_.grid(), asked_.direction),
                        std::back_inserter(pooled));
    take_pooled(out, pooled, pool_);
    for (EnsembleParameter& p : out) judge_error(p);
    return out;
  }

 private:
  // Where one has half of the area, the others tell little of its error: not below theory's then.
  void judge_error(EnsembleParameter& p) const {
    const double of_theory = p.expected_spread / std::sqrt(p.surfaces);
    if (!weights_.give_errors()) p.standard_error = unknown;
    if (weights_.most() > 0.5 && weights_.differ() && of_theory > p.standard_error)
      p.standard_error = of_theory;
  }

  const MeasureOptions& asked_;
  std::vector<MaterialHeight> heights_ = {};
  bool by_area_;
  AreaWeights weights_ = {};
  Grid first_ = {};
  bool one_spacing_ = true;
  EnsembleParameters means_ = {};
  PooledMaps pool_ = {};
  double noise_ = 0;
};

constexpr const char* of_spacings =
    "heights and correlations are pooled, each surface by its measured area, correlations at the coarsest "
    "spacing and the lags that all have; slopes, summits, features and extremes depend on the spacing and "
    "have no value";

// Whether some of it is pooled of any spacings.
bool pools(const MeasureOptions& asked) {
  return std::ranges::any_of(asked.groups, [](Group group) {
    return group == Group::height || group == Group::material || group == Group::quantiles ||
           group == Group::spatial;
  });
}

// Of two maps of one place.
void tell_noise(const cli::Tool& tool, const Field& first, const Field& other, const std::string& units) {
  if (first.size() == 0 || first.rows() != other.rows() || first.cols() != other.cols()) return;
  if (const auto noise = noise_of_repeated(first, other))
    tool.note("as maps of one place they have a noise of " + cli::figure(*noise, units) +
              " each, the rms of their difference over the root of 2: --noise takes it off");
}

int print_parameters(const cli::Tool& tool, cli::EnsembleInput& surfaces, const cli::StatsOptions& options) {
  const MeasureOptions asked = options.checked(tool);
  if (options.compare && surfaces.resolve(tool) == 1)
    throw cli::UsageError("compare", "needs two surfaces or more, and there is one");
  Mean mean(asked, !options.compare);
  std::optional<Parameters> first;
  Field first_points;
  Parameters last;
  Warnings warnings;
  surfaces.for_each(
      tool, [&](const cli::EnsembleMember& member) { return measured(tool, options, asked, member); },
      [&](Measured&& one, const std::string&) {
        warnings.add(one);
        if (options.compare && !first) {
          first = std::move(one.rows), first_points = std::move(one.points);
          return;
        }
        tell_noise(tool, first_points, one.points, one.units);
        mean.add(one);
        last = std::move(one.rows);
      },
      {.variable = options.field.variable,
       .of_sizes = options.compare ? cli::Several().of_sizes
                                   : "each surface counts by its measured area; extremes depend on the size",
       .of_spacings = options.compare || !pools(asked) ? "" : of_spacings});
  warnings.print(tool);
  const int surfaces_in_mean = mean.of_estimates().surfaces();
  if (first)
    cli::print(tool, cli::comparison_table(compared(*first, mean.of_estimates(), last)));
  else if (surfaces_in_mean == 1)
    cli::print(tool, last);
  else {
    const std::vector<EnsembleParameter> pooled = mean.pooled();
    cli::warn_of_lays(tool, pooled);
    cli::tell_weights(tool, mean.weights());
    cli::tell_interval(tool, surfaces_in_mean, PooledMaps::most_degrees);
    cli::print(tool, cli::ensemble_table(pooled));
  }
  return cli::done;
}

void document(cli::Tool& tool) {
  tool.essential({"--parameters", "--profile", "--quantiles", "--material-ratio", "--sal-level",
                  "--direction", "--compare", "--variable", "--remove-form", "--lambda-s", "--lambda-c",
                  "--json", "--output"});
  tool.example("asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-stats");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-stats",
      "Measures surface parameters (ISO 25178-2) with standard errors that allow for the correlation of "
      "neighbouring heights. Kurtosis is 3 for a Gaussian; moments are population moments of the whole "
      "field. For several surfaces it prints the pooled value of each parameter, of all their heights, "
      "slopes "
      "and correlations together, its standard error, the spread between the surfaces, and the spread "
      "expected from their errors. A 95 % interval is Student's t of surfaces - 1 degrees of freedom, 39 at "
      "most, times the standard error on either side. Sal, Str and the slowest decay keep a bias then, and "
      "have no error. Surfaces of different sizes count by their measured areas. Of different spacings "
      "heights, the material ratio and correlations are pooled, these at the coarsest; slopes, summits, "
      "features and "
      "extremes, which depend on the spacing, have no value then. With --compare it says in which parameters "
      "the first surface differs from the others.");
  cli::EnsembleInput surfaces;
  cli::StatsOptions options;
  surfaces.declare(tool);
  options.declare(tool);
  tool.table();
  tool.threads();
  document(tool);

  return tool.run(argc, argv, [&] { return print_parameters(tool, surfaces, options); });
}
