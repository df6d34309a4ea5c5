/// A table of a power spectral density as the option --psd reads it.
///
/// Text       a row a line, under a header that names the columns with their units; others are ignored. So
///            are the tables of asperity-psd, --result radial and profiles:
///            # wave_number [rad m-1]  psd [m4]
/// JSON       the same columns as {"wave_number": {"unit": "rad m-1", "values": […]}, "psd": {…}}.
/// A dataset  `psd` of asperity-psd: its means over rings of wave numbers; or over wave_number alone.
///
/// The wave number is wave_number or q, 2π/wavelength; or frequency or f, 1/wavelength. The unit may say it
/// too, rad/m or cycles/mm: it goes before the name, and a wave_number in 1/m could be either. The density is
/// psd or C, two-sided as acf/radial_spectrum.hpp (1) has it: m4 is that of an isotropic surface, m3 that of
/// its profiles, which (3) there turns into the former. Profiles along x and y, with a column direction, are
/// taken together; their wave number 0 is left out. Their first wave number, and the first ring of a table
/// with a column count, hold the waves down to half a step from 0: the table adds up to the map's variance.
///
/// A periodic surface has the waves of its period, each with the table's C. Another one is a corner of a
/// periodic surface on twice its sides: of finer waves, and no height is near itself around the period.
#pragma once

#include <string>

#include "acf/radial_spectrum.hpp"
#include "dataset/memory_bound.hpp"
#include "tools/cli/tool.hpp"
#include "tools/surface/acf_table.hpp"

namespace asperity::cli {

struct SpectrumTable {
  RadialSpectrum spectrum;
  bool over_rings = false;        ///< of a dataset, whose direction is lost
  double change = 0, beyond = 0;  ///< of profiles (ProfileSpectrum)
  double lay = 1;  ///< mean square slope of the profiles of one direction over that of the other, at least 1
};

/// "-" is standard input. Throws DataError("psd", …).
SpectrumTable read_spectrum_table(const std::string& name, const MemoryBound& memory);

/// The autocorrelation of surfaces with the spectrum in this file, on their period or that of which they are
/// corners, at all lags; its rms is that of these waves. Says what of the table is not in it. Throws
/// UsageError for a profile, DataError("psd", …), ParameterError("memory").
AcfTable acf_of_spectrum(const Tool& tool, const std::string& name, const Spacing& spacing, Shape surface,
                         bool periodic);

}  // namespace asperity::cli
