// What the system does. tests/portable runs these, too, with what stands for Linux on other systems.
#include "core/os.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/mman.h>
#include <unistd.h>

#include "support.hpp"

using namespace asperity;

namespace {

bool is_portable() { return std::getenv("ASPERITY_IS_PORTABLE") != nullptr; }

bool is_zero(const char* bytes, std::size_t count) {
  return std::all_of(bytes, bytes + count, [](char c) { return c == 0; });
}

}  // namespace

TEST_CASE("the functions of Linux are those of Linux, and the portable ones are what is tested as such",
          "[os][contract]") {
  CHECK(std::string(os::descriptor_folder()) == (is_portable() ? "/dev/fd" : "/proc/self/fd"));
  CHECK((os::address_space() > 0) == !is_portable());
  CHECK((os::peak_kibibytes() > 0) == !is_portable());
  CHECK(os::own_program() == (is_portable() ? "" : std::filesystem::canonical("/proc/self/exe").string()));
}

// 64 MiB to 3 GiB, of which three pages are ever touched.
TEST_CASE("memory that grows keeps its bytes, and the new ones are zero", "[os][exact]") {
  const std::size_t small = std::size_t{64} << 20, large = std::size_t{3} << 30;
  char* const first = static_cast<char*>(os::grown(nullptr, 0, small));
  CHECK(is_zero(first, 4096));
  std::strcpy(first, "rough");
  first[small - 1] = 'x';
  char* const grown = static_cast<char*>(os::grown(first, small, large));
  CHECK(std::string(grown) == "rough");
  CHECK(grown[small - 1] == 'x');
  CHECK(is_zero(grown + small, 4096));
  CHECK(is_zero(grown + large - 4096, 4096));
  ::munmap(grown, large);
  CHECK_THROWS_AS(os::grown(nullptr, 0, std::size_t{1} << 62), std::bad_alloc);
}

TEST_CASE("a file without a name is read by its number, and can be given a name where there are such files",
          "[os][contract]") {
  const int memory = os::file_in_memory();
  REQUIRE(memory >= 0);
  CHECK(::write(memory, "bytes", 5) == 5);
  std::string read;
  std::ifstream(os::descriptor_path(memory)) >> read;
  CHECK(read == "bytes");
  ::close(memory);
  const std::filesystem::path folder = std::filesystem::temp_directory_path(),
                              name = folder / ("asperity_os_" + std::to_string(::getpid()));
  const int unnamed = os::unnamed_file(folder, 0600);
  CHECK((unnamed >= 0) == !is_portable());
  CHECK(os::give_name(unnamed, name.c_str()) == !is_portable());
  CHECK(std::filesystem::exists(name) == !is_portable());
  std::filesystem::remove(name);
  if (unnamed >= 0) ::close(unnamed);
}

TEST_CASE("a link to an open file is told from a link to a name", "[os][contract]") {
  int ends[2] = {-1, -1};
  os::open_pipe(ends);
  REQUIRE(ends[0] >= 0);
  CHECK((::fcntl(ends[1], F_GETFD) & FD_CLOEXEC) != 0);
  CHECK(os::is_open_file(os::descriptor_path(ends[1])));
  const std::filesystem::path link =
      std::filesystem::temp_directory_path() / ("asperity_link_" + std::to_string(::getpid()));
  std::filesystem::create_symlink("/dev/null", link);
  CHECK_FALSE(os::is_open_file(link));
  std::filesystem::remove(link);
  os::close_from(ends[0]);
  CHECK(::fcntl(ends[1], F_GETFD) < 0);
}
