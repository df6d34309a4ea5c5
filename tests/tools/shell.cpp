#include "tools/shell.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>

namespace asperity::test {
namespace {

// A folder that lives as long as the test process.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "asperity-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  std::filesystem::path path;
};

const std::filesystem::path& folder() {
  static const Folder only;
  return only.path;
}

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::string scratch(const std::string& name) { return folder() / name; }

Outcome shell(const std::string& line) {
  std::ofstream(scratch(".line")) << "set -o pipefail\n" << line << '\n';
  const std::string command =
      "cd " + folder().string() + " && PATH=" ASPERITY_BIN ":$PATH exec bash .line </dev/null >.out 2>.error";
  const int status = std::system(command.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, content(scratch(".out")), content(scratch(".error"))};
}

// std::time is that of the last tick, at most 10 ms ago.
void await_next_second() {
  using namespace std::chrono;
  std::this_thread::sleep_until(floor<seconds>(system_clock::now()) + 1010ms);
}

}  // namespace asperity::test
