/// The format that the name of an output implies, so that no file holds another one.
///
/// A dataset needs a name without an extension, or with .nc, .cdf, .nc3 or .netcdf. A table takes any name
/// whose extension is not that of another format. Otherwise ParameterError(option, …) says what to do.
#pragma once

#include <string>

namespace asperity::cli {

/// After the last dot, in lower case: a letter and up to seven letters and digits; "nc" of "a.nc.part". Empty
/// otherwise, and for anything but a regular file: "-", "tmp.W2kXh0pQzR", "run_0.4um".
std::string extension_of(const std::string& name);

bool names_dataset(const std::string& extension);
void check_dataset_name(const std::string& name, const std::string& option = "output");
/// Refuses .json unless `json`.
void check_table_name(const std::string& name, bool json, const std::string& option = "output");
/// A page is HTML.
void check_page_name(const std::string& name);

}  // namespace asperity::cli
