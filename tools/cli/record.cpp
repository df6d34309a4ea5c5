#include "cli/record.hpp"

#include <cmath>
#include <cstdlib>
#include <ctime>

#include <gsl/gsl_version.h>
#include <nlohmann/json.hpp>

#include "acf/nonlinear_system.hpp"
#include "dataset/netcdf.hpp"
#include "transform/plan.hpp"

namespace asperity::cli {
namespace {

using Json = nlohmann::ordered_json;

// One number or a list, whole numbers as such; JSON has no word for what is not finite.
Json json_of(const Values& values) {
  if (const auto* text = std::get_if<std::string>(&values)) return *text;
  return std::visit(
      [](const auto& list) {
        Json out = Json::array();
        for (auto v : list) out.push_back(std::isfinite(static_cast<double>(v)) ? Json(v) : Json(nullptr));
        return out.size() == 1 ? out[0] : out;
      },
      values);
}

}  // namespace

std::string libraries() {
  return sundials_version() + ", GSL " GSL_VERSION ", " + transform_version() + ", " + netcdf_version();
}

std::string version() { return ASPERITY_VERSION; }

std::string source() { return "Asperity " + version() + " (" + libraries() + ")"; }

std::string quoted(const std::string& argument) {
  const bool plain = !argument.empty() && argument.find_first_not_of(
                                              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                              "0123456789-_=+./,:@%") == std::string::npos;
  if (plain) return argument;
  std::string out = "'";
  for (char c : argument) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string timestamp() {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t now =
      epoch ? static_cast<std::time_t>(std::strtoll(epoch, nullptr, 10)) : std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32] = {};
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

double on_record(double seconds) { return std::getenv("SOURCE_DATE_EPOCH") ? 0 : seconds; }

std::string report_of(const Dataset& dataset, const std::string& prefix) {
  Json object = Json::object();
  for (const Attribute& attribute : dataset.attributes)
    if (attribute.name.starts_with(prefix)) object[attribute.name] = json_of(attribute.values);
  return object.dump(2) + "\n";
}

}  // namespace asperity::cli
