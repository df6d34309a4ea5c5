/// What the name of an output says of its format, so that no file holds another format than its name promises.
///
/// A dataset goes into names without an extension and into .nc, .cdf, .nc3 and .netcdf; a table, which is text, into
/// whatever is not known as another format. Everything else is a ParameterError(option, …) that says what to do.
#pragma once

#include <string>

namespace asperity::cli {

/// What follows the last dot, in lower case: a letter and up to seven letters and digits. Otherwise, and for devices,
/// pipes and other names that are no regular file, there is none: "-", "/dev/fd/63", "tmp.W2kXh0pQzR", "run_0.4um". The
/// extension of "a.nc.part" and "a.nc.tmp" is nc.
std::string extension_of(const std::string& name);

bool names_dataset(const std::string& extension);
void check_dataset_name(const std::string& name, const std::string& option = "output");
/// .json is for what is JSON.
void check_table_name(const std::string& name, bool json, const std::string& option = "output");
/// Of a page, HTML.
void check_page_name(const std::string& name);

}  // namespace asperity::cli
