#include "tools/cli/completion.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

namespace asperity::cli {
namespace {

// What can stand behind an option.
enum class Value { none, file, word, other };

Value value_of(const Option& option) {
  if (option.is_flag()) return Value::none;
  const std::string kind = option.kind();
  if (kind.starts_with("FILE") || kind == "PATTERN" || option.is_positional()) return Value::file;
  return kind.find('|') != kind.npos ? Value::word : Value::other;
}

// "exponential|gaussian" as "exponential gaussian"
std::string words_of(const Option& option) {
  std::string out = option.kind();
  std::ranges::replace(out, '|', ' ');
  return out;
}

std::string branch(const std::vector<std::string>& names, const std::string& what) {
  return names.empty() ? ""
                       : fmt::format("    {})\n      {}\n      return ;;\n", fmt::join(names, "|"), what);
}

// One branch of all options of one kind.
std::string branch(const std::vector<Option>& options, Value kind, const std::string& what) {
  std::vector<std::string> names;
  for (const Option& option : options)
    if (value_of(option) == kind) std::ranges::copy(option.names(), std::back_inserter(names));
  return branch(names, what);
}

// A text within single quotes of a shell, ':' and brackets as _arguments takes them.
std::string described(const std::string& text) {
  std::istringstream words(text.substr(0, std::min(text.find("; "), text.find(". "))));
  std::string out;
  for (std::string word; words >> word;) {
    if (!out.empty()) out += ' ';
    for (char c : word)
      out += c == '\'' ? "'\\''" : std::string(c == ':' || c == '[' || c == ']' || c == '\\' ? "\\" : "") + c;
  }
  return out;
}

// '(-o --output)'{-o,--output=}'[Where the result goes]:FILE:_files'
std::string argument(const Option& option) {
  const Value value = value_of(option);
  std::vector<std::string> names = option.names();
  const std::string all = fmt::format("{}", fmt::join(names, " "));
  if (value != Value::none)
    for (std::string& name : names) name += name.starts_with("--") ? "=" : "+";
  std::string rest = "[" + described(option.text()) + "]";
  if (value == Value::file) rest += ":file:_files";
  if (value == Value::word) rest += ":word:(" + words_of(option) + ")";
  if (value == Value::other) rest += ":" + described(option.kind()) + ": ";
  return names.size() == 1 ? fmt::format("'{}{}'", names[0], rest)
                           : fmt::format("'({})'{{{}}}'{}'", all, fmt::join(names, ","), rest);
}

// Of the function's name, the tool's, branches for values, all names.
constexpr const char* bash_script = R"(# bash completion of {1}, printed by {1} --completion bash
{0}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  COMPREPLY=()
  if [[ $current == '=' ]]; then
    current=
  elif [[ $previous == '=' ]]; then
    previous=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  case $previous in
{2}  esac
  if [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W '{3}' -- "$current")
  else
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}}
complete -F {0} {1}
)";

}  // namespace

std::string bash_completion(const std::string& tool, const std::vector<Option>& options) {
  std::string function = "_" + tool, branches;
  std::ranges::replace(function, '-', '_');
  std::vector<std::string> names;
  for (const Option& option : options) {
    std::ranges::copy(option.names(), std::back_inserter(names));
    if (value_of(option) == Value::word)
      branches += branch(option.names(),
                         "mapfile -t COMPREPLY < <(compgen -W '" + words_of(option) + "' -- \"$current\")");
  }
  branches += branch(options, Value::file,
                     "compopt -o filenames 2>/dev/null\n"
                     "      mapfile -t COMPREPLY < <(compgen -f -- \"$current\")");
  branches += branch(options, Value::other, ":");
  return fmt::format(fmt::runtime(bash_script), function, tool, branches, fmt::join(names, " "));
}

std::string zsh_completion(const std::string& tool, const std::vector<Option>& options) {
  std::string out = fmt::format("#compdef {0}\n# printed by {0} --completion zsh\n_arguments -S", tool);
  for (const Option& option : options)
    if (!option.is_positional()) out += " \\\n  " + argument(option);
  const bool reads = std::ranges::any_of(options, &Option::is_positional);
  return out + (reads ? " \\\n  '*:file:_files'\n" : "\n");
}

}  // namespace asperity::cli
