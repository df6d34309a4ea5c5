/// A table of an autocorrelation as the option --acf reads it.
///
/// A dataset      `acf` as asperity-acf writes it, else `acf_target` of a kernel or a drawn surface.
/// A column text  one lag a line under a header that names the columns, others being ignored:
///                # lag_x [um]  lag_y [um]  acf [1]
///                px, 1 or no unit at all count samples; m2 or um2 make the values heights squared.
/// A matrix       R(p,q) of a quadrant, p = 0… down lines, q = 0… along them, in samples, even in p and q.
/// Numbers are separated by blanks, tabs, commas or semicolons; lines that begin with # are comments.
#pragma once

#include <cmath>
#include <string>

#include "dataset/dataset.hpp"
#include "dataset/memory_bound.hpp"
#include "tools/surface/kernel_dataset.hpp"
#include "tools/surface/marginal.hpp"

namespace asperity::cli {

struct AcfTable {
  Field half_plane;                  ///< R(p,q), p = 0… (rows), q = -Q…Q (columns), in any unit
  bool left_out = false;             ///< lags at its ends that hold no numbers, as without pairs
  Spacing spacing;                   ///< of the lags [m], where it is known
  double rms = NAN;                  ///< [m], where it is known
  HeightsWithAcf heights = {};       ///< whose autocorrelation it is
  std::optional<Shape> period = {};  ///< of a periodic surface, where the table has all of its lags
  std::optional<Shape> corner = {};  ///< the largest part of that surface that is meant, not the whole
  const char* option = "acf";        ///< that asked for it
  bool any_period = false;           ///< a text, which does not say its surface's
  bool positive_definite = false;    ///< as it stands, and 0 beyond its lags: of a tapered surface
  Dataset dataset;  ///< what came with the table, less what belongs to the surface that it was taken from

  /// The period; of a text these periodic points, where it has all of their lags.
  std::optional<Shape> period_on(Shape periodic) const;
};

/// The table in a dataset. Throws DataError("acf", …).
AcfTable acf_table_of(Dataset data);
/// "-" is standard input. Throws DataError("acf", …).
AcfTable read_acf_table(const std::string& name, const MemoryBound& memory);

}  // namespace asperity::cli
