/// What the name of an output says of its format, so that no file holds another one.
///
/// A dataset goes into names without an extension, .nc, .cdf, .nc3 and .netcdf; a table into whatever is not
/// known as another format than text. Else a ParameterError(option, …) says what to do.
#pragma once

#include <string>

namespace asperity::cli {

/// What follows the last dot, in lower case: a letter and up to seven letters and digits; of "a.nc.part" nc.
/// Otherwise, and of what is no regular file, there is none: "-", "tmp.W2kXh0pQzR", "run_0.4um".
std::string extension_of(const std::string& name);

bool names_dataset(const std::string& extension);
void check_dataset_name(const std::string& name, const std::string& option = "output");
/// .json is for what is JSON.
void check_table_name(const std::string& name, bool json, const std::string& option = "output");
/// Of a page, HTML.
void check_page_name(const std::string& name);

}  // namespace asperity::cli
