/// Unpacks the values of NetCDF files of other programs when a dataset is read.
///
/// A variable of another program may hold packed numbers v, with
///
///     value = v scale_factor + add_offset                       if v is not a mark and in the valid range
///     missing                                                   otherwise
///
///     marks           _FillValue; every number of missing_value; without _FillValue, NetCDF's default
///                     fill of the type (default_fill for floating-point types; bytes have none)
///     valid range     valid_range, or valid_min and valid_max
///     _Unsigned       "true" for signed integers: they and these attributes are read as unsigned
///
/// As in CF, marks and ranges refer to the packed numbers. Afterwards a variable holds plain values, in
/// double precision if they were packed and in its own type otherwise, and at most one mark, `_FillValue` or
/// one missing_value; the other attributes are removed, and actual_range omits missing points.
///
/// Refused, with the variable's name: a scale that is not one finite number or is 0; an offset, mark or bound
/// that is text or not a number; an empty range; and a floating-point range of packed integers, which some
/// programs write for the unpacked values.
///
/// Cost      a look at the names of attributes; one pass over variables with such attributes.
///
/// CF Conventions 1.8, sections 2.5.1 and 8.1; The NetCDF Users Guide, appendix A: Attribute Conventions.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "dataset/dataset.hpp"

namespace asperity {

/// NetCDF's own mark of missing points for doubles.
inline constexpr double default_fill = 9.969209968386869e36;

/// The number that marks missing points in a plain variable: _FillValue, else missing_value, else the default
/// of its type; NaN if there is none.
double mark_of(const Variable& variable);
/// The values as doubles, NaN for missing points.
std::vector<double> present_numbers(const Variable& variable);

/// Unpacks the values of a variable, all at once or in parts.
class Conventions {
 public:
  /// For a variable as in the file, with or without its values. Throws DataError(name, …).
  explicit Conventions(const Variable& packed);

  /// Whether the variable is plain already.
  bool plain() const { return plain_; }
  Values unpacked(Values packed) const;
  /// The variable, with the attributes of plain values.
  Variable unpacked(Variable packed) const;

 private:
  std::vector<double> numbers_in(const Variable& variable, const char* attribute) const;
  std::optional<double> number_in(const Variable& variable, const char* attribute) const;
  void take_sign(const Variable& variable);
  void take_packing(const Variable& variable);
  void take_range(const Variable& variable);
  void take_marks(const Variable& variable);
  Values own_type(const Values& values) const;
  bool missing(double packed) const;

  Values own_;  ///< empty; its type has the intended sign
  bool plain_ = true, doubles_ = false;
  double scale_ = 1, offset_ = 0;
  double least_ = -std::numeric_limits<double>::infinity(), greatest_ = -least_;
  std::vector<double> marks_;   ///< all of them, of the packed numbers
  std::optional<double> mark_;  ///< the one that remains
};

/// The dataset with all variables plain. Throws DataError(name, …).
Dataset with_plain_values(Dataset dataset);

}  // namespace asperity
