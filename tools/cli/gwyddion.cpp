#include "tools/cli/gwyddion.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "formats/format.hpp"
#include "formats/text_numbers.hpp"
#include "tools/cli/program.hpp"
#include "tools/cli/record.hpp"

namespace asperity::cli {
namespace {

constexpr std::size_t program_alone = std::size_t{512} << 20;  // bytes of address space; 150 MB are enough

ProgramLimits limits_of(std::size_t bytes, const MemoryBound& memory) {
  constexpr std::size_t bytes_a_second = 10'000'000, machine = std::size_t{1} << 46;
  return {.seconds = static_cast<unsigned>(30 + bytes / bytes_a_second),
          .memory = program_alone + std::min(memory.left(), machine)};
}

// What is its own of a regular file; "" otherwise.
std::string path_of(const std::string& name) {
  std::error_code none;
  return name != "-" && std::filesystem::is_regular_file(name, none)
             ? std::filesystem::absolute(name, none).string()
             : "";
}

// "2.62" of "Gwyddion 2.62 (2022-11-03)"; "" where it does not tell.
std::string version_of(const std::string& program) {
  const ProgramRun run = run_program(program, {"--version"}, {}, limits_of(0, {.bytes = 0}));
  const std::size_t begin = run.messages.find_first_of("0123456789");
  return begin == run.messages.npos
             ? ""
             : run.messages.substr(begin, run.messages.find_first_of(" \n", begin) - begin);
}

// What it says of the file, or "".
std::string complaint(const ProgramRun& run, const std::string& path) {
  const std::size_t begin = run.messages.find(path + ": ");
  if (begin == std::string::npos) return "";
  const std::size_t words = begin + path.size() + 2;
  return one_line(run.messages.substr(words, run.messages.find('\n', words) - words), 120);
}

std::string refusal(const ProgramRun& run, const std::string& path, ProgramLimits limits,
                    const std::string& what) {
  using enum ProgramRun::End;
  if (run.end == not_started) return "Gwyddion, which would read the file, cannot be started";
  if (run.end == too_long)
    return fmt::format("Gwyddion takes longer than {} s to read the file", limits.seconds);
  if (run.end == too_large || run.messages.find("failed to allocate") != std::string::npos)
    return "Gwyddion needs more memory to read the file than `memory` allows";
  const std::string words = complaint(run, path);
  const std::string out =
      what + ", and Gwyddion cannot read the file either" + (words.empty() ? "" : ": " + words);
  return out + (out.ends_with('.') ? "" : ".") + " Save it as .x3p or text with the instrument's own program";
}

// Gwyddion 2.62 takes sizes of WSxM in the prefix of the heights: where heights are in nm, 1 µm becomes 1 nm.
void check_wsxm(const Map& map, std::string_view bytes) {
  if (!bytes.starts_with("WSxM file copyright")) return;
  for (const std::string_view key : {"X Amplitude", "Y Amplitude"}) {
    const std::size_t at = bytes.find(key);
    std::string_view rest = bytes.substr(std::min(at, bytes.size()));
    const std::string_view line = take_line(rest),
                           words = trimmed(line.substr(std::min(line.find(':') + 1, line.size())));
    const auto stated = leading_number<double>(words);
    if (!stated.found) continue;
    const bool x = key[0] == 'X';
    const double size = stated.number * metres_per(trimmed(stated.rest)),
                 taken =
                     map.spacing[x ? 0 : 1] * static_cast<double>(x ? map.values.rows() : map.values.cols());
    if (!(std::abs(taken - size) <= 1e-3 * size))
      throw DataError("map", fmt::format("Gwyddion takes {} '{}' for {} m: give its `size`", key,
                                         one_line(words, 24), taken));
  }
}

}  // namespace

Map map_through_gwyddion(std::string_view bytes, const std::string& name, const Reading& reading) {
  const std::string program = program_path("gwyddion"), foreign(foreign_format(bytes, name));
  if (program.empty())
    throw DataError(
        "map",
        (foreign.empty() ? "unknown format: neither the first bytes nor the file extension identifies it"
                         : foreign + ", which no reader here knows") +
            ". Gwyddion reads a hundred formats more: install it (package gwyddion of Debian), and Asperity "
            "reads through it");
  const std::string own = path_of(name), path = own.empty() ? input_file : own;
  const ProgramLimits limits = limits_of(bytes.size(), reading.memory);
  ProgramRun run = run_program(program, {fmt::format("--convert-to-gwy={}", output_file), path},
                               own.empty() ? bytes : std::string_view(), limits);
  if (run.end != ProgramRun::End::done || run.output.size() == 0)
    throw DataError("map", refusal(run, path, limits, foreign.empty() ? "unknown format" : foreign));
  Reading options = reading;
  options.memory = reading.memory.beside(run.output.size());
  Map map = format::gwy.decode(run.output, options);
  if (!options.size_told) check_wsxm(map, bytes);
  static const std::string version = version_of(program);
  map.history =
      fmt::format("{}: gwyddion {} --convert-to-gwy=OUT.gwy {}", timestamp(), version, shell_word(name));
  return map;
}

}  // namespace asperity::cli
