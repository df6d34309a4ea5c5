/// Tables over an ensemble: the mean of what is printed for one surface, with its standard error; or a row
/// for each surface.
///
/// For each value: the mean over the surfaces that have it, the standard error of this mean, the spread
/// between surfaces, the spread expected from the errors of the single surfaces, and the number of surfaces
/// (stats/sample/ensemble.hpp, stats/measure/ensemble_parameters.hpp). A note says how many standard errors
/// a 95 % interval has.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/field.hpp"
#include "stats/measure/ensemble_parameters.hpp"
#include "stats/sample/ensemble.hpp"
#include "tools/cli/ensemble_input.hpp"
#include "tools/cli/table.hpp"

namespace asperity::cli {

/// Notes what a standard error of so many surfaces is worth: "4 surfaces: a 95 % interval is 3.18 standard
/// errors to either side, Student's t of 3 degrees of freedom". Nothing of fewer than two.
void tell_interval(const Tool& tool, double surfaces, double most_degrees = INFINITY);
/// Notes the shares of unequal areas: "12 surfaces count by measured area, from 3.6 to 14 % of all". Warns
/// where they give no errors.
void tell_weights(const Tool& tool, const AreaWeights& weights);

/// Warns where the lays of surfaces differ by more than their errors and 5°: what is pooled over them has
/// heights in common, and no lengths.
void warn_of_lays(const Tool& tool, const std::vector<EnsembleParameter>& parameters);

// ---- a row for each parameter ----

Table ensemble_table(const std::vector<EnsembleParameter>& parameters);
/// The verdict is "differs", "agrees", or "unknown" without an error.
Table comparison_table(const std::vector<ComparedParameter>& parameters);

// ---- the rows of one surface, averaged ----

/// Tables of one surface each, such as an ACF over its lags, averaged row by row.
class EnsembleTable {
 public:
  /// The columns of the single tables. The mean of `value` gets a column of this name, and the error of the
  /// mean a column `error`; if the single tables have errors of this name, the spread expected from them
  /// follows the spread between surfaces. Those of `others` are averaged with a NAME_standard_error, those of
  /// `means` without an error, where the tables have them; other columns are left out.
  struct Content {
    std::vector<std::string> keys;  ///< columns that are the same for all surfaces
    std::string value, error = "standard_error";
    std::vector<std::string> others = {}, means = {};
    std::vector<std::string> shares = {};  ///< of 0 or 1, like `others`, with the error of Wilson's interval
    /// Words why a row of one surface has no error, "-" where it has one. They tell of a bias that all
    /// surfaces have: rows for which more than a tenth of them give a reason have no error.
    std::string reason = {};
  };
  using ContentOf = std::function<Content(const Table& first)>;
  explicit EnsembleTable(ContentOf content) : content_of_(std::move(content)) {}

  /// Throws DataError(file, …) unless its keys and its unit are those of the first table.
  void add(const Table& table, const std::string& file, double weight = 1);
  /// Keys, value, error, others, means, and spread, expected_spread, surfaces of the value.
  Table table() const;
  /// Nothing where none was added. Pooled values, and their errors, take the place of the means.
  void print(const Tool& tool, const Eigen::ArrayXd& pooled = {}, const Eigen::ArrayXd& errors = {}) const;

 private:
  void check_keys(const Table& table, const std::string& file) const;
  enum class Error { none, of_spread, of_share };
  void add_further(const Table& table, const std::string& name, Error error, double weight);
  void add_reasons(const Table& table);
  void append_reasons(Table& out) const;

  ContentOf content_of_;
  Content content_ = {};
  Table first_ = {};
  std::string file_ = {};  ///< of the first
  Ensemble values_ = {}, square_errors_ = {};
  struct Further {
    Column column;
    Error error;
    Ensemble values = {};
  };
  std::vector<Further> further_ = {};
  struct Reason {
    std::string first = "-";
    int surfaces = 0;
  };
  std::vector<Reason> reasons_ = {};  ///< a row each
  int surfaces_ = 0;
};

/// Prints the table of one surface, or the mean over those of several; returns the worst exit code. They
/// count by their areas, where given in input order.
int print_table(const Tool& tool, EnsembleInput& surfaces, const Several& several,
                const EnsembleTable::ContentOf& content,
                const std::function<Table(EnsembleMember&&)>& table_of_one,
                const std::vector<double>& areas = {});

/// A field of every surface, averaged point by point.
class EnsembleField {
 public:
  void add(const Field& field, double weight = 1);
  Field mean() const { return as_field(values_.mean()); }
  Field standard_error() const { return as_field(values_.standard_error()); }

 private:
  Field as_field(const Eigen::ArrayXd& values) const {
    return Eigen::Map<const Field>(values.data(), rows_, values.size() / rows_);
  }

  Ensemble values_ = {};
  Index rows_ = 1;
};

// ---- a row for each surface ----

/// The columns are the numbers that the tool records as attributes, in the order of the catalogue
/// (dataset/catalogue.hpp): whatever a run adds to its datasets, its rows have too.
struct RowContent {
  std::string_view prefix;                      ///< of the attributes, "contact_"
  std::vector<std::string_view> without = {};   ///< results that get no column; may end in *
  std::vector<std::string_view> achieved = {};  ///< further columns, without a mean
  std::vector<std::string_view> places = {};    ///< results without a mean
};

struct SurfaceResults {
  Attributes attributes;
  bool converged = true;  ///< else it is not in the mean
  int code = done;
};

/// Prints a row for each of several surfaces, then rows "mean", "standard_error" and "spread", the standard
/// deviation between the converged surfaces, from which the error is; of a share, whose spread may be 0, the
/// error is by Wilson's interval. One that fails as `several` allows is a row of unknown numbers. Returns the
/// worst exit code.
int print_rows(const Tool& tool, EnsembleInput& surfaces, Several several, const RowContent& content,
               const std::function<SurfaceResults(EnsembleMember&&)>& results_of_one);

}  // namespace asperity::cli
