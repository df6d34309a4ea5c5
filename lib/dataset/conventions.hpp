/// What a foreign NetCDF says of its values, understood once, where a dataset is read.
///
/// A variable of another program may hold numbers that stand for others. With packed numbers v of the file,
///
///     value = v scale_factor + add_offset                       where v is no mark and in the valid range
///     none                                                      elsewhere
///
///     marks           _FillValue; every number of missing_value; without _FillValue, NetCDF's default
///                     fill of the type (9.969209968386869e36 of floating numbers; bytes have none)
///     valid range     valid_range, or valid_min and valid_max
///     _Unsigned       "true" of signed whole numbers: they and these attributes are meant without sign
///
/// Marks and ranges are those of the packed numbers, as CF has it. Afterwards a variable holds plain values,
/// of double precision where they were packed and else of its own type, and one mark at most, `_FillValue` or
/// one missing_value; what told the rest is gone, and actual_range is that of the points that are there.
///
/// Refused, by the variable's name: a scale that is not one finite number or is 0, an offset, a mark or a
/// bound that is text or no number, a range that holds nothing, and one of floating numbers beside packed
/// whole ones, which some write of the unpacked values.
///
/// Cost      a look at the names of attributes; one pass over what has such attributes.
///
/// CF Conventions 1.8, sections 2.5.1 and 8.1; The NetCDF Users Guide, appendix A: Attribute Conventions.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "dataset/dataset.hpp"

namespace asperity {

/// The number that stands for no value in a plain variable: _FillValue, else a missing_value, else the
/// default of its type; NaN where there is none.
double mark_of(const Variable& variable);
/// The values as doubles, NaN where there is none.
std::vector<double> present_numbers(const Variable& variable);

/// How the values of a variable become plain ones, whole or part by part.
class Conventions {
 public:
  /// Of a variable as its file has it, its values perhaps elsewhere. Throws DataError(name, …).
  explicit Conventions(const Variable& packed);

  /// Whether it is plain as it stands.
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

  Values own_;  ///< no values, of the type with the sign that they are meant with
  bool plain_ = true, doubles_ = false;
  double scale_ = 1, offset_ = 0;
  double least_ = -std::numeric_limits<double>::infinity(), greatest_ = -least_;
  std::vector<double> marks_;   ///< all of them, of the packed numbers
  std::optional<double> mark_;  ///< the one that is left
};

/// Every variable plain. Throws DataError(name, …).
Dataset with_plain_values(Dataset dataset);

}  // namespace asperity
