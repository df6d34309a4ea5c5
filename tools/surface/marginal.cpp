#include "tools/surface/marginal.hpp"

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "marginal/johnson.hpp"
#include "tools/cli/plain_text.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/table.hpp"

namespace asperity::cli {
namespace {

constexpr const char* kernel_quantiles = "kernel_quantiles";

MeasuredHeights quantiles_of(const Variable& variable) {
  const std::vector<double> values = numbers(variable.values);
  const double highest = variable.attributes.number("highest_score", NAN);
  if (values.size() != 2 * MeasuredHeights::half + 1 || !(highest > 0 && highest < 40))
    throw DataError(variable.name, "is not a table of quantiles at normal scores");
  MeasuredHeights out{highest / static_cast<double>(MeasuredHeights::half),
                      Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Index>(values.size()))};
  for (Index j = 1; j < out.quantiles.size(); ++j)
    if (!(out.quantiles(j) >= out.quantiles(j - 1)))
      throw DataError(variable.name, "its heights do not increase");
  const HeightMoments moments = height_moments(out.translation());
  if (!(std::abs(moments.mean) <= 1e-6 && std::abs(moments.variance - 1) <= 1e-6))
    throw DataError(variable.name, "its mean is not 0 or its variance not 1");
  return out;
}

// The value of a quantity in a table of asperity-stats, text or JSON; NAN where there is none.
double quantity_in(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with('{')) {
    const auto table = nlohmann::json::parse(bytes, nullptr, false);
    const auto row = table.is_object() ? table.find(name) : table.end();
    if (table.is_discarded() || row == table.end() || !row->contains("value")) return NAN;
    return (*row)["value"].is_number() ? (*row)["value"].get<double>() : NAN;
  }
  for (std::size_t line = 1; !bytes.empty(); ++line) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const auto words = words_of(bytes.substr(0, end));
    if (words.size() > 1 && words[0] == name) return number_of(words[1], line, "marginal");
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  return NAN;
}

std::optional<HeightMoments> moments_in(std::string_view bytes) {
  constexpr std::size_t largest_table = 1 << 20;  // bytes, of asperity-stats: some kB as a rule
  if (looks_like_netcdf(bytes) || bytes.size() > largest_table) return std::nullopt;
  const HeightMoments found{0, 1, quantity_in(bytes, "Ssk"), quantity_in(bytes, "Sku")};
  if (std::isnan(found.skewness) || std::isnan(found.kurtosis)) return std::nullopt;
  return found;
}

// The heights of a dataset or a map that are there, of a text too.
std::vector<double> heights_in(std::string_view bytes, const std::string& name,
                               const MemoryBound& memory) try {
  const InputFormat any;
  const Field field = any.netcdf(bytes)
                          ? field_of(any.dataset(bytes, name, memory), "heights", Missing::not_a_number)
                          : any.map(bytes, name, memory).values;
  std::vector<double> out(field.data(), field.data() + field.size());
  std::erase_if(out, [](double z) { return std::isnan(z); });
  return out;
} catch (const DataError& error) {
  throw DataError("marginal", error.name == "map" ? error.what() : error.name + ": " + error.what());
}

// Johnson's; none where they are Gaussian.
std::optional<Marginal> johnson(const Tool& tool, const PrescribedHeights& prescribed) {
  Translation translation = prescribed.translation();
  if (translation.family == "normal") return std::nullopt;
  const double kurtosis = prescribed.feasible().kurtosis;
  warn_of_kurtosis(tool, prescribed, kurtosis);
  return Marginal{std::move(translation), prescribed.skewness, kurtosis};
}

}  // namespace

Marginal Marginal::of(MeasuredHeights measured) {
  Translation translation = measured.translation();
  const HeightMoments moments = height_moments(translation);
  return {std::move(translation), moments.skewness, moments.kurtosis, std::move(measured)};
}

void set_quantiles(Dataset& data, const std::string& name, const MeasuredHeights& measured) {
  const Eigen::ArrayXd& q = measured.quantiles;
  data.set_dimension("normal_score", q.size());
  Variable variable{name, {"normal_score"}, std::vector<double>(q.begin(), q.end()), {}};
  variable.attributes.set("units", "1");
  variable.attributes.set("long_name", "heights over their rms at evenly spaced normal scores");
  variable.attributes.set("highest_score", measured.step * static_cast<double>(MeasuredHeights::half));
  variable.attributes.set_values("actual_range", Values(std::vector<double>{q(0), q(q.size() - 1)}));
  data.put(std::move(variable));
}

void set_marginal(Dataset& data, const Marginal& marginal) {
  data.attributes.set("kernel_heights", marginal.translation.family);
  data.attributes.set("kernel_skewness", marginal.skewness);
  data.attributes.set("kernel_kurtosis", marginal.kurtosis);
  if (marginal.measured) set_quantiles(data, kernel_quantiles, *marginal.measured);
}

std::optional<Marginal> marginal_of(const Dataset& data) {
  const std::string family = data.attributes.text("kernel_heights");
  if (family.empty()) return std::nullopt;
  if (family == "measured") return Marginal::of(quantiles_of(data.at(kernel_quantiles)));
  const double skewness = data.attributes.number("kernel_skewness", NAN),
               kurtosis = data.attributes.number("kernel_kurtosis", NAN);
  try {
    return Marginal{johnson_translation(skewness, kurtosis), skewness, kurtosis};
  } catch (const ParameterError& error) {
    throw DataError("kernel_heights", error.name + " " + error.what());
  }
}

HeightsWithAcf measured_with_acf(const Dataset& data) {
  HeightsWithAcf out{data.attributes.number("acf_skewness", NAN),
                     data.attributes.number("acf_kurtosis", NAN)};
  if (const Variable* quantiles = data.find("acf_quantiles")) out.measured = quantiles_of(*quantiles);
  out.gaussian = data.attributes.text("acf_marginal") != "measured" || !out.measured;
  return out;
}

// ---- the options ----

void MarginalOptions::declare(Tool& tool) {
  const std::string group = "Heights";
  tool.number("--skewness", skewness, "Skewness of the heights; negative for deep valleys", group);
  tool.number(
      "--kurtosis", kurtosis,
      "Kurtosis of the heights; 3 for a Gaussian, above SKEWNESS^2 + 1. Default: 3 + 1.5 SKEWNESS^2, of the "
      "gamma family. Far below that the distribution is J-shaped or has two peaks, and a warning says so",
      group);
  tool.text(
      "--marginal", marginal, "NAME|FILE",
      "Distribution of the heights; gaussian; johnson: by --skewness and --kurtosis, or by those in --acf; "
      "measured: by the quantiles in --acf (asperity-acf --add acf_quantiles); FILE: by the heights of a "
      "dataset or a text, or by Ssk and Sku of a table of asperity-stats. Default: gaussian; of a table by "
      "asperity-acf --taper measured, where Ssk or Sku is 4 standard errors from a Gaussian's",
      group);
}

std::string MarginalOptions::given(const Tool& tool) {
  for (const char* option : {"skewness", "kurtosis", "marginal"})
    if (tool.given(std::string("--") + option)) return option;
  return {};
}

bool MarginalOptions::chosen_by_moments(const Tool& tool) const {
  const bool given = tool.given("--skewness") || tool.given("--kurtosis");
  if (given && tool.given("--marginal") && marginal != "johnson")
    throw UsageError(tool.given("--skewness") ? "skewness" : "kurtosis",
                     "cannot be combined with --marginal " + marginal);
  return given;
}

std::optional<PrescribedHeights> MarginalOptions::moments(const Tool& tool, const HeightsWithAcf& table,
                                                          InfeasiblePolicy answer) const {
  if (chosen_by_moments(tool))
    return PrescribedHeights{skewness, tool.given("--kurtosis") ? kurtosis : gamma_kurtosis(skewness),
                             answer};
  if (marginal == "gaussian" || marginal.empty()) return std::nullopt;
  if (marginal != "johnson")
    throw UsageError("marginal", marginal + ": --method filter needs --skewness and --kurtosis");
  if (std::isnan(table.skewness) || std::isnan(table.kurtosis))
    throw UsageError("marginal", "johnson: needs --skewness and --kurtosis, or --acf from asperity-acf");
  return PrescribedHeights{table.skewness, table.kurtosis, answer};
}

std::optional<Marginal> MarginalOptions::wanted(const Tool& tool, const HeightsWithAcf& table,
                                                InfeasiblePolicy answer) const {
  const bool unsaid = marginal.empty() && table.gaussian;
  if (chosen_by_moments(tool) || unsaid || marginal == "gaussian" || marginal == "johnson") {
    const auto prescribed = moments(tool, table, answer);
    return prescribed ? johnson(tool, *prescribed) : std::nullopt;
  }
  if (marginal == "measured" || marginal.empty()) {
    if (!table.measured)
      throw UsageError("marginal",
                       "measured: needs the distribution of 100 heights or more: of --like, or in --acf from "
                       "asperity-acf --taper or --add acf_quantiles");
    return Marginal::of(*table.measured);
  }
  if (marginal == "-" && stdin_is_terminal())
    throw UsageError("marginal", "no input: pipe heights in or name a file");
  tool.reads(marginal);
  const Bytes bytes = read_all(marginal, tool.memory_bound());
  if (const auto found = moments_in(bytes)) return johnson(tool, {found->skewness, found->kurtosis, answer});
  return Marginal::of(MeasuredHeights::of(heights_in(bytes, marginal, tool.memory_bound())));
}

void warn_of_kurtosis(const Tool& tool, const PrescribedHeights& prescribed, double kurtosis) {
  if (std::abs(kurtosis - prescribed.kurtosis) > 1e-6 * kurtosis)
    tool.warn("at skewness " + shortest(prescribed.skewness) + " this method cannot give the kurtosis " +
              shortest(prescribed.kurtosis) + "; using the least possible, " + number(kurtosis));
}

}  // namespace asperity::cli
