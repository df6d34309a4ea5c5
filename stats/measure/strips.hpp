/// A field that stays in a file and is read in strips of as many whole rows as memory holds.
///
/// Passes: one for the mean, two or three for a form, one for moments, derivatives and the correlation, one
/// for the order of the heights, one for profiles (along x in strips of columns), four for quantiles. Errors
/// from the field's long waves take one for derivatives, one for the heights of a lay, nine for quantiles.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>

#include "core/field.hpp"
#include "stats/filter/form.hpp"
#include "stats/height/height_steps.hpp"
#include "stats/measure/surface.hpp"

namespace asperity {

/// `count` rows, or columns, of the field from `first` on, in SI, missing points NaN.
struct FieldParts {
  Grid grid;
  std::function<Field(Index first, Index count)> rows, columns;
};

/// Reads parts of a field above its mean and its form.
class StripReader {
 public:
  /// Throws ParameterError("memory", …) for less than four rows, and as FormFit does.
  StripReader(FieldParts parts, int degree, std::size_t memory);

  const Grid& grid() const { return parts_.grid; }
  Index rows() const { return rows_; }                          ///< of every strip but the last
  int degree() const { return degree_; }                        ///< of the form
  const std::optional<FormFit>& form() const { return form_; }  ///< none but for the mean
  double level() const { return mean_.value(); }
  double points() const { return points_; }      ///< that are there
  double step() const { return steps_.step(); }  ///< that neighbours stand on
  double largest() const { return largest_; }    ///< the largest absolute value, form included

  /// visit(strip, core, first): `core` rows from the field's row `first` on, then `halo` more, as in a Strip.
  template <class Visit>
  void for_each_strip(Index halo, Visit visit) const {
    for (Index first = 0; first < grid().shape.nx; first += rows_) {
      const Index core = std::min(rows_, grid().shape.nx - first);
      visit(strip(first, core, halo), core, first);
    }
  }
  /// `core` rows from `first` on, and up to `halo` more.
  Field strip(Index first, Index core, Index halo = 0) const;
  /// visit(columns): whole columns.
  template <class Visit>
  void for_each_columns(Visit visit) const {
    for (Index first = 0; first < grid().shape.ny; first += columns_)
      visit(columns(first, std::min(columns_, grid().shape.ny - first)));
  }

 private:
  Field columns(Index first, Index count) const;

  FieldParts parts_;
  int degree_;
  Index rows_, columns_;
  Mean mean_ = {};
  NeighbourSteps steps_ = {};
  double points_ = 0, largest_ = 0;
  std::optional<FormFit> form_ = {};
};

}  // namespace asperity
