#include "tools/cli/file_identity.hpp"

#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "core/os.hpp"
#include "core/words.hpp"

namespace asperity::cli {
namespace {

namespace fs = std::filesystem;

// The number of such a link among the files of this process, or -1.
int own_descriptor(const fs::path& link) {
  std::error_code none;
  const bool own = fs::equivalent(link.parent_path(), os::descriptor_folder(), none);
  return own ? to_number<int>(link.filename().native()).value_or(-1) : -1;
}

Identity identity(const struct stat& status, const std::string& name = {}) {
  return std::to_string(status.st_dev) + ':' + std::to_string(status.st_ino) + ':' + name;
}

// Two outputs of a device do each other no harm.
Identity identity_unless_device(bool present, const struct stat& status) {
  return !present || S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode) ? Identity() : identity(status);
}

}  // namespace

OutputTarget output_target(const std::string& name) {
  if (name == "-") return {OutputTarget::Kind::descriptor, name, STDOUT_FILENO};
  std::error_code none;
  fs::path target = name;
  for (int links = 0; links < 40 && fs::is_symlink(target, none); ++links) {
    if (os::is_open_file(target)) {
      const int own = own_descriptor(target);
      return {own < 0 ? OutputTarget::Kind::other : OutputTarget::Kind::descriptor, target, own};
    }
    target = target.parent_path() / fs::read_symlink(target, none);
  }
  const bool replaceable = !fs::exists(target, none) || fs::is_regular_file(target, none);
  return {replaceable ? OutputTarget::Kind::file : OutputTarget::Kind::other, target, -1};
}

Identity identity_of_output(const std::string& name) {
  const OutputTarget target = output_target(name);
  struct stat status {};
  if (target.kind == OutputTarget::Kind::descriptor)
    return identity_unless_device(::fstat(target.descriptor, &status) == 0, status);
  if (::stat(target.path.c_str(), &status) == 0) return identity_unless_device(true, status);
  const fs::path path = target.path;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  return ::stat(folder.c_str(), &status) == 0 ? identity(status, path.filename()) : Identity();
}

Identity identity_of_input(const std::string& name) {
  struct stat status {};
  const int found = name == "-" ? ::fstat(STDIN_FILENO, &status) : ::stat(name.c_str(), &status);
  return identity_unless_device(found == 0, status);
}

}  // namespace asperity::cli
