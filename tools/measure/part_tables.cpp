#include "tools/measure/part_tables.hpp"

#include "stats/height/part_distribution.hpp"
#include "tools/measure/field_options.hpp"

namespace asperity::cli {

Table histogram_of(const CountedCells& part, int bins, double largest) {
  const std::string density = unit_to(part.units, -1);
  Table out{{{part.variable, part.units},
             {"count", "1"},
             {"standard_error", "1", Holds::unknown},
             {"share", "1"},
             {"density", density},
             {"density_error", density, Holds::unknown}},
            {}};
  for (const PartBin& bin : part_histogram(part.values, bins, largest)) {
    const double per = 1 / (part.counted * bin.width());
    out.rows.push_back({bin.centre(), bin.count, bin.count_error, bin.count / part.cells, bin.count * per,
                        bin.count_error * per});
  }
  return out;
}

Table quantiles_of(const CountedCells& part, int rows, int threads) {
  Table out{{{"share", "1"}, {part.variable, part.units}, {"standard_error", part.units, Holds::unknown}},
            {}};
  for (const PartQuantile& q : part_quantiles(part.values, rows, threads))
    out.rows.push_back({q.share, q.value, q.error});
  return out;
}

}  // namespace asperity::cli
