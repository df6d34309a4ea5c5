#include "core/os.hpp"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <new>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#if defined(__linux__) && !defined(ASPERITY_PORTABLE)
#define ASPERITY_LINUX
#include <csignal>
#include <linux/magic.h>
#include <malloc.h>
#include <sys/prctl.h>
#include <sys/vfs.h>
#endif

namespace asperity::os {
namespace {

namespace fs = std::filesystem;

#ifdef ASPERITY_LINUX
constexpr const char* own_descriptors = "/proc/self/fd";
constexpr int without_reserve = MAP_NORESERVE;
#else
constexpr const char* own_descriptors = "/dev/fd";
constexpr int without_reserve = 0;
#endif

void* reserved(std::size_t bytes) {
  void* const out =
      ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | without_reserve, -1, 0);
  if (out == MAP_FAILED) throw std::bad_alloc();
  return out;
}

}  // namespace

const char* descriptor_folder() { return own_descriptors; }

std::string descriptor_path(int fd) { return own_descriptors + ("/" + std::to_string(fd)); }

#ifdef ASPERITY_LINUX

void prefer_large_pages(void* memory, std::size_t bytes) {
  constexpr std::size_t page = std::size_t{2} << 20;
  const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
  if (bytes < before + page) return;
  ::madvise(static_cast<char*>(memory) + before, (bytes - before) / page * page, MADV_HUGEPAGE);
}

void* grown(void* former, std::size_t size, std::size_t capacity) {
  if (!former) return reserved(capacity);
  void* const out = ::mremap(former, size, capacity, MREMAP_MAYMOVE);
  if (out == MAP_FAILED) throw std::bad_alloc();
  return out;
}

void return_freed_memory() {
#ifdef M_MMAP_THRESHOLD
  ::mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

// What getrusage() counts begins with the peak of the process that started this one, perhaps some GB.
long peak_kibibytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (long peak = 0; word == "VmHWM:" && status >> peak) return peak;
  return 0;
}

std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

bool is_open_file(const std::string& link) {
  const int fd = ::open(link.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC);
  struct statfs system {};
  const bool found = fd >= 0 && ::fstatfs(fd, &system) == 0 && system.f_type == PROC_SUPER_MAGIC;
  if (fd >= 0) ::close(fd);
  return found;
}

// Through the folder of open files it can be given a name.
int unnamed_file(const std::string& folder, unsigned mode) {
  if (::access(own_descriptors, X_OK) != 0) return -1;
  return ::open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, mode);
}

bool give_name(int fd, const char* path) {
  return ::linkat(AT_FDCWD, descriptor_path(fd).c_str(), AT_FDCWD, path, AT_SYMLINK_FOLLOW) == 0;
}

int file_in_memory() { return ::memfd_create("asperity", MFD_CLOEXEC); }

void open_pipe(int (&ends)[2]) {
  if (::pipe2(ends, O_CLOEXEC) != 0) ends[0] = ends[1] = -1;
}

void widen_pipe(int fd, int bytes) { ::fcntl(fd, F_SETPIPE_SZ, bytes); }

std::string own_program() {
  std::error_code none;
  return fs::read_symlink("/proc/self/exe", none);
}

void end_with_parent() { ::prctl(PR_SET_PDEATHSIG, SIGKILL); }

void close_from(int first) { ::close_range(static_cast<unsigned>(first), ~0U, 0); }

#else

void prefer_large_pages(void*, std::size_t) {}

void* grown(void* former, std::size_t size, std::size_t capacity) {
  void* const out = reserved(capacity);
  if (!former) return out;
  std::memcpy(out, former, size);
  ::munmap(former, size);
  return out;
}

void return_freed_memory() {}

long peak_kibibytes() { return 0; }

std::size_t address_space() { return 0; }

bool is_open_file(const std::string& link) {
  std::error_code none;
  return fs::equivalent(fs::path(link).parent_path(), own_descriptors, none);
}

int unnamed_file(const std::string&, unsigned) { return -1; }

bool give_name(int, const char*) { return false; }

int file_in_memory() {
  std::FILE* const file = std::tmpfile();
  if (!file) return -1;
  const int out = ::fcntl(::fileno(file), F_DUPFD_CLOEXEC, 0);
  std::fclose(file);
  return out;
}

void open_pipe(int (&ends)[2]) {
  if (::pipe(ends) != 0) ends[0] = ends[1] = -1;
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
}

void widen_pipe(int, int) {}

std::string own_program() { return {}; }

void end_with_parent() {}

void close_from(int first) {
  const long most = ::sysconf(_SC_OPEN_MAX);
  for (int fd = first; fd < most; ++fd) ::close(fd);
}

#endif

}  // namespace asperity::os
