#include "cli/stream.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace asperity::cli {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// A file descriptor; closing is part of writing and is checked by close().
class Descriptor {
 public:
  Descriptor(int fd, std::string name, bool owned) : fd_(fd), name_(std::move(name)), owned_(owned) {
    if (fd_ < 0) fail(name_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (owned_ && fd_ >= 0) ::close(fd_);
  }

  std::string read() const {
    constexpr std::size_t chunk = 1 << 20;
    struct stat status {};
    std::string bytes;
    if (::fstat(fd_, &status) == 0 && S_ISREG(status.st_mode))
      bytes.reserve(static_cast<std::size_t>(status.st_size) + 1);
    for (std::size_t size = 0;;) {
      bytes.resize(std::max(size + chunk, std::min(bytes.capacity(), 2 * size)));
      const ssize_t n = ::read(fd_, bytes.data() + size, bytes.size() - size);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail(name_);
      size += static_cast<std::size_t>(n);
      if (n == 0) {
        bytes.resize(size);
        return bytes;
      }
    }
  }

  void write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t n = ::write(fd_, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail(name_);
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
  }

  void close() {
    const int fd = std::exchange(fd_, -1);
    if (::close(fd) != 0) fail(name_);
  }

 private:
  int fd_;
  std::string name_;
  bool owned_;
};

// Where a file of this name is to be replaced by renaming: at the end of its symbolic links. Nothing for devices, pipes
// and other names of open files, which are written as they are.
std::optional<std::string> replaceable(const std::string& name) {
  namespace fs = std::filesystem;
  if (name.starts_with("/dev/") || name.starts_with("/proc/")) return std::nullopt;
  fs::path target = name;
  for (int links = 0; fs::is_symlink(target) && links < 40; ++links)
    target = target.parent_path() / fs::read_symlink(target);
  const bool present = fs::exists(target);
  return !present || fs::is_regular_file(target) ? std::optional(target.string()) : std::nullopt;
}

void replace_file(const std::string& name, std::string_view bytes) {
  const std::string temporary = name + ".part" + std::to_string(::getpid());
  try {
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666), name, true);
    file.write(bytes);
    file.close();
    if (std::rename(temporary.c_str(), name.c_str()) != 0) fail(name);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
}

}  // namespace

std::string read_all(const std::string& name) {
  if (name == "-") return Descriptor(STDIN_FILENO, "standard input", false).read();
  return Descriptor(::open(name.c_str(), O_RDONLY | O_CLOEXEC), name, true).read();
}

void write_all(const std::string& name, std::string_view bytes) {
  if (name == "-") {
    Descriptor out(STDOUT_FILENO, "standard output", false);
    out.write(bytes);
    out.close();
  } else if (const auto target = replaceable(name)) {
    replace_file(*target, bytes);
  } else {
    Descriptor out(::open(name.c_str(), O_WRONLY | O_CLOEXEC), name, true);
    out.write(bytes);
    out.close();
  }
}

bool stdin_is_terminal() { return ::isatty(STDIN_FILENO) == 1; }
bool stdout_is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

}  // namespace asperity::cli
