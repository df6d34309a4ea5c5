#include "tools/cli/tool.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <random>
#include <unistd.h>
#include <utility>

#include <CLI/CLI.hpp>
#include <gsl/gsl_errno.h>

#include "core/launch.hpp"
#include "core/parallel.hpp"
#include "core/words.hpp"
#include "dataset/catalogue.hpp"
#include "dataset/netcdf.hpp"
#include "tools/cli/config.hpp"
#include "tools/cli/hints.hpp"
#include "tools/cli/ordered_work.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/sandbox.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

// The number of a standard stream that its parent closed goes to no other file, into which messages would go.
void keep_standard_streams() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(fd, F_GETFD) < 0)
      static_cast<void>(::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

// As early as can be: of a tool that writes either, what neither may be written into.
void check_output_name(const std::string& name, bool dataset, bool table, bool json) {
  if (!table) return check_dataset_name(name);
  if (!dataset || !names_dataset(extension_of(name))) check_table_name(name, json);
}

// "--load is required", but "--load: '5' has no unit".
std::string sentence(const std::string& subject, const std::string& text) {
  constexpr std::string_view verbs[] = {"is ",  "are ",     "needs ", "cannot ", "must ",
                                        "has ", "belongs ", "does ",  "applies "};
  const bool verb = std::ranges::any_of(verbs, [&](std::string_view v) { return text.starts_with(v); });
  return subject + (verb ? " " : ": ") + text;
}

// The library names parameters between ` and `; here they are options, perhaps of another tool.
std::string with_options(std::string text, const CLI::App& app) {
  std::string elsewhere;
  for (std::size_t at = 0; (at = text.find('`', at)) != text.npos;) {
    const std::size_t end = text.find('`', at + 1);
    if (end == text.npos) break;
    const std::string option = "--" + text.substr(at + 1, end - at - 1);
    if (!is_option(option)) {
      at = end;
      continue;
    }
    text.replace(at, end - at + 1, option);
    at += option.size();
    if (elsewhere.empty()) elsewhere = tool_with(app, option);
  }
  return text + elsewhere;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// What two warnings of one kind have in common.
std::string without_numbers(const std::string& text) {
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    const bool exponent = c == 'e' && k > 0 && is_digit(text[k - 1]) && k + 1 < text.size() &&
                          (is_digit(text[k + 1]) || text[k + 1] == '-' || text[k + 1] == '+');
    if (!is_digit(c) && c != '.' && c != '-' && c != '+' && !exponent) out += c;
  }
  return out;
}

// Copies would write one file.
std::string copies_refused() {
  return std::to_string(ranks_started()) +
         " copies were started by mpirun or its like, but this tool runs as one process: start it by itself, "
         "with threads, or several surfaces as an array job, a process each; for separate runs under the "
         "launcher unset OMPI_COMM_WORLD_SIZE and PMI_SIZE";
}

}  // namespace

Tool::~Tool() = default;

// Ranks on one machine share its cores.
int Tool::thread_count() const {
  return threads_ == 0 && ranks().count() > 1 ? std::max(1, resolve_threads(0) / ranks_on_machine())
                                              : resolve_threads(threads_);
}

bool Tool::shows_progress() const {
  if (works_alone() || quiet_ || verbose_ || progress_ == "never") return false;
  return progress_ == "always" || stderr_is_terminal();
}

std::uint64_t Tool::seed_value() {
  if (!seed_) {
    std::random_device entropy;
    seed_ = (static_cast<std::uint64_t>(entropy()) << 21) ^ entropy();
  }
  return *seed_;
}

// A line on standard error, in place of one of progress, whatever the texts of files in it.
void Tool::say(const std::string& line) { Progress::say(one_line(line)); }

int Tool::fail(Exit code, const std::string& message) const {
  last_words_ = name_ + ": " + message;
  say(last_words_);
  return code;
}

// "rough.nc: heights: ...", "map.txt: line 3 ..."
std::string Tool::in_file(const DataError& error) const {
  std::string line = sentence(error.name, error.what());
  const KnownResult* result = result_of_variable(error.name);
  const bool missing = dynamic_cast<const MissingVariable*>(&error) != nullptr;
  if (missing && (error.name == "x" || error.name == "y")) line += ". `size` gives a bare array its axes";
  if (missing && result != nullptr && result->name != "heights")
    line += ". asperity-" + std::string(result->prefix.substr(0, result->prefix.find('_'))) + " computes it";
  const bool named = reading_.empty() || reading_ == "-" || line.starts_with(reading_ + ": ");
  return named ? line : reading_ + ": " + line;
}

int Tool::answer(int argc, char** argv, const std::function<int()>& body) try {
  if (shares_ranks_) ranks_ = &launched();
  parse(argc, argv);
  if (ranks_started() > 1 && !shares_ranks_) return fail(usage_error, copies_refused());
  source_date();  // refused before the work, not after
  if (dump_config_) throw CLI::Success(config_text(*app_), CLI::ExitCodes::Success);
  if (writes_dataset_ && !writes_any_ && !writes_table_) refuse_terminal(output_);
  if ((writes_dataset_ || writes_table_) && !writes_any_)
    check_output_name(output_, writes_dataset_, writes_table_, json_);
  if (!report_.empty()) check_table_name(report_, true, "report");
  result_is_dataset_ = writes_dataset_ && !writes_table_;
  if (writes_dataset_ || writes_table_) writes("output", output_);
  if (!report_.empty()) writes("report", report_);
  if (!config_file().empty()) reads(config_file());
  reading_.clear();
  if (takes_input_ && input_ == "-" && stdin_is_terminal())
    return fail(usage_error, "no input: pipe a dataset in or name a file (" + name_ + " -h shows how)");
  return body();
} catch (const CLI::Success& told) {  // by an option that asks for a text and no run
  write_all("-", told.what());
  return done;
}

int Tool::guarded(int argc, char** argv, const std::function<int()>& body) try {
  read_netcdf4_apart(&run_in_sandbox);
  gsl_set_error_handler_off();  // called for want of memory alone: a line in place of an abort
  return answer(argc, argv, body);
} catch (const CLI::ConfigError& e) {
  return fail(usage_error, config_file() + ": " + in_words(*app_, e));
} catch (const CLI::FileError&) {
  return fail(usage_error,
              origin("config") + ": '" + config_file() + "' cannot be read: name an existing file");
} catch (const CLI::Error& e) {
  return fail(usage_error, app_->remaining().empty() ? in_words(e) : unexpected());
} catch (const ParameterError& e) {
  return fail(usage_error, with_options(sentence(typed(e.name, e.what()), e.what()), *app_));
} catch (const DataError& e) {
  return fail(bad_data, with_options(in_file(e), *app_));
} catch (const std::bad_alloc&) {
  return fail(runtime_error, "out of memory");
} catch (const std::exception& e) {
  return fail(runtime_error, e.what());
}

int Tool::run(int argc, char** argv, const std::function<int()>& body) {
  keep_standard_streams();
  // A write that is too large then fails and says so. An ignored signal would be inherited by other programs.
  std::signal(SIGXFSZ, [](int) {});
  const int code = guarded(argc, argv, body);
  ranks().end(code, last_words_);
  if (time_) say(name_ + ": " + usage_of_run(clock_.seconds()));
  return code;
}

bool Tool::output_is_terminal() const { return output_ == "-" && stdout_is_terminal(); }

std::optional<std::string> Tool::Repeated::first(const std::string& surface, const std::string& text) {
  const bool named = text.starts_with(surface + ": ");
  const std::string own = named ? text.substr(surface.size() + 2) : text, words = without_numbers(own);
  if (!seen_.insert(surface + ": " + own).second) return std::nullopt;
  const auto known = std::ranges::find(kinds_, words, &Kind::words);
  if (known == kinds_.end()) {
    kinds_.push_back({words});
    return surface + ": " + own;
  }
  ++known->more;
  known->surface = surface;
  known->text = own;
  return std::nullopt;
}

std::vector<std::string> Tool::Repeated::rest() {
  std::vector<std::string> out;
  for (const auto& [words, more, surface, text] : std::exchange(kinds_, {}))
    if (more == 1)
      out.push_back(surface + ": " + text);
    else if (more > 1)
      out.push_back(counted(more, "more surface") + ", up to " + surface + ": " + text);
  return out;
}

void Tool::warn(const std::string& text) const {
  in_order([this, text] {
    const std::optional<std::string> line = subject_.empty() ? text : warnings_.first(subject_, text);
    if (line) say(name_ + ": warning: " + with_options(*line, *app_));
  });
}

void Tool::note(const std::string& text) const {
  in_order([this, text] {
    const std::optional<std::string> line = subject_.empty() ? text : notes_.first(subject_, text);
    if (line && !quiet_) say(name_ + ": " + with_options(*line, *app_));
  });
}

void Tool::about(const std::string& surface) const {
  in_order([this, surface] {
    subject_ = surface;
    if (!surface.empty()) return;
    for (const std::string& line : warnings_.rest()) warn(line);
    for (const std::string& line : notes_.rest()) note(line);
  });
}

void Tool::detail(const std::string& text) const {
  if (verbose_) in_order([text] { say(text); });
}

}  // namespace asperity::cli
