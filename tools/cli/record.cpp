#include "tools/cli/record.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <sys/resource.h>

#include <fmt/format.h>
#include <gsl/gsl_version.h>
#include <nlohmann/json.hpp>

#include "acf/kernel.hpp"
#include "core/error.hpp"
#include "core/os.hpp"
#include "core/words.hpp"
#include "dataset/netcdf.hpp"
#include "tools/cli/quantity.hpp"
#include "transform/plan.hpp"

namespace asperity::cli {
namespace {

using Json = nlohmann::ordered_json;

// One number or a list, whole numbers as such; JSON has no word for what is not finite.
Json json_of(const Values& values) {
  if (const auto* text = std::get_if<std::string>(&values)) return utf8_of(*text);
  return std::visit(
      [](const auto& list) {
        Json out = Json::array();
        for (auto v : list) out.push_back(std::isfinite(static_cast<double>(v)) ? Json(v) : Json(nullptr));
        return out.size() == 1 ? out[0] : out;
      },
      values);
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

}  // namespace

std::string libraries() {
  return sundials_version() + ", GSL " GSL_VERSION ", " + transform_version() + ", " + netcdf_version();
}

std::string version() { return ASPERITY_VERSION; }

std::string source() { return "Asperity " + version() + " (" + libraries() + ")"; }

std::string shell_word(const std::string& argument) {
  const bool plain = !argument.empty() && argument.find_first_not_of(
                                              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                              "0123456789-_=+./,:@%") == std::string::npos;
  if (plain) return argument;
  std::string out = "'";
  for (char c : argument) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::optional<std::time_t> source_date() {
  constexpr std::time_t latest = 253402300799;
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  if (epoch == nullptr) return std::nullopt;
  const std::string_view text = epoch;
  const auto out = to_number<std::time_t>(text);
  if (!out || *out < 0 || *out > latest)
    throw ParameterError("SOURCE_DATE_EPOCH",
                         "\"" + one_line(text, 64) +
                             "\" is not a whole number of seconds from 0, the year 1970, to " +
                             std::to_string(latest) + ", the end of 9999; correct it or unset it");
  return out;
}

std::string timestamp() {
  const std::time_t now = source_date().value_or(std::time(nullptr));
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32] = {};
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

double on_record(double seconds) { return std::getenv("SOURCE_DATE_EPOCH") ? 0 : seconds; }

std::string usage_of_run(double wall_seconds) {
  rusage own{}, children{};
  getrusage(RUSAGE_SELF, &own);
  getrusage(RUSAGE_CHILDREN, &children);
  const double user = seconds(own.ru_utime) + seconds(children.ru_utime);
  const double system = seconds(own.ru_stime) + seconds(children.ru_stime);
  const long told = os::peak_kibibytes(), peak = told > 0 ? told : own.ru_maxrss;
  const auto kibibytes = static_cast<std::size_t>(std::max(peak, children.ru_maxrss));
  return fmt::format("{:.3g} s, CPU {:.3g} s ({:.3g} s user, {:.3g} s system), peak memory {}", wall_seconds,
                     user + system, user, system, format_bytes(1024 * kibibytes));
}

std::string report_of(const Dataset& dataset, const std::string& prefix) {
  Json object = Json::object();
  for (const Attribute& attribute : dataset.attributes)
    if (attribute.name.starts_with(prefix)) object[utf8_of(attribute.name)] = json_of(attribute.values);
  return object.dump(2) + "\n";
}

}  // namespace asperity::cli
