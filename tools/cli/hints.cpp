// What was meant by an option or a tool that there is not.
#include <algorithm>
#include <numeric>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tools/cli/documents.hpp"
#include "tools/cli/plain_text.hpp"
#include "tools/cli/toolbox.hpp"

namespace asperity::cli {
namespace {

struct Entry {
  std::string_view option, tools;  ///< tools without "asperity-", a blank between them
};

constexpr Entry entries[] = {
#include "option_names.inc"  // of docs/options.md
};

// Insertions, deletions, replacements and exchanges of neighbours that make one word of another.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  std::iota(d[0].begin(), d[0].end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

// The option of the tool that is spelt most nearly so, or that alone begins so; "" where none is near.
std::string nearest(const CLI::App& app, const std::string& word) {
  constexpr std::size_t least_prefix = 5;  // of "--" and three letters
  std::string best, longer;
  std::size_t least = word.size() / 3 + 1, begun = 0;
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = "--" + option->get_single_name();
    if (option->get_positional()) continue;
    if (word.size() >= least_prefix && name.starts_with(word)) longer = name, ++begun;
    if (const std::size_t d = distance(word, name); d < least) best = name, least = d;
  }
  return begun == 1 ? longer : best;
}

// "asperity-contact and asperity-stress"; of many, three.
std::string in_words(std::string_view tools) {
  constexpr std::size_t few = 3;
  const std::vector<std::string_view> names = words_of(tools);
  const std::size_t shown = names.size() > few + 1 ? few : names.size();
  std::string out;
  for (std::size_t i = 0; i < shown; ++i)
    out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + ("asperity-" + std::string(names[i]));
  return shown == names.size() ? out : out + " and " + std::to_string(names.size() - shown) + " other tools";
}

std::string hint(const CLI::App& app, const std::string& option) {
  if (app.get_name() == umbrella.tool) return ": the options of a tool follow its name";
  std::string elsewhere;  // the tools of all its rows
  for (const Entry& entry : entries)
    if (entry.option == option) elsewhere += (elsewhere.empty() ? "" : " ") + std::string(entry.tools);
  const std::string near = nearest(app, option);
  if (!elsewhere.empty()) return ": it belongs to " + in_words(elsewhere);
  return near.empty() ? "" : ": did you mean " + near + "?";
}

}  // namespace

std::string unknown_option(const CLI::App& app, const std::string& option) {
  const std::string dashed = "--" + option.substr(std::min(option.find_first_not_of('-'), option.size()));
  return "there is no option " + option + hint(app, dashed.substr(0, dashed.find('=')));
}

std::string nearest_tool(const std::string& word) {
  std::string_view best;
  std::size_t least = word.size() / 3 + 2;
  for (const Summary& s : toolbox) {
    const std::string_view name = s.tool.substr(s.tool.find('-') + 1);
    if (const std::size_t d = distance(word, name); d < least) best = name, least = d;
  }
  return best.empty() ? "" : ": did you mean " + std::string(best) + "?";
}

bool is_option(const std::string& name) {
  return std::ranges::find(entries, name, &Entry::option) != std::end(entries);
}

std::string tool_with(const std::string& option) {
  std::string_view first;
  for (const Entry& e : entries) {
    if (e.option != option) continue;
    const std::vector<std::string_view> tools = words_of(e.tools);
    for (const std::string_view tool : {"convert", "filter"})
      if (first.empty() && std::ranges::find(tools, tool) != tools.end()) first = tool;
  }
  return first.empty() ? "" : fmt::format("; asperity-{} has {}", first, option);
}

std::string in_words(const CLI::Error& error) {
  std::string what = error.what();
  const auto replace = [&](const std::string& from, const std::string& by) {
    if (const std::size_t at = what.find(from); at != what.npos) what.replace(at, from.size(), by);
  };
  replace(" requires ", " needs ");
  replace(" excludes ", " cannot be combined with ");
  const std::size_t end = what.find(": ");
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr || end == what.npos) return what;
  const bool repeated = what.find("At Most") != what.npos;
  return what.substr(0, end) + (repeated ? " is given more than once" : " needs a value");
}

std::string in_words(const CLI::App& app, const CLI::ConfigError& error) {
  const std::string what = error.what(), unknown = "INI was not able to parse ",
                    shut = ": This option is not allowed in a configuration file";
  const std::string key = what.substr(0, what.find(shut));
  const CLI::Option* option = key == what ? nullptr : app.get_option_no_throw("--" + key);
  if (option && option->get_items_expected_max() > 1)  // Tool::step
    return key + ": is a step, and a file has no order: write steps = \"--" + key +
           " ...\" with all of them, in theirs";
  return what.starts_with(unknown) ? unknown_option(app, what.substr(unknown.size())) : what;
}

}  // namespace asperity::cli
