/// A table of an ensemble: a row for each surface, then the mean over them and its standard error.
///
/// The columns are the numbers that the tool records as attributes (dataset/catalogue.hpp): whatever a run
/// adds to its datasets, its rows have too.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.hpp"
#include "tools/cli/table.hpp"

namespace asperity::cli {

class EnsembleRows {
 public:
  struct Content {
    std::string_view prefix;                      ///< of the attributes, "contact_"
    std::vector<std::string_view> without = {};   ///< results that get no column; may end in *
    std::vector<std::string_view> achieved = {};  ///< further columns, without a mean
    std::vector<std::string_view> places = {};    ///< results without a mean
  };
  explicit EnsembleRows(Content content) : content_(std::move(content)) {}

  /// The attributes of a surface; it counts in the mean unless it has not converged.
  void add(const std::string& surface, const Attributes& attributes, bool converged);
  /// A surface without a result: a row of unknown numbers, converged 0.
  void add_failed(const std::string& surface) { rows_.push_back({surface, {}, false}); }

  /// The column surface, then the results in the order of the catalogue. The last two rows are "mean" and
  /// "standard_error", by the spread between the converged surfaces.
  Table table() const;

 private:
  struct Row {
    std::string surface;
    std::map<std::string, double> values;  ///< by the names of attributes
    bool converged = true;
  };
  struct Asked {
    std::string attribute;
    Column column;
    bool averaged;
  };
  std::vector<Asked> columns() const;

  Content content_;
  std::vector<Row> rows_ = {};
};

}  // namespace asperity::cli
