// Options that are steps: their order counts, and one may come again.
#include <algorithm>
#include <cctype>
#include <map>

#include <CLI/CLI.hpp>

#include "core/words.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {
namespace {

// The words of a line as a shell has them: quotes hold blanks, and a backslash the character behind it.
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

std::string line_of(const std::vector<Tool::Step>& steps) {
  std::string out;
  for (const auto& [option, value] : steps)
    out += (out.empty() ? "--" : " --") + option + " " + shell_word(value);
  return out;
}

}  // namespace

Option Tool::step(const std::string& name, const std::string& kind, const std::string& text,
                  const std::string& group) {
  CLI::Option* option = app_->add_option_function<std::vector<std::string>>(
      name, [](const std::vector<std::string>&) {}, text);
  option->group(group)->type_name(kind)->allow_extra_args(false)->configurable(false);
  step_options_.push_back(option);
  return {option};
}

void Tool::steps_in_a_text(const std::string& group) {
  text("--steps", steps_text_, "TEXT",
       "The steps as they would stand here, '--remove-form plane --lambda-s 8um': for a file of --config and "
       "for the environment, which have no order. Steps on the command line replace them",
       group);
}

// CLI11 has the values of each option in their order, and the order of the options.
std::vector<Tool::Step> Tool::steps_of_command_line() const {
  std::vector<Step> out;
  std::map<const CLI::Option*, std::size_t> used;
  for (const CLI::Option* option : app_->parse_order())
    if (std::ranges::find(step_options_, option) != step_options_.end())
      out.push_back({option->get_single_name(), option->results().at(used[option]++)});
  return out;
}

std::vector<Tool::Step> Tool::steps_of_text() const {
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

std::vector<Tool::Step> Tool::steps() const {
  const std::vector<Step> typed = steps_of_command_line();
  return typed.empty() ? steps_of_text() : typed;
}

// What --dump-config prints in place of the single steps.
void Tool::settle_steps() {
  const std::vector<Step> typed = steps_of_command_line();
  if (typed.empty()) return;
  CLI::Option* text = app_->get_option("--steps");
  if (origin("steps") == "--steps" && text->count() > 0)
    throw UsageError("steps", "cannot be combined with --" + typed.front().option + ": write all steps here");
  text->clear();
  text->add_result(line_of(typed));
}

}  // namespace asperity::cli
