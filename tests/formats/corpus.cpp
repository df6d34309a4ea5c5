// The files that fuzzing starts from, and those that it once found: hostile, cut short, lying, or plain.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "fuzz/reader.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

std::vector<std::string> names() {
  std::vector<std::string> out{"netcdf", "netcdf4"};
  for (const Format& format : formats()) out.emplace_back(format.name);
  return out;
}

std::string content(const std::filesystem::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

}  // namespace

TEST_CASE("every file of the corpus is read or refused, and there are some of both kinds for each format",
          "[formats][contract][slow]") {
  for (const std::string& name : names()) {
    CAPTURE(name);
    const std::filesystem::path folder = std::filesystem::path(ASPERITY_TEST_CORPUS) / name;
    REQUIRE(std::filesystem::is_directory(folder));
    std::size_t read = 0, refused = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      INFO(file.path().filename().string());
      bool could = false;
      CHECK_NOTHROW(could = reads(name, content(file.path())));
      ++(could ? read : refused);
    }
    CHECK(read > 0);
    CHECK(refused > 0);
  }
}
