#include "tools/cli/tool.hpp"

#include <csignal>
#include <fcntl.h>
#include <new>
#include <unistd.h>

#include <gsl/gsl_errno.h>

#include "dataset/netcdf.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/sandbox.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

// Opens /dev/null on closed standard streams, so that no data file gets their descriptor and our messages.
void keep_standard_streams() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(fd, F_GETFD) < 0)
      static_cast<void>(::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

}  // namespace

Tool::Tool(const std::string& name, const std::string& description)
    : Options(name, description),
      Messages(name, *this),
      RunSettings(*this, *this),
      Datasets(*this, *this, *this) {
  exit_status(done, "done");
  exit_status(runtime_error, "input or output failed");
  exit_status(usage_error, "wrong usage");
  exit_status(not_converged, "not converged");
  exit_status(bad_data, "bad input data");
}

// Options of several tools come last in --help, in one order.
void Tool::declare_common() {
  declare_memory();
  declare_output();
  declare_seed();
  declare_threads();
  declare_history();
  if (computes()) {
    config();
    Messages::declare(*this);
    declare_progress();
    dump_config();
    flag("--time", time_, "Print time and peak memory on standard error at the end", "Common");
  }
  documents();
}

int Tool::fail(Exit code, const std::string& message) {
  last_words_ = name() + ": " + message;
  say(last_words_);
  return code;
}

int Tool::answer(int argc, char** argv, const std::function<int()>& body) try {
  join_ranks();
  declare_common();
  parse(argc, argv);
  refuse_copies();
  source_date();  // refused before the work, not after
  if (const std::string options = config_to_print(); !options.empty()) throw Printout{options};
  check_outputs();
  if (lacks_input())
    return fail(usage_error, "no input: pipe a dataset in or name a file (" + name() + " -h shows how)");
  return body();
} catch (const Printout& asked) {
  write_all("-", asked.text);
  return done;
}

int Tool::guarded(int argc, char** argv, const std::function<int()>& body) try {
  read_netcdf4_apart(&run_in_sandbox);
  gsl_set_error_handler_off();  // called for want of memory alone: a line in place of an abort
  return answer(argc, argv, body);
} catch (const CommandLineError& e) {
  return fail(usage_error, e.what());
} catch (const ParameterError& e) {
  return fail(usage_error, with_options(sentence(typed(e.name, e.what()), e.what()), *this));
} catch (const DataError& e) {
  return fail(bad_data, with_options(in_file(e), *this));
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
  if (time_) say(name() + ": " + usage_of_run(clock_.seconds()));
  return code;
}

}  // namespace asperity::cli
