#include "tools/cli/output_name.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "core/os.hpp"
#include "core/words.hpp"
#include "formats/format.hpp"
#include "tools/cli/quantity.hpp"

namespace asperity::cli {
namespace {

namespace fs = std::filesystem;

// Of other programs, besides those of formats().
constexpr std::string_view not_text[] = {"vti",  "vtr",  "vtk", "nc4", "h5",   "hdf",  "hdf5", "mat", "npz",
                                         "tif",  "tiff", "png", "jpg", "jpeg", "bmp",  "gif",  "svg", "pdf",
                                         "html", "htm",  "zip", "gz",  "xls",  "xlsx", "ods"};

template <class List>
bool among(const List& list, const std::string& word) {
  return std::ranges::find(list, word) != std::end(list);
}

bool looks_like_extension(const std::string& word) {
  return !word.empty() && word.size() <= 8 && std::isalpha(static_cast<unsigned char>(word[0])) != 0 &&
         std::ranges::all_of(word, [](unsigned char c) { return std::isalnum(c) != 0; });
}

bool is_text_name(const std::string& extension) {
  const Format* format = format_by_extension("." + extension);
  return !names_dataset(extension) && !among(not_text, extension) &&
         (format == nullptr || format->name == "text" || format->name == "esri");
}

}  // namespace

std::string extension_of(const std::string& name) {
  std::error_code none;
  if (fs::exists(name, none) && !fs::is_regular_file(name, none)) return {};
  fs::path file = fs::path(name).filename();
  if (file.extension() == ".part" || file.extension() == ".tmp") file = file.stem();
  std::string word = file.extension().string().erase(0, 1);
  if (!looks_like_extension(word)) return {};
  std::ranges::transform(word, word.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

bool names_dataset(const std::string& extension) {
  constexpr std::string_view netcdf[] = {"", "nc", "cdf", "nc3", "netcdf"};
  return among(netcdf, extension);
}

void check_dataset_name(const std::string& name, const std::string& option) {
  if (!names_dataset(extension_of(name)))
    refuse(option, name,
           "names another format, but a dataset is NetCDF: end the name in .nc, or export other formats "
           "with asperity-convert");
}

void check_table_name(const std::string& name, bool json, const std::string& option) {
  const std::string extension = extension_of(name);
  if (extension == "json" && !json) refuse(option, name, "names JSON, but this is a table: add --json");
  if (!extension.empty() && !is_text_name(extension))
    refuse(option, name,
           json ? "names another format: end the name of JSON in .json"
                : "names another format: end a table in .tsv or .txt, a dataset in .nc");
}

void check_page_name(const std::string& name) {
  constexpr std::string_view html[] = {"", "html", "htm", "xhtml"};
  if (!among(html, extension_of(name)))
    refuse("output", name, "names another format: end the name of a page in .html");
}

// ---- the file behind a name ----

namespace {

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
