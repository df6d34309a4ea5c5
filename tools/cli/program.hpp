/// Another program, run in a process of its own to make one file of another.
///
/// The program gets no shell, no standard input, no display and no files of its user: its home and all other
/// folders for settings and temporary files are /dev/null. It is in a process group of its own, which is
/// killed when its time is over and when it has ended; the program also ends with this process. Limits bound
/// its address space, its processor time, its elapsed time, and what it writes. Its output is a file in
/// memory without a name: nothing is left behind, whatever ends the run.
///
/// Scope     one thread at a time. Its own children outlive it where this process is killed; elsewhere than
///           on Linux so does the program itself.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/os.hpp"
#include "dataset/bytes.hpp"

namespace asperity::cli {

struct ProgramLimits {
  unsigned seconds = 60;   ///< of processor time, and of elapsed time
  std::size_t memory = 0;  ///< of address space, and of the output [byte]
};

struct ProgramRun {
  enum class End { done, failed, too_long, too_large, not_started };
  End end = End::failed;
  std::string messages;  ///< the first of what it printed, standard output and error
  Bytes output;          ///< what it wrote to output_file
};

/// Files of the program: what it should write, and `input` as a file.
inline const std::string output_file = os::descriptor_path(3), input_file = os::descriptor_path(4);

/// The path of a program that a shell would find, or "".
std::string program_path(const std::string& name);

/// Runs path with arguments. Throws std::system_error where no process or no memory can be had.
ProgramRun run_program(const std::string& path, const std::vector<std::string>& arguments,
                       std::string_view input, ProgramLimits limits);

}  // namespace asperity::cli
