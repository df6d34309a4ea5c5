/// The tables that asperity-psd prints: spectra over rings and of profiles, and values by scale.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stats/measure/sample.hpp"
#include "stats/measure/spectra.hpp"
#include "tools/cli/ensemble_table.hpp"
#include "tools/cli/table.hpp"

namespace asperity::cli {

inline constexpr const char* per_length = "rad m-1";  ///< of wave numbers

/// What several surfaces of unequal grids have in common.
struct CommonSpectra {
  CommonWaveNumbers radial, x, y;
  std::vector<double> areas;
  Grid finest;  ///< its spacings
};

/// None where all grids are the same.
std::optional<CommonSpectra> common_spectra(const std::vector<Grid>& grids, const std::vector<double>& areas);

/// Wave numbers and scales below the length `least` [m] have no error: a tip has falsified them.
Table radial_psd(const Sample& sample, const DataWindows& windows, double least);
Table profile_psds(const Sample& sample, const DataWindows& windows, double least);
Table scale_table(const Sample& sample, const DataWindows& windows, double least);
/// At the wave numbers of all surfaces; a blank where this one does not resolve them.
Table common_radial(const Sample& sample, const DataWindows& windows, const CommonSpectra& common);
Table common_profiles(const Sample& sample, const DataWindows& windows, const CommonSpectra& common);

/// What of these tables has a mean.
EnsembleTable::Content psd_content(const Table& one);

}  // namespace asperity::cli
