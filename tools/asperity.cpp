// The tools by one name: a list of them, their manual, the pages of the documentation, and each as a command.
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include "core/os.hpp"
#include "tools/cli/documents.hpp"
#include "tools/cli/program.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/tool.hpp"
#include "tools/cli/toolbox.hpp"

using namespace asperity;

namespace {

namespace fs = std::filesystem;

const std::string prefix = "asperity-";

bool is_tool(const std::string& word) { return !cli::summary_of(prefix + word).empty(); }

fs::path own_folder;  // with the programs and pages that were installed, or built, together with this one

// Where the system does not tell it, from the name by which this program was called.
fs::path folder_of_program(const std::string& called) {
  const std::string own = os::own_program();
  if (!own.empty()) return fs::path(own).parent_path();
  std::error_code none;
  const bool named = called.find('/') == called.npos;
  return fs::canonical(named ? cli::program_path(called) : called, none).parent_path();
}

fs::path pages() { return own_folder.parent_path() / "share" / "doc" / "asperity"; }

[[noreturn]] void become(const std::string& program, std::vector<std::string> arguments) {
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  ::execvp(program.c_str(), words.data());
  throw std::system_error(errno, std::generic_category(), program);
}

// $0 is the page, or the program.
constexpr const char* show_page =
    "for p in \"$PAGER\" less more; do command -v $p >/dev/null && exec $p \"$0\"; done; exec cat \"$0\"";
constexpr const char* show_manual =
    "if command -v man >/dev/null; then \"$0\" --man | man -l -; else \"$0\" --help; fi";

// ---- help ----

std::string text_of(const fs::path& page) {
  std::ifstream in(page, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> topics() {
  std::vector<std::string> out;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(pages(), none))
    if (entry.path().extension() == ".md" && entry.path().stem() != "README" &&
        entry.path().stem() != "CHANGELOG")
      out.push_back(entry.path().stem());
  std::ranges::sort(out);
  return out;
}

std::string list_of_topics() {
  std::string out = "asperity help TOPIC opens a page. TOPIC is the name of a tool, or one of these:\n";
  for (const std::string& topic : topics()) {
    const std::string text = text_of(pages() / (topic + ".md"));
    out += fmt::format("  {:<18}{}\n", topic, text.substr(2, text.find_first_of("\n{") - 2));  // behind "# "
  }
  return out;
}

std::string list_of_tools() {
  std::string out = "Random rough surfaces: drawn, measured, pressed together, stressed.\n\n";
  for (const cli::Summary& tool : cli::toolbox)
    out += fmt::format("  asperity {:<12}{}\n", tool.tool.substr(prefix.size()), tool.text);
  return out +
         "\nasperity TOOL -h    the most used options, and an example\n"
         "asperity help       the pages of the documentation\n";
}

// As a choice of words, for completion.
std::string list_of_words() {
  std::string out = "help";
  for (const cli::Summary& s : cli::toolbox) out += "|" + std::string(s.tool.substr(prefix.size()));
  return out;
}

int open_manual(const std::string& tool) {
  const std::string program = own_folder / (prefix + tool);
  if (!cli::stdout_is_terminal()) become(program, {program, "--help"});
  become("/bin/sh", {"sh", "-c", show_manual, program});
}

int help_on(const std::string& topic) {
  const std::string name = topic.starts_with(prefix) ? topic.substr(prefix.size()) : topic;
  if (is_tool(name)) return open_manual(name);
  const std::vector<std::string> all = topics();
  if (std::ranges::find(all, name) == all.end())
    throw cli::UsageError("COMMAND", "there is no page '" + topic + "': asperity help lists them");
  const std::string page = pages() / (name + ".md");
  if (cli::stdout_is_terminal()) become("/bin/sh", {"sh", "-c", show_page, page});
  cli::write_all("-", text_of(page));
  return cli::done;
}

int run(const std::vector<std::string>& words) {
  if (words.empty())
    cli::write_all("-", list_of_tools());
  else if (words[0] != "help")
    throw cli::UsageError("COMMAND", "there is no tool '" + words[0] + "'" + cli::nearest_tool(words[0]) +
                                         "; asperity lists them");
  else if (words.size() > 2)
    throw cli::UsageError("COMMAND", "'" + words[2] + "' is one argument too many: name one page");
  else if (words.size() == 2)
    return help_on(words[1]);
  else
    cli::write_all("-", list_of_topics());
  return cli::done;
}

}  // namespace

int main(int argc, char** argv) {
  own_folder = folder_of_program(argc > 0 ? argv[0] : "");
  if (argc > 1 && is_tool(argv[1])) {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    const std::string program = own_folder / (prefix + arguments[0]);
    arguments[0] = program;
    become(program, std::move(arguments));
  }
  cli::Tool tool(
      "asperity",
      "Lists the tools; 'asperity TOOL ...' runs asperity-TOOL, 'asperity help' lists the pages of the "
      "documentation, 'asperity help TOPIC' opens one of them or the manual of a tool.");
  std::vector<std::string> words;
  tool.arguments("COMMAND", words, list_of_words(), "A tool with its options, or help and a topic");
  tool.documents_only();
  tool.example("asperity generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity stats");
  return tool.run(argc, argv, [&] { return run(words); });
}
