#include "cli/config.hpp"

#include <algorithm>
#include <iterator>
#include <regex>

namespace asperity::cli {
namespace {

// ---- reading ----

bool is_number(const std::string& word) {
  static const std::regex number(R"([+-]?(inf|nan|(0|[1-9][0-9]*)(\.[0-9]+)?([eE][+-]?[0-9]+)?))");
  return std::regex_match(word, number);
}

class Reader {
 public:
  explicit Reader(std::string text) : text_(std::move(text)) {}

  std::vector<CLI::ConfigItem> items() {
    std::vector<CLI::ConfigItem> out;
    for (skip(); !at_end(); skip()) {
      CLI::ConfigItem item;
      item.name = key_ = key();
      if (std::ranges::find(out, key_, &CLI::ConfigItem::name) != out.end()) fail("is given twice");
      if (blank(); take() != '=') fail("is followed by no '='");
      blank();
      item.inputs = values();
      if (blank(); !at_end() && peek() != '\n' && peek() != '#') fail("has more than one value");
      out.push_back(std::move(item));
      key_.clear();
    }
    return out;
  }

 private:
  bool at_end() const { return at_ == text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  char take() { return at_end() ? '\0' : text_[at_++]; }

  void blank() {
    while (peek() == ' ' || peek() == '\t' || peek() == '\r') ++at_;
  }
  // White space, ends of lines and comments.
  void skip() {
    for (blank(); peek() == '\n' || peek() == '#'; blank())
      at_ = peek() == '#' ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
  }

  // As far as one of `ends`.
  std::string word(const char* ends) {
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(ends, at_), text_.size());
    return text_.substr(begin, at_ - begin);
  }

  std::string key() {
    if (peek() == '[') fail("tables are not for options: leave the [...] out");
    if (peek() == '"' || peek() == '\'') return quoted();
    return word(" \t\r\n=#");
  }

  std::vector<std::string> values() {
    if (peek() != '[') return {value()};
    std::vector<std::string> out;
    ++at_;
    for (skip(); peek() != ']'; skip()) {
      out.push_back(value());
      if (skip(); peek() == ',')
        ++at_;
      else if (peek() != ']')
        fail("is a list that does not end");
    }
    ++at_;
    return out;
  }

  std::string value() {
    if (peek() == '"' || peek() == '\'') return quoted();
    std::string out = word(" \t\r\n,]#");
    if (out.empty()) fail("has no value");
    if (out != "true" && out != "false" && !is_number(out)) fail("'" + out + "' is a text and needs quotes");
    return out;
  }

  std::string quoted() {
    const char quote = take();
    std::string out;
    while (peek() != quote) {
      if (at_end() || peek() == '\n') fail("is a text that does not end");
      const char c = take();
      out += c == '\\' && quote == '"' ? escaped() : c;
    }
    ++at_;
    return out;
  }

  char escaped() {
    switch (const char c = take()) {
      case '"':
      case '\\':
        return c;
      case 'n':
        return '\n';
      case 't':
        return '\t';
      default:
        fail(std::string("has the escape \\") + c + ", which is none of \\\" \\\\ \\n \\t");
    }
  }

  [[noreturn]] void fail(const std::string& why) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    throw CLI::ConfigError((key_.empty() ? "line " + std::to_string(line) : key_) + ": " + why);
  }

  std::string text_, key_;
  std::size_t at_ = 0;
};

// ---- writing ----

std::string toml(const std::string& value) {
  if (is_number(value)) return value;
  std::string out = "\"";
  for (char c : value)
    if (c == '"' || c == '\\')
      out += std::string("\\") + c;
    else
      out += c == '\n' ? "\\n" : c == '\t' ? "\\t" : std::string(1, c);
  return out + "\"";
}

std::string toml(const std::vector<std::string>& values) {
  std::string out;
  for (const std::string& value : values) out += (out.empty() ? "" : ", ") + toml(value);
  return "[" + out + "]";
}

// "key = value", a comment when it is the default, or nothing where there is none.
std::string line_of(const CLI::Option& option) {
  const std::string key = option.get_single_name();
  if (option.count() > 0) {
    if (is_flag(option)) return key + (option.as<bool>() ? " = true\n" : " = false\n");
    const std::vector<std::string>& given = option.results();
    return key + " = " + (option.get_items_expected_max() > 1 ? toml(given) : toml(given.front())) + "\n";
  }
  if (is_flag(option)) return "# " + key + " = false\n";
  return option.get_default_str().empty() ? "" : "# " + key + " = " + toml(option.get_default_str()) + "\n";
}

}  // namespace

std::string ConfigFile::to_config(const CLI::App* app, bool, bool, std::string) const {
  std::string out = "# Options of " + app->get_name() + ", for --config; behind # what is so by default.\n";
  for (const std::string& group : app->get_groups()) {
    std::string lines;
    for (const CLI::Option* option : app->get_options())
      if (option->get_group() == group && option->get_configurable()) lines += line_of(*option);
    if (!lines.empty()) out += "\n# " + group + "\n" + lines;
  }
  return out;
}

std::vector<CLI::ConfigItem> ConfigFile::from_config(std::istream& in) const {
  return Reader(std::string(std::istreambuf_iterator<char>(in), {})).items();
}

std::string ConfigFile::to_flag(const CLI::ConfigItem& item) const {
  if (item.inputs.size() == 1 && (item.inputs[0] == "true" || item.inputs[0] == "false"))
    return item.inputs[0];
  throw CLI::ConfigError(item.name + ": is true or false");
}

std::string in_words(const CLI::ConfigError& error) {
  const std::string what = error.what(), unknown = "INI was not able to parse ";
  return what.starts_with(unknown) ? "there is no option " + what.substr(unknown.size()) : what;
}

}  // namespace asperity::cli
