/// The form and the filters that a surface is prepared with, by name: one door for measuring a map and for
/// writing it.
///
/// ISO 25178-2 takes a primary surface in three steps. The S-filter removes waves shorter than λs, the
/// F-operation subtracts the form, the L-filter removes waves longer than λc:
///     z → z - form → mean surface at λs → z less its mean surface at λc.                              (1)
/// The form goes first here, because a filter of order zero bends a slope at the edges. On a periodic surface
/// the order does not matter.
///
/// Symbols   λs, λc  cut-off wavelengths of the S- and of the L-filter [m]
/// Accuracy  of each filter: see its header.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "core/field.hpp"

namespace asperity {

/// What heights are measured from.
struct Form {
  enum class Kind { polynomial, sphere, cylinder };
  Kind kind = Kind::polynomial;
  int degree = 0;  ///< of a polynomial: 0 the mean, 1 the plane

  /// The degree of a polynomial that takes the long waves which this form takes.
  int modes() const { return kind == Kind::polynomial ? degree : 2; }
  std::string words() const;  ///< "plane", "degree 3", "sphere"
};

/// A filter at its cut-off.
struct Cutoff {
  enum class Filter { gaussian, robust, spline };
  double wavelength = std::numeric_limits<double>::quiet_NaN();  ///< λs or λc [m]; NaN: no filter
  Filter filter = Filter::gaussian;

  bool given() const { return !std::isnan(wavelength); }
};

/// Heights above a form; of a sphere or a cylinder what stats/filter/form.hpp found.
struct WithoutForm {
  Field heights;
  double radius = std::numeric_limits<double>::infinity();  ///< [m]; above zero a dome, below a bowl
  double axis = 0;  ///< of a cylinder: angle from +x towards +y, at most π/2 either way [rad]
};
/// Throws ParameterError("remove-form") where the measured points do not determine the form.
WithoutForm without_form(Field z, const Grid& grid, const Form& form, int threads = 1);

struct MeanSurface {
  Field surface;
  std::string doubt = {};  ///< of a filter that has not converged; "": none
};
/// The waves longer than the cut-off. Throws ParameterError("cut-off") as the filters do.
MeanSurface mean_surface(const Field& z, const Grid& grid, const Cutoff& cutoff, int threads = 1);

/// A form of degree d has taken M = (d+1)(d+2)/2 - 1 waves besides the mean, of lengths (a/2Lx, b/2Ly)⁻¹ or
/// so, a + b ≤ d; of one row d. From a part of the field, by its share of the area, and from what an L-filter
/// leaves, by the power that it passes of each wave, it has taken fewer: the degree with the nearest number.
int degree_on_part(int degree, const Grid& grid, double share);
int degree_behind(int degree, const Grid& grid, const Cutoff& longer);

}  // namespace asperity
