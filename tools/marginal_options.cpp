#include "marginal_options.hpp"

#include "acf/wording.hpp"
#include "cli/stream.hpp"
#include "cli/table.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "grid/error.hpp"
#include "plain_text.hpp"

namespace asperity::cli {
namespace {

// The heights of a dataset that are there, or the numbers of a text.
std::vector<double> heights_in(const std::string& name) {
  const std::string bytes = read_all(name);
  if (!looks_like_netcdf(bytes)) return numbers_in(bytes, "marginal");
  const Field field = field_of(decode_netcdf(bytes), "heights", Missing::not_a_number);
  std::vector<double> out(field.data(), field.data() + field.size());
  std::erase_if(out, [](double z) { return std::isnan(z); });
  return out;
}

}  // namespace

void MarginalOptions::declare(Tool& tool) {
  const std::string group = "Heights";
  tool.number("--skewness", skewness, "Skewness of the heights; negative where valleys are deep", group);
  tool.number("--kurtosis", kurtosis, "Kurtosis of the heights, 3 for a Gaussian, above SKEWNESS^2 + 1",
              group);
  tool.text(
      "--marginal", marginal, "NAME|FILE",
      "Their distribution: gaussian; johnson, which --skewness and --kurtosis choose and which alone takes "
      "those that asperity-acf found with --acf; measured, the quantiles of --acf by asperity-acf "
      "--quantiles; "
      "or that of the heights in a dataset or a text FILE",
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
                     "does not go together with --marginal " + marginal);
  return given;
}

std::optional<PrescribedHeights> MarginalOptions::moments(const Tool& tool, const HeightsWithAcf& table,
                                                          Infeasible answer) const {
  if (chosen_by_moments(tool)) return PrescribedHeights{skewness, kurtosis, answer};
  if (marginal == "gaussian") return std::nullopt;
  if (marginal != "johnson")
    throw UsageError("marginal",
                     marginal + ": --method filter takes moments alone, --skewness and --kurtosis");
  if (std::isnan(table.skewness) || std::isnan(table.kurtosis))
    throw UsageError("marginal", "johnson: takes --skewness and --kurtosis, or --acf from asperity-acf");
  return PrescribedHeights{table.skewness, table.kurtosis, answer};
}

std::optional<Marginal> MarginalOptions::wanted(const Tool& tool, const HeightsWithAcf& table,
                                                Infeasible answer) const {
  if (chosen_by_moments(tool) || marginal == "gaussian" || marginal == "johnson") {
    const auto prescribed = moments(tool, table, answer);
    if (!prescribed) return std::nullopt;
    Translation translation = prescribed->translation();
    if (translation.family == "normal") return std::nullopt;
    const double kurtosis_had = prescribed->feasible().kurtosis;
    tell_kurtosis(tool, *prescribed, kurtosis_had);
    return Marginal{std::move(translation), prescribed->skewness, kurtosis_had};
  }
  if (marginal == "measured") {
    if (!table.measured) throw UsageError("marginal", "measured: takes --acf from asperity-acf --quantiles");
    return Marginal::of(*table.measured);
  }
  if (marginal == "-" && stdin_is_terminal())
    throw UsageError("marginal", "no input: pipe heights in or name a file");
  return Marginal::of(MeasuredHeights::of(heights_in(marginal)));
}

void tell_kurtosis(const Tool& tool, const PrescribedHeights& prescribed, double kurtosis) {
  if (std::abs(kurtosis - prescribed.kurtosis) > 1e-6 * kurtosis)
    tool.warn("no heights of skewness " + shortest(prescribed.skewness) + " have the kurtosis " +
              shortest(prescribed.kurtosis) + " in this way; " + number(kurtosis) + " takes its place");
}

}  // namespace asperity::cli
