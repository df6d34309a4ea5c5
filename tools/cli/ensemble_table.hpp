/// Tables over an ensemble: the mean of what is printed for one surface, with its standard error.
///
/// For each value: the mean over the surfaces that have it, the standard error of this mean, the spread
/// between surfaces, the spread expected from the errors of the single surfaces, and the number of surfaces
/// (stats/sample/ensemble.hpp, stats/measure/ensemble_parameters.hpp).
#pragma once

#include <string>
#include <vector>

#include "core/field.hpp"
#include "stats/measure/ensemble_parameters.hpp"
#include "stats/sample/ensemble.hpp"
#include "tools/cli/table.hpp"

namespace asperity::cli {

/// One parameter a row.
Table ensemble_table(const EnsembleParameters& parameters);

/// Tables of one surface each, such as an ACF over its lags, averaged row by row.
class EnsembleTable {
 public:
  /// The columns of the single tables. The mean of `value` gets a column of this name, and the error of the
  /// mean a column `error`; if the single tables have errors of this name, the spread between surfaces is set
  /// beside the one expected from them. Those of `others` are averaged with a NAME_standard_error, those of
  /// `means` without an error, where the tables have them; other columns are left out.
  struct Content {
    std::vector<std::string> keys;  ///< columns that are the same for all surfaces
    std::string value, error = "standard_error";
    std::vector<std::string> others = {}, means = {};
  };
  explicit EnsembleTable(Content content) : content_(std::move(content)) {}

  /// Throws DataError(file, …) unless its keys and its unit are those of the first table.
  void add(const Table& table, const std::string& file);
  int surfaces() const { return surfaces_; }
  /// Keys, value, error, others, means, and spread, expected_spread, surfaces of the value.
  Table table() const;

 private:
  void check_keys(const Table& table, const std::string& file) const;
  void add_further(const Table& table, const std::string& name, bool with_error);

  Content content_;
  Table first_ = {};
  std::string file_ = {};  ///< of the first
  Ensemble values_ = {}, square_errors_ = {};
  struct Further {
    Column column;
    bool with_error;
    Ensemble values = {};
  };
  std::vector<Further> further_ = {};
  int surfaces_ = 0;
};

/// A field of every surface, averaged point by point.
class EnsembleField {
 public:
  void add(const Field& field);
  Field mean() const { return as_field(values_.mean()); }
  Field standard_error() const { return as_field(values_.standard_error()); }

 private:
  Field as_field(const Eigen::ArrayXd& values) const {
    return Eigen::Map<const Field>(values.data(), rows_, values.size() / rows_);
  }

  Ensemble values_ = {};
  Index rows_ = 1;
};

}  // namespace asperity::cli
