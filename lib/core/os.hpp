/// What Linux has, and other systems have in another way or not at all.
///
/// os.cpp alone depends on the system: it has each function for Linux, and one that any POSIX system can do.
/// ASPERITY_PORTABLE chooses the latter on Linux too; tests/portable compiles and tests it.
#pragma once

#include <cstddef>
#include <string>

namespace asperity::os {

// ---- memory ----

/// Pages of 2 MiB for memory not yet accessed. No effect on small blocks, or elsewhere.
void prefer_large_pages(void* memory, std::size_t bytes);
/// `capacity` bytes that begin with the `size` bytes of `former`, which is released; then zeros, which take
/// no memory before they are touched. `former` is null or from here. Elsewhere it is copied.
/// Throws std::bad_alloc.
void* grown(void* former, std::size_t size, std::size_t capacity);
/// From now on freed blocks of 1 MiB or more go back to the system at once. Else glibc comes to keep those of
/// up to 32 MiB. Elsewhere the system decides.
void return_freed_memory();
/// The most memory that this process has had [KiB]; 0 elsewhere.
long peak_kibibytes();
/// Address space that this process has [byte]; 0 elsewhere.
std::size_t address_space();

// ---- files ----

/// The folder in which this process finds its open files, by their numbers.
const char* descriptor_folder();
std::string descriptor_path(int fd);
/// Whether a symbolic link stands for an open file, whatever it seems to lead to: those of /proc.
bool is_open_file(const std::string& link);
/// Opens a file for writing that has no name before give_name(); -1 where that cannot be had, as elsewhere.
int unnamed_file(const std::string& folder, unsigned mode);
/// False, with errno, where that name cannot be given.
bool give_name(int fd, const char* path);
/// Opens a file that never has a name: in memory, elsewhere where temporary files are. -1, with errno.
int file_in_memory();
/// Opens a pipe that programs started from here do not inherit. Without one the ends are -1, with errno.
void open_pipe(int (&ends)[2]);
/// Lets a pipe hold this many bytes. No effect elsewhere, or on what is no pipe.
void widen_pipe(int fd, int bytes);

// ---- processes ----

/// The path of the running program; empty elsewhere.
std::string own_program();
/// Of a child: kills it when its parent ends. Elsewhere it outlives its parent.
void end_with_parent();
/// Closes all files from this number on.
void close_from(int first);

}  // namespace asperity::os
