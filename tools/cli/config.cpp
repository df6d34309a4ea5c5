// Options in a file, read and printed.
#include <algorithm>
#include <sstream>
#include <toml++/toml.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/words.hpp"
#include "tools/cli/documents.hpp"

namespace asperity::cli {
namespace {

// ---- reading ----

constexpr std::size_t most_bytes = 1 << 20, most_dots = 7;

// All of the file, which may be a device without an end.
std::string text_in(std::istream& in) {
  std::string out(most_bytes + 1, '\0');
  in.read(out.data(), static_cast<std::streamsize>(out.size()));
  out.resize(static_cast<std::size_t>(in.gcount()));
  if (out.size() > most_bytes) throw CLI::ConfigError("it is larger than 1 MiB: not a file of options");
  return out;
}

// The end of the quoted text that begins there; of three quotes it has lines, and ends with up to two more.
std::size_t end_of_quoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool lines = text.substr(at).starts_with(three);
  for (at += lines ? 3 : 1; at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\')
      ++at;
    else if (!lines && (text[at] == quote || text[at] == '\n'))
      return at + 1;
    else if (lines && text.substr(at).starts_with(three))
      return std::min(text.find_first_not_of(quote, at), std::min(at + 5, text.size()));
  }
  return text.size();
}

// A key may be anywhere but in a quoted text or a comment; no number and no date has two points.
void refuse_deep_keys(std::string_view text) {
  std::size_t dots = 0, line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      const std::size_t end = end_of_quoted(text, at);
      line += static_cast<std::size_t>(std::ranges::count(text.substr(at, end - at), '\n'));
      at = end;
      continue;
    }
    if (c == '#') at = std::min(text.find('\n', at), text.size() - 1);
    if (text[at] == '\n') ++line;
    dots = c == '.' ? dots + 1 : std::string_view("\n#=,[{").find(c) != std::string_view::npos ? 0 : dots;
    if (dots > most_dots)
      throw CLI::ConfigError("line " + std::to_string(line) +
                             ": the key is nested too deeply: write one `key = value` per option");
    ++at;
  }
}

std::string value_text(const std::string& key, const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
  if (const auto* number = node.as_floating_point()) return shortest(number->get());
  throw CLI::ConfigError(key + ": is a table or a date: write one `key = value` per option");
}

std::vector<std::string> texts_of(const std::string& key, const toml::node& node) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return {value_text(key, node)};
  if (list->empty()) throw CLI::ConfigError(key + ": is an empty list: give it a value or leave it out");
  std::vector<std::string> out;
  for (const toml::node& element : *list) out.push_back(value_text(key, element));
  return out;
}

// The key of a line, for messages, or where it is.
std::string key_at(const std::string& text, std::size_t line) {
  std::istringstream lines(text);
  std::string out;
  for (std::size_t i = 0; i < line; ++i) std::getline(lines, out);
  const std::size_t end = out.find_first_of(" \t=\r");
  return end == 0 || out.empty() ? "line " + std::to_string(line) : out.substr(0, end);
}

// ---- writing ----

bool is_number(const std::string& word) try {
  return toml::parse("x = " + word)["x"].is_number();
} catch (const toml::parse_error&) {
  return false;
}

// A text that looks like a number is none: a file "1.50" would come back as "1.5".
std::string toml(const CLI::Option& option, const std::string& value) {
  const bool number = option.get_type_name() == "N" || option.get_type_name() == "NUMBER";
  if (number && is_number(value)) return value;
  std::string out = "\"";
  for (const char c : value) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7f)
      out += fmt::format("\\u{:04X}", code);
    else
      out += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  }
  return out + "\"";
}

std::string toml(const CLI::Option& option, const std::vector<std::string>& values) {
  if (option.get_items_expected_max() <= 1) return toml(option, values.front());
  std::string out;
  for (const std::string& value : values) out += (out.empty() ? "" : ", ") + toml(option, value);
  return "[" + out + "]";
}

// "key = value", a comment when it is the default, or nothing where there is none.
std::string option_line(const CLI::Option& option) {
  const std::string key = option.get_single_name();
  const bool given = option.count() > 0;
  if (is_flag(option))
    return (given ? "" : "# ") + key + (given && option.as<bool>() ? " = true\n" : " = false\n");
  if (given) return key + " = " + toml(option, option.results()) + "\n";
  const std::string usual = option.get_default_str();
  return usual.empty() ? "" : "# " + key + " = " + toml(option, usual) + "\n";
}

class ConfigReader : public CLI::Config {
 public:
  std::string to_config(const CLI::App*, bool, bool, std::string) const override { return {}; }
  std::vector<CLI::ConfigItem> from_config(std::istream& in) const override;
  std::string to_flag(const CLI::ConfigItem& item) const override;
};

std::vector<CLI::ConfigItem> ConfigReader::from_config(std::istream& in) const {
  const std::string text = text_in(in);
  refuse_deep_keys(text);
  try {
    std::vector<CLI::ConfigItem> out;
    for (const auto& [name, node] : toml::parse(text)) {
      const std::string key(name.str());
      out.push_back({{}, key, texts_of(key, node)});
    }
    return out;
  } catch (const toml::parse_error& error) {
    const std::size_t line = error.source().begin.line;
    throw CLI::ConfigError(key_at(text, line) + ": " + std::string(error.description()) + " (line " +
                           std::to_string(line) + ")");
  }
}

std::string ConfigReader::to_flag(const CLI::ConfigItem& item) const {
  if (item.inputs.size() == 1 && (item.inputs[0] == "true" || item.inputs[0] == "false"))
    return item.inputs[0];
  throw CLI::ConfigError(item.name + ": must be true or false");
}

}  // namespace

std::shared_ptr<CLI::Config> config_reader() { return std::make_shared<ConfigReader>(); }

std::string config_text(const CLI::App& app) {
  std::string out =
      "# Options of " + app.get_name() + ", for --config. Lines that begin with # are the defaults.\n";
  for (const std::string& group : app.get_groups()) {
    std::string lines;
    for (const CLI::Option* option : app.get_options())
      if (option->get_group() == group && option->get_configurable()) lines += option_line(*option);
    if (!lines.empty()) out += "\n# " + group + "\n" + lines;
  }
  return out;
}

}  // namespace asperity::cli
