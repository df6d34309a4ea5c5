/// The tools, in the order of a chain, each with a line on what it does.
#pragma once

#include <string_view>

namespace asperity::cli {

struct Summary {
  std::string_view tool, text;
};

inline constexpr Summary umbrella = {"asperity", "list the tools; open their manuals and the documentation"};

inline constexpr Summary toolbox[] = {
    {"asperity-kernel", "solve the autocorrelation equations for a kernel"},
    {"asperity-generate", "draw random rough surfaces"},
    {"asperity-convert", "import and export maps of other programs"},
    {"asperity-filter", "level, filter, fill, cut and resample maps"},
    {"asperity-stats", "surface and profile parameters with standard errors"},
    {"asperity-acf", "autocorrelation and correlation lengths of a surface"},
    {"asperity-psd", "power spectral density of a surface"},
    {"asperity-pdf", "distribution of the heights of a surface"},
    {"asperity-validate", "test whether surfaces have the prescribed properties"},
    {"asperity-contact", "press two rough bodies together"},
    {"asperity-stress", "stress below the surface of a contact"},
    {"asperity-plot", "figures of datasets, as PNG, SVG or PDF"},
    {"asperity-report", "a dataset as one HTML page"},
};

/// Empty for what is no tool.
constexpr std::string_view summary_of(std::string_view tool) {
  if (tool == umbrella.tool) return umbrella.text;
  for (const Summary& s : toolbox)
    if (s.tool == tool) return s.text;
  return {};
}

}  // namespace asperity::cli
