/// The record of a run: program, time, command, residuals and cost.
#pragma once

#include <ctime>
#include <optional>
#include <string>

#include "dataset/dataset.hpp"

namespace asperity::cli {

std::string version();    ///< Asperity's
std::string libraries();  ///< behind the tools, with their versions
std::string source();     ///< "Asperity VERSION (libraries)", the dataset's attribute

/// An argument as a shell would need it.
std::string shell_word(const std::string& argument);
/// The seconds since 1970 that SOURCE_DATE_EPOCH asks for, where it is set. Throws ParameterError where they
/// are no whole number from 0 to the end of 9999.
std::optional<std::time_t> source_date();
/// The time of the run in UTC, as ISO 8601, or the one that SOURCE_DATE_EPOCH asks for.
std::string timestamp();
/// Seconds as a dataset records them: 0 where SOURCE_DATE_EPOCH is set.
double on_record(double seconds);

/// For --time, "1.52 s, CPU 2.9 s (2.7 s user, 0.2 s system), peak memory 61 MB", with finished children.
std::string usage_of_run(double wall_seconds);

/// The global attributes whose names begin with `prefix` as one JSON object.
std::string report_of(const Dataset& dataset, const std::string& prefix);

}  // namespace asperity::cli
