#include "tools/cli/run_settings.hpp"

#include <algorithm>
#include <random>
#include <unistd.h>

#include "core/launch.hpp"
#include "core/parallel.hpp"
#include "core/words.hpp"
#include "tools/cli/messages.hpp"
#include "tools/cli/options.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

// The default of --memory [byte]: half of the machine's; 1 GiB where the system does not say.
std::size_t half_of_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages < 1 || page < 1) return std::size_t{1} << 30;
  return static_cast<std::size_t>(pages) / 2 * static_cast<std::size_t>(page);
}

}  // namespace

RunSettings::RunSettings(Options& options, const Messages& messages)
    : options_(options), messages_(messages), memory_(half_of_memory()) {}

void RunSettings::memory(const std::string& text) {
  const std::string more =
      ". A larger input is refused; 16 MiB are always allowed. Default: half of the machine's memory";
  options_
      .parsed("--memory", "SIZE", text + more, "Resources", format_bytes(memory_), into(memory_, parse_bytes))
      .without_default();
}

void RunSettings::declare_seed() {
  if (!seeded_) return;
  options_.parsed(
      "--seed", "N",
      "Seed of the random numbers, 0 to 2^53; without it a random seed. The seed is always recorded",
      "Common", "", [this](const std::string& key, const std::string& given) {
        seed_ = to_number<std::uint64_t>(given);
        if (!seed_ || *seed_ > std::uint64_t{1} << 53)
          refuse(key, given, "is not a whole number from 0 to 2^53 = 9007199254740992");
      });
  options_.integer("--stream", stream_, 0,
                   "Number of the ensemble; streams of one seed never share a surface, so that parallel jobs "
                   "may share the seed and differ in the stream",
                   "Common");
}

void RunSettings::declare_threads() {
  if (threaded_)
    options_.integer("--threads", threads_, {0, 4096, "more than a machine has"},
                     "Number of threads; 0: all of the machine. They share the work on a large surface; of "
                     "several small ones each takes one",
                     "Common");
}

void RunSettings::declare_progress() {
  options_.choice("--progress", progress_, {"auto", "always", "never"},
                  "Show the progress of a long computation on standard error; auto: on a terminal, without "
                  "--quiet and --verbose",
                  "Common");
}

void RunSettings::join_ranks() {
  if (shares_ranks_) ranks_ = &launched();
}

// Copies would write one file.
void RunSettings::refuse_copies() const {
  if (ranks_started() == 1 || shares_ranks_) return;
  throw CommandLineError(
      std::to_string(ranks_started()) +
      " copies were started by mpirun or its like, but this tool runs as one process: start it by itself, "
      "with threads, or several surfaces as an array job, a process each; for separate runs under the "
      "launcher unset OMPI_COMM_WORLD_SIZE and PMI_SIZE");
}

// Ranks on one machine share its cores.
int RunSettings::thread_count() const {
  return threads_ == 0 && ranks().count() > 1 ? std::max(1, resolve_threads(0) / ranks_on_machine())
                                              : resolve_threads(threads_);
}

MemoryBound RunSettings::memory_bound(std::size_t held) const {
  constexpr std::size_t always_read = std::size_t{16} << 20;  // little compared with the program's own
  return {std::max(memory_, always_read), held};
}

void RunSettings::require_memory(double bytes, const std::string& option, const std::string& what,
                                 const std::string& instead) const {
  const std::size_t bound = memory_bound().bytes;
  if (!(bytes > static_cast<double>(bound))) return;
  const auto needed = static_cast<std::size_t>(std::min(bytes, 0x1p63));
  throw UsageError(option, what + " needs some " + format_bytes(needed) + ", more than the " +
                               format_bytes(bound) + " that --memory allows" + instead);
}

std::uint64_t RunSettings::seed_value() {
  if (!seed_) {
    std::random_device entropy;
    seed_ = (static_cast<std::uint64_t>(entropy()) << 21) ^ entropy();
  }
  return *seed_;
}

bool RunSettings::shows_progress() const {
  if (works_alone() || messages_.quiet() || messages_.verbose() || progress_ == "never") return false;
  return progress_ == "always" || stderr_is_terminal();
}

}  // namespace asperity::cli
