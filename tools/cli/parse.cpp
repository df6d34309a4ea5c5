// Where the value of an option comes from: the command line, the environment, a file of options.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "core/words.hpp"
#include "tools/cli/documents.hpp"
#include "tools/cli/options.hpp"
#include "tools/cli/record.hpp"

namespace asperity::cli {
namespace {

// Whether the arguments name the option, as "--size 3mm", "--size=3mm", "-o x" or "-ox".
bool have(const std::vector<std::string>& arguments, const CLI::Option& option) {
  const std::vector<std::string> names = names_of(option);
  return std::ranges::any_of(arguments, [&](const std::string& a) {
    return std::ranges::any_of(names, [&](const std::string& name) {
      return name.starts_with("--") ? a == name || a.starts_with(name + "=") : a.starts_with(name);
    });
  });
}

[[noreturn]] void refuse_empty(const std::string& key) {
  throw ParameterError(key, "is empty: give it a value or leave it out");
}

// The words of a line as a shell has them: quotes hold blanks, and a backslash the next character.
std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> out;
  char quote = '\0';
  bool within = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    const bool escape = c == '\\' && quote != '\'' && at + 1 < line.size();
    if (!quote && !escape && std::isspace(static_cast<unsigned char>(c))) {
      within = false;
      continue;
    }
    if (!within) out.emplace_back();
    within = true;
    if (escape)
      out.back() += line[++at];
    else if (c == quote || (!quote && (c == '\'' || c == '"')))
      quote = quote ? '\0' : c;
    else
      out.back() += c;
  }
  if (quote) throw ParameterError("steps", "a quotation mark is not closed");
  return out;
}

std::string line_of(const std::vector<Options::Step>& steps) {
  std::string out;
  for (const auto& [option, value] : steps)
    out += (out.empty() ? "--" : " --") + option + " " + shell_word(value);
  return out;
}

}  // namespace

std::string environment_name(const std::string& tool, const std::string& option) {
  std::string out = tool + "_" + option;
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return c == '-' ? '_' : std::toupper(c); });
  return out;
}

bool Options::has(const std::string& name) const { return app_->get_option_no_throw(name) != nullptr; }

std::string Options::config_to_print() const { return dump_config_ ? config_text(*app_) : ""; }

bool Options::given(const std::string& name) const {
  const CLI::Option* option = app_->get_option_no_throw(name);
  return option && option->count() > 0;
}

std::vector<std::string> Options::given_under(const std::vector<std::string>& headings) const {
  std::vector<std::string> out;
  for (const CLI::Option* option : app_->get_options({}))
    if (option->count() > 0 && std::ranges::find(headings, option->get_group()) != headings.end())
      out.push_back(option->get_single_name());
  return out;
}

// The arguments that variables stand for, where none on the command line is for the same option.
std::vector<std::string> Options::environment() const {
  std::vector<std::string> out;
  if (!computes_) return out;
  for (const CLI::Option* option : app_->get_options({})) {
    const std::string key = option->get_single_name();
    const bool settable = !option->get_positional() && (option->get_configurable() || key == "config");
    if (!settable || have(arguments_, *option)) continue;
    if (const char* value = std::getenv(environment_name(name_, key).c_str()))
      out.push_back("--" + key + "=" + value);
  }
  return out;
}

// A variable of this tool that stands for no option is a slip of the pen.
void Options::check_environment() const {
  if (!computes_) return;
  const std::string prefix = environment_name(name_, "");
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view variable(*entry, std::strcspn(*entry, "="));
    if (!variable.starts_with(prefix)) continue;
    std::string option(variable.substr(prefix.size()));
    std::ranges::transform(option, option.begin(),
                           [](unsigned char c) { return c == '_' ? '-' : std::tolower(c); });
    const CLI::Option* known = app_->get_option_no_throw("--" + option);
    if (known && std::ranges::find(step_options_, known) != step_options_.end())
      throw ParameterError(std::string(variable), "is a step, and its place among others is not known: set " +
                                                      environment_name(name_, "steps") +
                                                      " to all of them, in order");
    if (!known || !(known->get_configurable() || option == "config"))
      throw ParameterError(std::string(variable), unknown_option(*app_, "--" + option));
  }
}

// The first word on the command line that is neither an option nor a value of one.
std::string Options::unexpected() const {
  const std::vector<std::string> left = app_->remaining();
  const auto first = std::ranges::find_if(
      arguments_, [&](const std::string& a) { return std::ranges::find(left, a) != left.end(); });
  const std::string word = first == arguments_.end() ? left.front() : *first;
  if (word.starts_with("-") && word != "-") return unknown_option(*app_, word);
  return "'" + word + "' is one argument too many: " + name_ + " -h shows the usage";
}

void Options::parse(int argc, char** argv) try {
  arguments_.assign(argv + 1, argv + argc);
  command_line_ = name_;
  for (const std::string& a : arguments_) command_line_ += " " + shell_word(a);
  check_environment();
  environment_ = environment();
  read_values();
  settle_steps();
} catch (const CLI::ConfigError& e) {
  throw CommandLineError(config_file() + ": " + in_words(*app_, e));
} catch (const CLI::FileError&) {
  throw CommandLineError(origin("config") + ": '" + config_file() +
                         "' cannot be read: name an existing file");
} catch (const CLI::Error& e) {
  throw CommandLineError(app_->remaining().empty() ? in_words(e) : unexpected());
}

void Options::read_values() {
  for (CLI::Option* option : app_->get_options({}))
    if (!is_flag(*option) && option != may_be_empty_)
      option->check([key = option->get_single_name()](const std::string& value) {
        if (value.empty()) refuse_empty(key);
        return std::string();
      });
  std::vector<std::string> all = with_empty_values(environment_);
  std::ranges::copy(with_empty_values(arguments_), std::back_inserter(all));
  std::ranges::reverse(all);
  app_->parse(std::move(all));
}

// "--counter=" as two arguments: CLI11 would take the next for its value. Behind "--" are no options.
std::vector<std::string> Options::with_empty_values(const std::vector<std::string>& arguments) const {
  std::vector<std::string> out;
  const auto end = std::ranges::find(arguments, "--");
  for (auto a = arguments.begin(); a != end; ++a) {
    const bool empty = a->starts_with("--") && a->find('=') == a->size() - 1;
    const std::string name = a->substr(0, a->size() - empty);
    const CLI::Option* option = empty ? app_->get_option_no_throw(name) : nullptr;
    if (option && is_flag(*option)) refuse_empty(name.substr(2));
    out.push_back(option ? name : *a);
    if (option) out.emplace_back();
  }
  out.insert(out.end(), end, arguments.end());
  return out;
}

std::string Options::config_file() const {
  const CLI::Option* config = app_->get_config_ptr();
  return config == nullptr || config->count() == 0 ? "" : config->results().front();
}

// Where the value of an option came from, as its user would look for it.
std::string Options::origin(const std::string& key) const {
  const CLI::Option* option = app_->get_option_no_throw("--" + key);
  if (!option && std::getenv(key.c_str()) != nullptr) return key;  // no option's variable
  if (!option) return (app_->get_option_no_throw(key) ? "" : "--") + key;
  const bool step = std::ranges::find(step_options_, option) != step_options_.end();
  if (step && option->count() == 0) return origin("steps") + ": " + key;
  if (have(arguments_, *option)) return "--" + key;
  if (have(environment_, *option)) return environment_name(name_, key);
  return config_file().empty() || option->count() == 0 ? "--" + key : config_file() + ": " + key;
}

// The library states a value in SI units; its user looks for what was typed.
std::string Options::typed(const std::string& key, const std::string& message) const {
  const CLI::Option* option = app_->get_option_no_throw("--" + key);
  const bool value = message.find_first_of("-0123456789") == 0;
  if (!option || !value || option->results().size() != 1) return origin(key);
  const std::string& text = option->results().front();
  const bool repeated = message.starts_with(text + " ") || message.starts_with(text + ":");
  return repeated ? origin(key) : origin(key) + " " + text;
}

// ---- steps ----

// CLI11 has the values of each option in their order, and the order of the options.
std::vector<Options::Step> Options::steps_of_command_line() const {
  std::vector<Step> out;
  std::map<const CLI::Option*, std::size_t> used;
  for (const CLI::Option* option : app_->parse_order())
    if (std::ranges::find(step_options_, option) != step_options_.end())
      out.push_back({option->get_single_name(), option->results().at(used[option]++)});
  return out;
}

std::vector<Options::Step> Options::steps_of_text() const {
  const std::vector<std::string> words = shell_words(steps_text_);
  std::vector<Step> out;
  for (std::size_t at = 0; at < words.size(); ++at) {
    const std::size_t equals = std::min(words[at].find('='), words[at].size());
    const std::string name = words[at].substr(0, equals);
    const CLI::Option* option = name.starts_with("--") ? app_->get_option_no_throw(name) : nullptr;
    if (std::ranges::find(step_options_, option) == step_options_.end())
      refuse("steps", one_line(words[at], 64), "is no step: --help lists them");
    const bool joined = equals < words[at].size();
    if (!joined && ++at == words.size()) refuse("steps", name, "needs a value");
    out.push_back({name.substr(2), joined ? words[at].substr(equals + 1) : words[at]});
  }
  return out;
}

std::vector<Options::Step> Options::steps() const {
  const std::vector<Step> typed = steps_of_command_line();
  return typed.empty() ? steps_of_text() : typed;
}

// What --dump-config prints in place of the single steps.
void Options::settle_steps() {
  const std::vector<Step> typed = steps_of_command_line();
  if (typed.empty()) return;
  CLI::Option* text = app_->get_option("--steps");
  if (origin("steps") == "--steps" && text->count() > 0)
    throw UsageError("steps", "cannot be combined with --" + typed.front().option + ": write all steps here");
  text->clear();
  text->add_result(line_of(typed));
}

}  // namespace asperity::cli
