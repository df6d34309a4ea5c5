#include "tools/cli/completion.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "tools/cli/config.hpp"

namespace asperity::cli {
namespace {

// What can stand behind an option.
enum class Value { none, file, word, other };

Value value_of(const CLI::Option& option) {
  if (is_flag(option)) return Value::none;
  const std::string kind = option.get_type_name();
  if (kind.starts_with("FILE") || kind == "PATTERN" || option.get_positional()) return Value::file;
  return kind.find('|') != kind.npos ? Value::word : Value::other;
}

// "exponential|gaussian" as "exponential gaussian"
std::string words_of(const CLI::Option& option) {
  std::string out = option.get_type_name();
  std::ranges::replace(out, '|', ' ');
  return out;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> out;
  for (const std::string& name : option.get_snames()) out.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.push_back("--" + name);
  return out;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : between) + word;
  return out;
}

// All names of the options of one kind.
std::vector<std::string> names_with(const CLI::App& app, Value kind) {
  std::vector<std::string> out;
  for (const CLI::Option* option : app.get_options())
    if (value_of(*option) == kind) std::ranges::copy(names_of(*option), std::back_inserter(out));
  return out;
}

std::string branch(const std::vector<std::string>& names, const std::string& what) {
  return names.empty() ? "" : "    " + joined(names, "|") + ")\n      " + what + "\n      return ;;\n";
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
std::string argument(const CLI::Option& option) {
  const Value value = value_of(option);
  std::vector<std::string> names = names_of(option);
  const std::string all = joined(names, " ");
  if (value != Value::none)
    for (std::string& name : names) name += name.starts_with("--") ? "=" : "+";
  std::string rest = "[" + described(option.get_description()) + "]";
  if (value == Value::file) rest += ":file:_files";
  if (value == Value::word) rest += ":word:(" + words_of(option) + ")";
  if (value == Value::other) rest += ":" + described(option.get_type_name()) + ": ";
  return names.size() == 1 ? "'" + names[0] + rest + "'"
                           : "'(" + all + ")'{" + joined(names, ",") + "}'" + rest + "'";
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  const std::string& tool = app.get_name();
  std::string function = "_" + tool;
  std::ranges::replace(function, '-', '_');
  std::string choices, all;
  for (const CLI::Option* option : app.get_options()) {
    if (value_of(*option) == Value::word)
      choices += branch(names_of(*option),
                        "mapfile -t COMPREPLY < <(compgen -W '" + words_of(*option) + "' -- \"$current\")");
    for (const std::string& name : names_of(*option)) all += (all.empty() ? "" : " ") + name;
  }
  const std::string files =
      "compopt -o filenames 2>/dev/null\n      mapfile -t COMPREPLY < <(compgen -f -- \"$current\")";
  return "# bash completion of " + tool + ", printed by " + tool + " --completion bash\n" + function +
         "() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  COMPREPLY=()\n"
         "  if [[ $current == '=' ]]; then\n"
         "    current=\n"
         "  elif [[ $previous == '=' ]]; then\n"
         "    previous=${COMP_WORDS[COMP_CWORD - 2]}\n"
         "  fi\n"
         "  case $previous in\n" +
         choices + branch(names_with(app, Value::file), files) + branch(names_with(app, Value::other), ":") +
         "  esac\n"
         "  if [[ $current == -* ]]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W '" +
         all +
         "' -- \"$current\")\n"
         "  else\n"
         "    compopt -o filenames 2>/dev/null\n"
         "    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
         "  fi\n"
         "}\n"
         "complete -F " +
         function + " " + tool + "\n";
}

std::string zsh_completion(const CLI::App& app) {
  std::string out =
      "#compdef " + app.get_name() + "\n# printed by " + app.get_name() + " --completion zsh\n_arguments -S";
  bool reads = false;
  for (const CLI::Option* option : app.get_options()) {
    reads = reads || option->get_positional();
    if (!names_of(*option).empty()) out += " \\\n  " + argument(*option);
  }
  return out + (reads ? " \\\n  '*:file:_files'\n" : "\n");
}

}  // namespace asperity::cli
