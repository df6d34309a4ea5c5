#include "tools/plot/gnuplot.hpp"

#include <cctype>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#include "core/words.hpp"
#include "dataset/beside.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX has it, but not in a header

namespace asperity::plot {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// A file without a name, which disappears with the process.
File nameless(std::string_view content = {}) {
  File out(std::tmpfile(), &std::fclose);
  if (!out || std::fwrite(content.data(), 1, content.size(), out.get()) != content.size() ||
      std::fflush(out.get()) != 0)
    throw std::system_error(errno, std::generic_category(), "temporary file");
  std::rewind(out.get());
  return out;
}

std::string content_of(const File& file) {
  std::rewind(file.get());
  std::string out;
  char chunk[1 << 16];
  while (const std::size_t n = std::fread(chunk, 1, sizeof chunk, file.get())) out.append(chunk, n);
  return out;
}

// Runs gnuplot with these files as its standard input, output and error; returns whether it succeeds.
// One that was installed with the tools comes before that of PATH: pictures are the same everywhere.
bool gnuplot(const File& input, const File& output, const File& error) {
  char program[] = "gnuplot", defaults[] = "--default-settings", standard_input[] = "-";
  const std::string own = beside_library("gnuplot/gnuplot");
  char* const arguments[] = {program, defaults, standard_input, nullptr};
  posix_spawn_file_actions_t streams{};
  posix_spawn_file_actions_init(&streams);
  int stream = STDIN_FILENO;
  for (const File* file : {&input, &output, &error})
    posix_spawn_file_actions_adddup2(&streams, ::fileno(file->get()), stream++);
  pid_t child = -1;
  const int failure =
      posix_spawnp(&child, own.empty() ? program : own.c_str(), &streams, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&streams);
  if (failure == ENOENT)
    throw std::runtime_error("the program gnuplot is not on the PATH: install gnuplot (Debian: gnuplot-nox)");
  if (failure != 0) throw std::system_error(failure, std::generic_category(), "gnuplot");
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "gnuplot");
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// The first line of gnuplot's messages that gives a reason; later lines are consequences.
std::string reason(const std::string& remarks) {
  for (auto begin = remarks.find("line "); begin != remarks.npos; begin = remarks.find("line ", begin + 1)) {
    const std::string line = remarks.substr(begin, remarks.find('\n', begin) - begin);
    if (line.find("warning:") == line.npos) return line;  // of the locale
  }
  return "it gave no reason";
}

// Replaces the creation date of a PDF with spaces, so that all other bytes keep their place.
void blank_date(std::string& bytes) {
  const auto begin = bytes.find("/CreationDate (");
  if (!bytes.starts_with("%PDF") || begin == bytes.npos) return;
  const auto end = bytes.find(')', begin);
  if (end != bytes.npos) bytes.replace(begin, end + 1 - begin, end + 1 - begin, ' ');
}

// Escapes ]]> in XML text, where it is not allowed; gnuplot does not.
void escape_ends_of_sections(std::string& bytes) {
  if (!bytes.starts_with("<?xml")) return;
  constexpr std::string_view end = "]]>", escaped = "]]&gt;";
  for (auto at = bytes.find(end); at != bytes.npos; at = bytes.find(end, at + escaped.size()))
    bytes.replace(at, end.size(), escaped);
}

// gnuplot draws symbols in SVG with lines of a hair's width, whatever their linewidth: here it is this part
// of their radius.
void thicken_symbols(std::string& bytes) {
  if (!bytes.starts_with("<?xml")) return;
  constexpr std::string_view symbol = "id='gpPt", width = "stroke-width='", wide = "0.3";
  for (auto at = bytes.find(symbol); at != bytes.npos; at = bytes.find(symbol, at + 1)) {
    const auto begin = bytes.find(width, at);
    if (begin >= bytes.find('>', at)) continue;
    const auto number = begin + width.size();
    bytes.replace(number, bytes.find('\'', number) - number, wide);
  }
}

// gnuplot does not draw an image of a single line of cells: the line is doubled at half the width.
void halve(Field& values, double& first, double& step, bool rows) {
  values = rows ? Field(values.replicate(2, 1)) : Field(values.replicate(1, 2));
  first -= 0.25 * step;
  step *= 0.5;
}

}  // namespace

Layer points(const Field& table, std::string_view style) {
  std::string format, use;
  for (Index c = 1; c <= table.cols(); ++c) {
    format += "%float64";
    use += (c == 1 ? "" : ":") + std::to_string(c);
  }
  return {fmt::format("binary record=({}) format='{}' using {} {}", table.rows(), format, use, style),
          {table.data(), table.data() + table.size()},
          "'-'"};
}

Layer raster(const Field& cells, Lattice at, std::string_view style) {
  Field values = cells;
  if (!at.in_space && values.rows() == 1) halve(values, at.x, at.dx, true);
  if (!at.in_space && values.cols() == 1) halve(values, at.y, at.dy, false);
  const Field fast_x = values.transpose();
  return {fmt::format("binary array=({},{}) format='%float64' origin=({},{}{}) dx={} dy={} using 1 {}",
                      values.rows(), values.cols(), at.x, at.y, at.in_space ? ",0" : "", at.dx, at.dy, style),
          {fast_x.data(), fast_x.data() + fast_x.size()}};
}

void Script::draw(std::string_view verb, const std::vector<Layer>& layers) {
  text_ += verb;
  for (std::size_t i = 0; i < layers.size(); ++i)
    text_ += (i == 0 ? " " : ", ") + layers[i].from + ' ' + layers[i].command;
  text_ += '\n';
  for (const Layer& layer : layers)
    text_.append(reinterpret_cast<const char*>(layer.numbers.data()), layer.numbers.size() * sizeof(double));
  text_ += '\n';
}

// gnuplot reads a digit after \056 as part of the octal number.
std::string gnuplot_string(std::string_view text) {
  std::string out = "\"";
  bool as_number = false;
  for (const char c : one_line(text)) {
    const auto code = static_cast<unsigned char>(c);
    as_number = std::isdigit(code) != 0 ? as_number : code < 0x80 && c != ' ' && std::isalpha(code) == 0;
    out += as_number ? fmt::format("\\{:03o}", code) : std::string(1, c);
  }
  return out + "\"";
}

Picture run_gnuplot(const Script& script) {
  const File input = nameless(script.text()), output = nameless(), error = nameless();
  const bool well = gnuplot(input, output, error);
  Picture picture{content_of(output), content_of(error)};
  blank_date(picture.bytes);
  escape_ends_of_sections(picture.bytes);
  thicken_symbols(picture.bytes);
  if (!well) throw std::runtime_error("gnuplot failed: " + reason(picture.remarks));
  if (picture.bytes.empty()) throw std::runtime_error("gnuplot drew nothing: " + reason(picture.remarks));
  return picture;
}

}  // namespace asperity::plot
