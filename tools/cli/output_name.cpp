#include "tools/cli/output_name.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "formats/format.hpp"
#include "tools/cli/quantity.hpp"

namespace asperity::cli {
namespace {

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
  namespace fs = std::filesystem;
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

}  // namespace asperity::cli
