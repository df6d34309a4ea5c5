#include "cli/stream.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <new>
#include <optional>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "grid/error.hpp"

namespace asperity::cli {
namespace {

// Where a file without a name can be found to be given one.
constexpr const char* own_descriptors = "/proc/self/fd";

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

  Bytes read(const MemoryBound& memory) const {
    constexpr std::size_t chunk = 1 << 20;
    struct stat status {};
    const bool regular = ::fstat(fd_, &status) == 0 && S_ISREG(status.st_mode);
    if (!regular) ::fcntl(fd_, F_SETPIPE_SZ, static_cast<int>(chunk));  // where it is a pipe
    const std::size_t whole = regular ? static_cast<std::size_t>(status.st_size) + 1 : 0;
    memory.require(static_cast<double>(regular ? status.st_size : 0), name_);
    for (Bytes bytes;;) {
      memory.require(static_cast<double>(bytes.size()), name_);
      const std::size_t step =
          regular ? std::max<std::size_t>(whole - std::min(whole, bytes.size()), 1) : chunk;
      const ssize_t n = ::read(fd_, bytes.room(step), step);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail(name_);
      if (n == 0) return bytes;
      bytes.add(static_cast<std::size_t>(n));
    }
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

}  // namespace

Bytes::~Bytes() {
  if (data_) ::munmap(data_, capacity_);
}

Bytes::Bytes(Bytes&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)),
      capacity_(std::exchange(other.capacity_, 0)) {}

char* Bytes::room(std::size_t more) {
  constexpr std::size_t least = std::size_t{64} << 20;
  if (size_ + more > capacity_) grow(std::max({size_ + more, 2 * capacity_, least}));
  return data_ + size_;
}

// Address space alone: what is not touched takes no memory.
void Bytes::grow(std::size_t capacity) {
  void* grown = data_ ? ::mremap(data_, capacity_, capacity, MREMAP_MAYMOVE)
                      : ::mmap(nullptr, capacity, PROT_READ | PROT_WRITE,
                               MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (grown == MAP_FAILED) throw std::bad_alloc();
  data_ = static_cast<char*>(grown);
  capacity_ = capacity;
  ::madvise(data_, capacity_, MADV_HUGEPAGE);
}

Bytes read_all(const std::string& name, const MemoryBound& memory) {
  if (name == "-") return Descriptor(STDIN_FILENO, "standard input", false).read(memory);
  return Descriptor(::open(name.c_str(), O_RDONLY | O_CLOEXEC), name, true).read(memory);
}

OutputFile::OutputFile(std::string name) : name_(std::move(name)) {
  if (name_ == "-") {
    name_ = "standard output";
    fd_ = STDOUT_FILENO;
  } else if (const auto target = replaceable(name_)) {
    target_ = *target;
    open_replacement();
  } else {
    fd_ = ::open(name_.c_str(), O_WRONLY | O_CLOEXEC);
  }
  if (fd_ < 0) fail(name_);
  struct stat status {};
  rewritable_ = ::fstat(fd_, &status) == 0 && S_ISREG(status.st_mode) && ::lseek(fd_, 0, SEEK_CUR) == 0 &&
                (::fcntl(fd_, F_GETFL) & O_APPEND) == 0;
}

std::string OutputFile::temporary_path() const { return target_ + ".part" + std::to_string(::getpid()); }

void OutputFile::open_replacement() {
  const auto folder = std::filesystem::path(target_).parent_path();
  if (::access(own_descriptors, X_OK) == 0)
    fd_ = ::open(folder.empty() ? "." : folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
  if (fd_ >= 0) return;
  temporary_.emplace(temporary_path());
  fd_ = ::open(temporary_->path(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

OutputFile::~OutputFile() {
  if (fd_ > STDOUT_FILENO) ::close(fd_);
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(name_);
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

void OutputFile::rewrite(std::string_view bytes) {
  const off_t end = ::lseek(fd_, 0, SEEK_CUR);
  if (end < 0 || ::lseek(fd_, 0, SEEK_SET) != 0) fail(name_);
  write(bytes);
  if (::lseek(fd_, end, SEEK_SET) != end) fail(name_);
}

void OutputFile::write_at(std::string_view bytes, std::int64_t at) {
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(fd_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(name_);
    bytes.remove_prefix(static_cast<std::size_t>(n));
    at += n;
  }
}

void OutputFile::close() {
  if (!target_.empty() && !temporary_) {
    temporary_.emplace(temporary_path());
    ::unlink(temporary_->path());  // of a process that had this number and died here
    const std::string own = std::string(own_descriptors) + "/" + std::to_string(fd_);
    if (::linkat(AT_FDCWD, own.c_str(), AT_FDCWD, temporary_->path(), AT_SYMLINK_FOLLOW) != 0) fail(name_);
  }
  if (::close(std::exchange(fd_, -1)) != 0) fail(name_);
  if (temporary_ && !temporary_->replace(target_)) fail(name_);
}

void write_all(const std::string& name, std::string_view bytes) {
  OutputFile file(name);
  file.write(bytes);
  file.close();
}

std::string numbered(const std::string& option, const std::string& pattern, std::int64_t number) {
  const auto percent = pattern.find('%'), end = pattern.find('d', percent);
  const std::string width = percent < end ? pattern.substr(percent + 1, end - percent - 1) : "?";
  if (end == pattern.npos || width.find_first_not_of("0123456789") != width.npos || width.size() > 2)
    throw ParameterError(option, "'" + pattern + "' has no place for the number: write s_%04d.nc");
  std::string digits = std::to_string(number);
  const std::size_t least = width.empty() ? 0 : std::stoul(width);
  if (digits.size() < least) digits.insert(0, least - digits.size(), '0');
  return pattern.substr(0, percent) + digits + pattern.substr(end + 1);
}

bool stdin_is_terminal() { return ::isatty(STDIN_FILENO) == 1; }
bool stdout_is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }
bool stderr_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace asperity::cli
