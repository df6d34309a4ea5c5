#include "tools/cli/stream.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/error.hpp"
#include "core/launch.hpp"
#include "core/os.hpp"
#include "core/words.hpp"
#include "formats/gzip.hpp"
#include "tools/cli/output_name.hpp"

namespace asperity::cli {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// Closes a file that was opened here, no standard stream.
struct Closing {
  int fd;
  ~Closing() {
    if (fd > STDERR_FILENO) ::close(fd);
  }
};

// All of the bytes; `put` writes some of those that are left, as write() does.
template <class Put>
void put_all(std::string_view bytes, const std::string& name, const Put& put) {
  while (!bytes.empty()) {
    const ssize_t n = put(bytes);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(name);
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

// What a new file gets of the one that it replaces: its mode, and its owner and group as far as possible.
// What a group was allowed is not passed on to another one.
void keep_access(int fd, const struct stat& former) {
  mode_t mode = former.st_mode & 0777;
  if (::fchown(fd, former.st_uid, former.st_gid) != 0 &&
      ::fchown(fd, static_cast<uid_t>(-1), former.st_gid) != 0)
    mode &= 0707 | (mode & 07) << 3;
  ::fchmod(fd, mode);  // not everywhere are there modes
}

std::string random_word() {
  char digits[9] = {};
  std::snprintf(digits, sizeof digits, "%08x", std::random_device()());
  return digits;
}

}  // namespace

Bytes read_to_end(int fd, const std::string& name, const MemoryBound& memory) {
  constexpr std::size_t chunk = 1 << 20;
  struct stat status {};
  const bool regular = ::fstat(fd, &status) == 0 && S_ISREG(status.st_mode);
  if (!regular) os::widen_pipe(fd, static_cast<int>(chunk));
  const std::size_t whole = regular ? static_cast<std::size_t>(status.st_size) + 1 : 0;
  memory.require(static_cast<double>(regular ? status.st_size : 0), name);
  for (Bytes bytes;;) {
    memory.require(static_cast<double>(bytes.size()), name);
    const std::size_t step =
        regular ? std::max<std::size_t>(whole - std::min(whole, bytes.size()), 1) : chunk;
    const ssize_t n = ::read(fd, bytes.room(step), step);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(name);
    if (n == 0) return bytes;
    bytes.add(static_cast<std::size_t>(n));
  }
}

std::string first_bytes(const std::string& name) {
  std::string out(8, '\0');
  std::error_code none;
  if (name == "-" || !std::filesystem::is_regular_file(name, none)) return "";
  std::ifstream in(name, std::ios::binary);
  in.read(out.data(), static_cast<std::streamsize>(out.size()));
  out.resize(static_cast<std::size_t>(in.gcount()));
  return out;
}

void write_to(int fd, std::string_view bytes, const std::string& name) {
  put_all(bytes, name, [&](std::string_view rest) { return ::write(fd, rest.data(), rest.size()); });
}

Bytes read_all(const std::string& name, const MemoryBound& memory) {
  const bool piped = name == "-";
  const std::string words = piped ? "standard input" : name;
  const Closing file{piped ? STDIN_FILENO : ::open(name.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.fd < 0) fail(words);
  Bytes bytes = read_to_end(file.fd, words, memory);
  if (bytes.size() == 0)
    throw DataError(words, piped ? "it is empty: the tool before this one wrote nothing" : "it is empty");
  return gunzipped(std::move(bytes), memory);
}

// ---- out ----

void require_writable(const std::string& name) {
  const OutputTarget target = output_target(name);
  if (target.kind == OutputTarget::Kind::descriptor) return;
  const auto folder = std::filesystem::path(target.path).parent_path();
  struct stat status {};
  const bool present = ::stat(target.path.c_str(), &status) == 0;
  if (present && S_ISDIR(status.st_mode)) errno = EISDIR;
  if ((present &&
       (S_ISDIR(status.st_mode) || ::faccessat(AT_FDCWD, target.path.c_str(), W_OK, AT_EACCESS) != 0)) ||
      (target.kind == OutputTarget::Kind::file &&
       ::faccessat(AT_FDCWD, folder.empty() ? "." : folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0))
    fail(name);
}

namespace {

// What a handler may read at any time.
std::array<std::atomic<const char*>, 256> names{};
static_assert(std::atomic<const char*>::is_always_lock_free);

extern "C" void remove_names_and_end(int signal) {
  for (const auto& name : names)
    if (const char* path = name.load()) ::unlink(path);
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // blocked until this handler returns
}

void handle_signals() {
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU, SIGXFSZ}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
    action.sa_handler = &remove_names_and_end;
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace

TemporaryName::TemporaryName(std::string path) : path_(std::move(path)) {
  static const bool handled = (handle_signals(), true);
  static_cast<void>(handled);
  for (auto& name : names) {
    const char* nothing = nullptr;
    if (name.compare_exchange_strong(nothing, path_.c_str())) return;
  }
  throw std::length_error("too many files are being written");
}

TemporaryName::~TemporaryName() {
  if (known_) ::unlink(path());
  forget();
}

bool TemporaryName::replace(const std::string& target) {
  if (std::rename(path(), target.c_str()) != 0) return false;
  forget();
  return true;
}

void TemporaryName::forget() {
  if (!std::exchange(known_, false)) return;
  for (auto& name : names) {
    const char* mine = path();
    if (name.compare_exchange_strong(mine, nullptr)) return;
  }
}

OutputFile::OutputFile(std::string name) : name_(std::move(name)) {
  const OutputTarget target = output_target(name_);
  if (name_ == "-") {
    name_ = "standard output";
    fd_ = STDOUT_FILENO;
  } else if (target.kind == OutputTarget::Kind::descriptor) {
    fd_ = ::fcntl(target.descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  } else if (target.kind == OutputTarget::Kind::file) {
    target_ = target.path;
    open_replacement();
  } else {
    fd_ = ::open(name_.c_str(), O_WRONLY | O_CLOEXEC);
  }
  if (fd_ < 0) fail(name_);
  struct stat status {};
  rewritable_ = ::fstat(fd_, &status) == 0 && S_ISREG(status.st_mode) && ::lseek(fd_, 0, SEEK_CUR) == 0 &&
                (::fcntl(fd_, F_GETFL) & O_APPEND) == 0;
}

// What its user may not write is not replaced. Until it has the former's mode, a file is its owner's alone.
void OutputFile::open_replacement() {
  struct stat former {};
  const bool present = ::stat(target_.c_str(), &former) == 0;
  if (present && ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) fail(name_);
  const mode_t mode = present ? 0600 : 0666;
  const auto folder = std::filesystem::path(target_).parent_path();
  fd_ = os::unnamed_file(folder.empty() ? "." : folder.string(), mode);
  if (fd_ < 0)
    make_temporary([&](const char* path) {
      fd_ = ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
      return fd_ >= 0;
    });
  if (fd_ >= 0 && present) keep_access(fd_, former);
}

// Under a name that nobody can foresee; `make` fails with EEXIST where it is taken all the same.
template <class Make>
bool OutputFile::make_temporary(const Make& make) {
  for (int tries = 0; tries < 100; ++tries) {
    temporary_.emplace(target_ + ".part" + random_word());
    if (make(temporary_->path())) return true;
    if (errno != EEXIST) return false;
    temporary_->forget();
  }
  return false;
}

OutputFile::~OutputFile() {
  if (fd_ > STDERR_FILENO) ::close(fd_);
}

void OutputFile::write(std::string_view bytes) { write_to(fd_, bytes, name_); }

void OutputFile::rewrite(std::string_view bytes) {
  const off_t end = ::lseek(fd_, 0, SEEK_CUR);
  if (end < 0 || ::lseek(fd_, 0, SEEK_SET) != 0) fail(name_);
  write(bytes);
  if (::lseek(fd_, end, SEEK_SET) != end) fail(name_);
}

void OutputFile::write_at(std::string_view bytes, std::int64_t at) {
  put_all(bytes, name_, [&](std::string_view rest) {
    const auto place = at + (rest.data() - bytes.data());
    return ::pwrite(fd_, rest.data(), rest.size(), static_cast<off_t>(place));
  });
}

void OutputFile::close() {
  if (!target_.empty() && !temporary_) {
    if (!make_temporary([&](const char* path) { return os::give_name(fd_, path); })) fail(name_);
  }
  if (::close(std::exchange(fd_, -1)) != 0) fail(name_);
  if (temporary_ && !temporary_->replace(target_)) fail(name_);
}

void write_all(const std::string& name, std::string_view bytes) {
  OutputFile file(name);
  file.write(bytes);
  file.close();
}

// ---- names and terminals ----

namespace {

// The "%04d" of a pattern; empty without one.
std::string_view place_for_number(std::string_view pattern) {
  const std::size_t percent = pattern.find('%'), end = pattern.find('d', percent);
  if (percent == pattern.npos || end == pattern.npos) return {};
  const std::string_view width = pattern.substr(percent + 1, end - percent - 1);
  const bool good = width.size() <= 2 && width.find_first_not_of("0123456789") == width.npos;
  return good ? pattern.substr(percent, end - percent + 1) : std::string_view();
}

}  // namespace

bool has_place_for_number(const std::string& pattern) { return !place_for_number(pattern).empty(); }

std::string numbered(const std::string& option, const std::string& pattern, std::int64_t number) {
  const std::string_view place = place_for_number(pattern);
  if (place.empty())
    throw ParameterError(option, "'" + pattern + "' has no place for the number: write s_%04d.nc");
  const std::string digits = std::to_string(number);
  const auto least = to_number<std::size_t>(place.substr(1, place.size() - 2)).value_or(0);
  std::string out = pattern;
  return out.replace(static_cast<std::size_t>(place.data() - pattern.data()), place.size(),
                     std::string(least - std::min(least, digits.size()), '0') + digits);
}

void refuse_terminal(const std::string& output, const std::string& what, const std::string& hint) {
  if (output == "-" && stdout_is_terminal())
    throw ParameterError("output",
                         what + " cannot be shown on a terminal: use a pipe or give -o FILE" + hint);
}

bool stdin_is_device() {
  struct stat status {};
  return ::fstat(STDIN_FILENO, &status) == 0 && S_ISCHR(status.st_mode);
}
bool stdin_is_terminal() { return ::isatty(STDIN_FILENO) == 1; }
// A launcher has terminals of its own, wherever its output goes.
bool stdout_is_terminal() { return ranks_started() == 1 && ::isatty(STDOUT_FILENO) == 1; }
bool stderr_is_terminal() { return ranks_started() == 1 && ::isatty(STDERR_FILENO) == 1; }

std::size_t columns_of(int fd, std::size_t most) {
  winsize size{};
  const bool known = ::ioctl(fd, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? std::clamp<std::size_t>(size.ws_col, 40, most) : 80;
}

}  // namespace asperity::cli
