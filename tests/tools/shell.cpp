#include "tools/shell.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
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

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream cells(line);
  for (std::string cell; std::getline(cells, cell, '\t');) out.push_back(cell);
  return out;
}

double number_in(const std::string& cell) {
  char* end = nullptr;
  const double number = std::strtod(cell.c_str(), &end);
  return end == cell.c_str() ? std::nan("") : number;
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

// "# load [N]\tapproach [m]\t…", and a line for each row.
Printed::Printed(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  std::vector<std::string> names = cells_of(line.substr(std::min<std::size_t>(2, line.size())));
  for (std::string& name : names) columns_[name = name.substr(0, name.find(' '))];
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = cells_of(line);
    rows.push_back(cells.at(0));
    for (std::size_t k = 0; k < names.size(); ++k)
      columns_[names[k]].push_back(k < cells.size() ? number_in(cells[k]) : std::nan(""));
  }
}

const std::vector<double>& Printed::operator[](const std::string& column) const {
  if (!has(column)) throw std::runtime_error("there is no column " + column);
  return columns_.at(column);
}

double Printed::at(const std::string& row, const std::string& column) const {
  const auto found = std::ranges::find(rows, row);
  if (found == rows.end()) throw std::runtime_error("there is no row " + row);
  return (*this)[column].at(static_cast<std::size_t>(found - rows.begin()));
}

// std::time is that of the last tick, at most 10 ms ago.
void await_next_second() {
  using namespace std::chrono;
  std::this_thread::sleep_until(floor<seconds>(system_clock::now()) + 1010ms);
}

}  // namespace asperity::test
