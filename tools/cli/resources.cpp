#include "tools/cli/resources.hpp"

#include <algorithm>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

#include <fmt/format.h>

#include "tools/cli/quantity.hpp"

namespace asperity::cli {
namespace {

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

// The system's own count begins with the peak of the process that started this one, a notebook of some GB perhaps.
long peak_kibibytes(const rusage& own) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (long peak = 0; word == "VmHWM:" && status >> peak) return peak;
  return own.ru_maxrss;
}

}  // namespace

std::size_t half_of_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages < 1 || page < 1) return std::size_t{1} << 30;
  return static_cast<std::size_t>(pages) / 2 * static_cast<std::size_t>(page);
}

std::string usage_of_run(double wall_seconds) {
  rusage own{}, children{};
  getrusage(RUSAGE_SELF, &own);
  getrusage(RUSAGE_CHILDREN, &children);
  const double user = seconds(own.ru_utime) + seconds(children.ru_utime);
  const double system = seconds(own.ru_stime) + seconds(children.ru_stime);
  const auto kibibytes = static_cast<std::size_t>(std::max(peak_kibibytes(own), children.ru_maxrss));
  return fmt::format("{:.3g} s, CPU {:.3g} s ({:.3g} s user, {:.3g} s system), peak memory {}", wall_seconds,
                     user + system, user, system, format_bytes(1024 * kibibytes));
}

}  // namespace asperity::cli
