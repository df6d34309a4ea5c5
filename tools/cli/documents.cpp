#include "tools/cli/documents.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

#include "tools/cli/record.hpp"
#include "tools/cli/toolbox.hpp"

namespace asperity::cli {

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> out;
  for (const std::string& name : option.get_snames()) out.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.push_back("--" + name);
  return out;
}

bool is_flag(const CLI::Option& option) { return option.get_expected_min() == 0; }

std::string flowing(const std::string& text, std::size_t width, const std::string& indent) {
  std::istringstream words(text);
  std::string out, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width) {
      out += line + '\n' + indent;
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return out + line;
}

std::string kind_of(const CLI::Option& option) {
  constexpr std::size_t longest_list = 40;
  const std::string kind = option.get_type_name();
  return kind.size() > longest_list && kind.find('|') != kind.npos ? "WORD" : kind;
}

Value value_of(const CLI::Option& option) {
  if (is_flag(option)) return Value::none;
  const std::string kind = option.get_type_name();
  if (kind.find("FILE") != kind.npos || kind == "PATTERN") return Value::file;  // "NAME|FILE" too
  if (kind.find('|') != kind.npos) return Value::word;
  return option.get_positional() ? Value::file : Value::other;
}

std::vector<std::string> words_of(const CLI::Option& option) { return split(option.get_type_name(), '|'); }

std::string text_of(const CLI::Option& option) {
  std::string text = flowing(option.get_description());
  if (text.ends_with('.')) text.pop_back();
  if (const std::string kind = option.get_type_name(); kind != kind_of(option))
    text += fmt::format(". One of {}", fmt::join(words_of(option), ", "));
  if (option.get_required()) return text + ". Required";
  const std::string usual = option.get_default_str();
  return usual.empty() ? text : text + ". Default: " + usual;
}

// ---- the pages of accuracy ----

namespace {

constexpr std::pair<std::string_view, const char*> accuracy_pages[] = {
#include "accuracy.inc"
};

}  // namespace

std::vector<Paragraph> accuracy_of(std::string_view tool) {
  const auto* page = std::ranges::find(accuracy_pages, tool, [](const auto& of) { return of.first; });
  if (page == std::end(accuracy_pages)) return {};
  std::vector<Paragraph> out;
  std::istringstream lines(page->second);
  bool apart = true;  // the next line begins a paragraph
  for (std::string line; std::getline(lines, line);) {
    const bool item = line.starts_with("* ");
    if (!line.empty() && !line.starts_with("# ")) {
      if (apart || item) out.push_back({item, ""});
      out.back().text = flowing(out.back().text + " " + line.substr(item ? 2 : 0));
    }
    apart = line.empty();
  }
  return out;
}

// ---- the manual page ----

namespace {

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string section(const std::string& name, const std::string& body) {
  return body.empty() ? "" : ".SH " + name + "\n" + body;
}

std::string paragraph(const std::string& text) { return text.empty() ? "" : roff(flowing(text)) + "\n"; }

std::string page_of(const std::vector<Paragraph>& paragraphs) {
  std::string out;
  for (const auto& [item, text] : paragraphs)
    out += (item ? ".IP \\(bu 2\n" : out.empty() ? "" : ".PP\n") + roff(text) + "\n";
  return out;
}

std::string entry(const std::string& head, const std::string& text) {
  return ".TP\n" + head + "\n" + roff(text) + "\n";
}

// "-o, --output FILE"
std::string bold_head_of(const CLI::Option& option) {
  if (option.get_positional()) return italic(option.get_single_name());
  std::string out;
  for (const std::string& name : names_of(option)) out += (out.empty() ? "" : ", ") + bold(name);
  return is_flag(option) ? out : out + " " + italic(kind_of(option));
}

std::string options_by_group(const CLI::App& app) {
  std::string out;
  for (const std::string& group : app.get_groups()) {
    out += ".SS " + roff(group == "Options" ? "Arguments" : group) + "\n";
    for (const CLI::Option* option : app.get_options())
      if (option->get_group() == group) out += entry(bold_head_of(*option), text_of(*option) + ".");
  }
  return out;
}

std::string synopsis(const CLI::App& app) {
  std::string out = bold(app.get_name()) + " [" + italic("OPTION") + "]...";
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional())
      out += " [" + italic(option->get_single_name()) + "]" +
             (option->get_items_expected_max() > 1 ? "..." : "");
  return out + "\n";
}

std::string statuses(const std::vector<ExitStatus>& all) {
  std::string out;
  for (const auto& [code, meaning] : all) out += entry(bold(std::to_string(code)), meaning);
  return out;
}

std::string environment(const std::string& tool) {
  return entry(bold(environment_name(tool, "OPTION")),
               "An option, in upper case and with underscores for hyphens, such as " +
                   environment_name(tool, "memory") +
                   "; the command line comes first, the file of --config last.") +
         entry(bold("SOURCE_DATE_EPOCH"),
               "The time in a dataset's history, in seconds since 1970. No times of computation are recorded "
               "then, so that the same command gives the same bytes.");
}

std::string see_also(const std::string& self) {
  std::string out;
  for (const Summary& other : toolbox)
    if (other.tool != self) out += (out.empty() ? "" : ",\n") + bold(std::string(other.tool)) + "(1)";
  return out + "\n";
}

// The character that begins at `at`, which moves to its end.
unsigned code_point(const std::string& text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at++]);
  const int more = first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
  unsigned out = first & (0x3Fu >> more);
  for (int i = 0; i < more && at < text.size(); ++i)
    out = out << 6 | (static_cast<unsigned char>(text[at++]) & 0x3Fu);
  return out;
}

}  // namespace

std::string roff(const std::string& text) {
  constexpr struct {
    char character;
    const char* escape;
  } escapes[] = {{'\\', "\\e"},  {'-', "\\-"},   {'\'', "\\(aq"},
                 {'`', "\\(ga"}, {'^', "\\(ha"}, {'~', "\\(ti"}};
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (static_cast<unsigned char>(c) >= 0x80) {
      out += fmt::format("\\[u{:04X}]", code_point(text, at));
      continue;
    }
    ++at;
    if (c == '.' && (out.empty() || out.back() == '\n')) out += "\\&";
    const auto* own = std::ranges::find_if(escapes, [&](const auto& e) { return e.character == c; });
    out += own == std::end(escapes) ? std::string(1, c) : own->escape;
  }
  return out;
}

std::string man_page(const CLI::App& app, const Documents& more) {
  const std::string name = app.get_name(), description = flowing(app.get_description());
  std::string title = name;
  std::ranges::transform(title, title.begin(), [](unsigned char c) { return std::toupper(c); });
  return ".TH " + title + " 1 " + timestamp().substr(0, 10) + " \"Asperity " + version() +
         "\" \"Asperity\"\n" +
         section("NAME", roff(name) + " \\- " + roff(std::string(summary_of(name))) + "\n") +
         section("SYNOPSIS", synopsis(app)) +
         section("DESCRIPTION", paragraph(description.ends_with('.') ? description : description + ".")) +
         section("OPTIONS", paragraph("A quantity has a unit: 3mm, 0.4um, 208GPa, 5000N, 30deg.") +
                                options_by_group(app)) +
         section("EXAMPLES", more.example.empty() ? "" : ".nf\n" + roff(more.example) + "\n.fi\n") +
         section("ACCURACY", page_of(accuracy_of(name))) + section("ENVIRONMENT", environment(name)) +
         section("EXIT STATUS", statuses(more.statuses)) + section("SEE ALSO", see_also(name));
}

// ---- completions ----

namespace {

// "exponential gaussian"
std::string in_a_line(const CLI::Option& option) {
  return fmt::format("{}", fmt::join(words_of(option), " "));
}

// The names of all options of these kinds.
std::vector<std::string> all_names(const CLI::App& app, std::initializer_list<Value> kinds) {
  std::vector<std::string> out;
  for (const CLI::Option* option : app.get_options())
    if (std::ranges::find(kinds, value_of(*option)) != kinds.end())
      std::ranges::copy(names_of(*option), std::back_inserter(out));
  return out;
}

std::string branch(const std::vector<std::string>& names, const std::string& what) {
  return names.empty() ? ""
                       : fmt::format("    {})\n      {}\n      return ;;\n", fmt::join(names, "|"), what);
}

// A text within single quotes of a shell, ':' and brackets as _arguments takes them.
std::string described(const std::string& text) {
  std::string out;
  for (const char c : flowing(text.substr(0, std::min(text.find("; "), text.find(". ")))))
    out += c == '\'' ? "'\\''" : std::string(c == ':' || c == '[' || c == ']' || c == '\\' ? "\\" : "") + c;
  return out;
}

// '(-o --output)'{-o,--output=}'[Where the result goes]:FILE:_files'
std::string zsh_argument(const CLI::Option& option) {
  const Value value = value_of(option);
  std::vector<std::string> names = names_of(option);
  const std::string all = fmt::format("{}", fmt::join(names, " "));
  if (value != Value::none)
    for (std::string& name : names) name += name.starts_with("--") ? "=" : "+";
  std::string rest = "[" + described(option.get_description()) + "]";
  if (value == Value::file) rest += ":file:_files";
  if (value == Value::word) rest += ":word:(" + in_a_line(option) + ")";
  if (value == Value::other) rest += ":" + described(option.get_type_name()) + ": ";
  const char* repeated = option.get_items_expected_max() > 1 ? "*" : "";  // Tool::step
  return names.size() == 1 ? fmt::format("'{}{}{}'", repeated, names[0], rest)
                           : fmt::format("'({})'{{{}}}'{}'", all, fmt::join(names, ","), rest);
}

// Of the function's name, the tool's, branches for values, all names, what completes an argument.
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
    mapfile -t COMPREPLY < <(compgen {4} -- "$current")
  fi
}}
complete -F {0} {1}
)";

}  // namespace

std::string bash_completion(const CLI::App& app) {
  using enum Value;
  std::string function = "_" + app.get_name(), branches;
  std::ranges::replace(function, '-', '_');
  std::string arguments = "-f";
  for (const CLI::Option* option : app.get_options())
    if (value_of(*option) == word && option->get_positional())
      arguments = "-W '" + in_a_line(*option) + "'";
    else if (value_of(*option) == word)
      branches += branch(names_of(*option),
                         "mapfile -t COMPREPLY < <(compgen -W '" + in_a_line(*option) + "' -- \"$current\")");
  branches += branch(all_names(app, {file}),
                     "compopt -o filenames 2>/dev/null\n"
                     "      mapfile -t COMPREPLY < <(compgen -f -- \"$current\")");
  branches += branch(all_names(app, {other}), ":");
  return fmt::format(fmt::runtime(bash_script), function, app.get_name(), branches,
                     fmt::join(all_names(app, {none, file, word, other}), " "), arguments);
}

std::string zsh_completion(const CLI::App& app) {
  std::string out =
      fmt::format("#compdef {0}\n# printed by {0} --completion zsh\n_arguments -S", app.get_name());
  std::string arguments;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_positional())
      out += " \\\n  " + zsh_argument(*option);
    else
      arguments =
          value_of(*option) == Value::word ? "':word:(" + in_a_line(*option) + ")'" : "'*:file:_files'";
  return out + (arguments.empty() ? "" : " \\\n  " + arguments) + "\n";
}

}  // namespace asperity::cli
