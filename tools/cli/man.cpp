#include "tools/cli/man.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include <fmt/format.h>

#include "tools/cli/record.hpp"

namespace asperity::cli {
namespace {

constexpr const char* siblings = ASPERITY_TOOLS;  // their names, a blank between them

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// The words of a text with one blank between them, as help texts are wrapped.
std::string flowing(const std::string& text) {
  std::istringstream words(text);
  std::string out;
  for (std::string word; words >> word;) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::string section(const std::string& name, const std::string& body) {
  return body.empty() ? "" : ".SH " + name + "\n" + body;
}

std::string paragraph(const std::string& text) { return text.empty() ? "" : roff(flowing(text)) + "\n"; }

// "-o, --output FILE"
std::string names_of(const Option& option) {
  if (option.is_positional()) return italic(option.key());
  std::string out;
  for (const std::string& name : option.names()) out += (out.empty() ? "" : ", ") + bold(name);
  return option.is_flag() ? out : out + " " + italic(option.kind());
}

std::string entry(const Option& option) {
  std::string text = flowing(option.text());
  if (!text.ends_with('.')) text += ".";
  if (option.is_required()) text += " Required.";
  if (const std::string usual = option.shown_default(); !usual.empty()) text += " Default: " + usual + ".";
  return ".TP\n" + names_of(option) + "\n" + roff(text) + "\n";
}

std::string options_by_group(const Tool& tool) {
  std::string out;
  for (const OptionGroup& group : by_group(tool.options())) {
    out += ".SS " + roff(group.heading == "Options" ? "Arguments" : group.heading) + "\n";
    for (const Option& option : group.options) out += entry(option);
  }
  return out;
}

std::string synopsis(const Tool& tool) {
  std::string out = bold(tool.name()) + " [" + italic("OPTION") + "]...";
  for (const Option& option : tool.options())
    if (option.is_positional()) out += " [" + italic(option.key()) + "]";
  return out + "\n";
}

// The lines of a command as they stand.
std::string example(const std::string& command) {
  if (command.empty()) return "";
  std::istringstream lines(command);
  std::string out = ".nf\n";
  for (std::string line; std::getline(lines, line);) out += roff(line) + "\n";
  return out + ".fi\n";
}

std::string statuses() {
  std::string out;
  for (const auto& [code, meaning] : exit_statuses)
    out += fmt::format(".TP\n{}\n{}\n", bold(std::to_string(code)), roff(meaning));
  return out;
}

std::string environment() {
  auto variable = [](const std::string& name, const std::string& text) {
    return ".TP\n" + bold(name) + "\n" + roff(text) + "\n";
  };
  return variable("ASPERITY_OPTION",
                  "Any option, in upper case and with underscores for hyphens, such as ASPERITY_THREADS; the "
                  "command line comes first, the file of --config last.") +
         variable(
             "SOURCE_DATE_EPOCH",
             "The time that goes into a dataset's history, in seconds since 1970; no times of computation "
             "are recorded then, so that the same command gives the same bytes.");
}

std::string see_also(const std::string& self) {
  std::istringstream names(siblings);
  std::string out;
  for (std::string name; names >> name;)
    if (name != self) out += (out.empty() ? "" : ",\n") + bold(name) + "(1)";
  return out + "\n";
}

// What the description says up to its first stop.
std::string summary(const std::string& description) {
  return description.substr(0, std::min(description.find(". "), description.find(": ")));
}

// The character that begins at `at`, which moves behind it.
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

std::string man_page(const Tool& tool) {
  const std::string description = flowing(tool.description());
  return ".TH " + upper(tool.name()) + " 1 " + timestamp().substr(0, 10) + " \"Asperity " + version() +
         "\" \"Asperity\"\n" +
         section("NAME", roff(tool.name()) + " \\- " + roff(summary(description)) + "\n") +
         section("SYNOPSIS", synopsis(tool)) +
         section("DESCRIPTION", paragraph(description.ends_with('.') ? description : description + ".")) +
         section("OPTIONS", paragraph("Quantities carry their unit (3mm, 0.4um, 208GPa, 5000N); px counts "
                                      "samples.") +
                                options_by_group(tool)) +
         section("EXAMPLES", example(tool.example())) + section("ACCURACY", paragraph(tool.accuracy())) +
         section("ENVIRONMENT", environment()) + section("EXIT STATUS", statuses()) +
         section("SEE ALSO", see_also(tool.name()));
}

}  // namespace asperity::cli
