// What a tool is and takes, as JSON for programs that call it.
#include <array>
#include <string_view>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "dataset/catalogue.hpp"
#include "tools/cli/documents.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/toolbox.hpp"

namespace asperity::cli {
namespace {

using Json = nlohmann::ordered_json;

// The SI unit of a number of this kind, of an option whose own text parses it; "" where none is fixed.
std::string unit_of_kind(const std::string& kind) {
  constexpr std::pair<std::string_view, const char*> units[] = {
      {"LENGTH", "m"},  {"WIDTH", "m"},   {"RADIUS", "m"}, {"DEPTH", "m"},
      {"ANGLE", "rad"}, {"STRESS", "Pa"}, {"LOADS", "N"},  {"SIZE", "B"}};
  for (const auto& [begin, unit] : units)
    if (kind.starts_with(begin)) return unit;
  return "";
}

std::string word_of(Value value) {
  constexpr std::array words = {"flag", "file", "word", "other"};  // as in Value
  return words[static_cast<std::size_t>(value)];
}

std::string word_of(Role role) {
  constexpr std::array words = {"parameter", "result", "achieved", "other"};  // as in Role
  return words[static_cast<std::size_t>(role)];
}

Json all_of(const std::set<CLI::Option*>& options) {
  std::set<std::string> names;  // in an order that is no address's
  for (const CLI::Option* option : options) names.insert(option->get_single_name());
  return names;
}

// It prints a text in place of running. Neither it nor a step, which may come again, stands in a file.
bool prints(const CLI::App& app, const CLI::Option& option) {
  return !option.get_positional() && !option.get_configurable() && &option != app.get_config_ptr() &&
         option.get_items_expected_max() <= 1;
}

Json entry(const CLI::App& app, const CLI::Option& option, const Documents& more) {
  const std::string name = option.get_single_name(), kind = option.get_type_name();
  const auto unit = more.units.find(name);
  return {{"name", name},
          {"names", names_of(option)},
          {"heading", option.get_group() == "Options" ? "Arguments" : option.get_group()},
          {"kind", is_flag(option) ? "" : kind_of(option)},
          {"value", word_of(value_of(option))},
          {"unit", unit == more.units.end() ? unit_of_kind(kind) : unit->second},
          {"words", value_of(option) == Value::word ? Json(words_of(option)) : Json::array()},
          {"text", text_of(option)},
          {"required", option.get_required()},
          {"repeated", option.get_items_expected_max() > 1},
          {"prints", prints(app, option)},
          {"excludes", all_of(option.get_excludes())}};
}

// The attributes that it leaves in a dataset, by the catalogue: those with its prefix.
Json results_of(const std::string& tool) {
  const std::string prefix = tool.substr(tool.find('-') + 1) + "_";
  Json out = Json::array();
  for (const KnownAttribute& known : known_attributes())
    if (known.name.starts_with(prefix))
      out.push_back(
          {{"name", known.name}, {"role", word_of(known.role)}, {"unit", known.unit}, {"text", known.label}});
  return out;
}

// Paragraphs with an empty line between them, items under each other.
std::string plain_text(const std::vector<Paragraph>& paragraphs) {
  std::string out;
  bool before = true;
  for (const auto& [item, text] : paragraphs) {
    out += (out.empty() ? "" : item && before ? "\n" : "\n\n") + (item ? "* " + text : text);
    before = item;
  }
  return out;
}

}  // namespace

std::string description(const CLI::App& app, const Documents& more) {
  const std::string name = app.get_name();
  Json out = {{"tool", name},
              {"version", version()},
              {"summary", std::string(summary_of(name))},
              {"description", flowing(app.get_description())},
              {"example", more.example},
              {"accuracy", plain_text(accuracy_of(name))},
              {"options", Json::array()},
              {"results", results_of(name)},
              {"statuses", Json::array()}};
  for (const CLI::Option* option : app.get_options()) out["options"].push_back(entry(app, *option, more));
  for (const auto& [code, meaning] : more.statuses)
    out["statuses"].push_back({{"status", code}, {"meaning", meaning}});
  return out.dump(1) + "\n";
}

}  // namespace asperity::cli
