/// A kernel and its autocorrelation in a dataset.
///
///     kernel(k, l)         as z(i,j) = Σ kernel(k,l) η(i+k, j+l) applies it
///     acf_target(p, q)     over the half plane p = 0…, q = -…0…+
///     acf_achieved(p, q)   the same lags
/// in m and m2, or in units of the rms height where none is given; lags in metres, or in samples where no
/// spacing is known. Heights that are not Gaussian are a translation of what the kernel, of unit variance, averages
/// (marginal_dataset.hpp). That of a periodic surface has kernel_period (kernel_period.hpp). Global attributes kernel_* hold the effective parameters and what the
/// solve achieved.
#pragma once

#include <limits>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "dataset/variable_units.hpp"
#include "tools/surface/kernel_options.hpp"

namespace asperity::cli {

struct KernelTables {
  Field kernel, acf_target, acf_achieved;
  bool has_height = false;           ///< in m and m2, not in units of the rms height
  Spacing spacing;                   ///< of the lags
  bool translated = false;           ///< the kernel's variance is 1 whatever the heights'
  std::optional<Shape> period = {};  ///< of the surfaces that it is for, all others apart

  double rms() const { return std::sqrt(acf_target(0, acf_target.cols() / 2)); }
  void scale(double factor) {
    if (!translated) kernel *= factor;
    acf_target *= factor * factor;
    acf_achieved *= factor * factor;
  }
};

/// A pair of counts as an attribute has it.
inline Values pair_of(Shape s) {
  return std::vector<std::int32_t>{static_cast<std::int32_t>(s.nx), static_cast<std::int32_t>(s.ny)};
}

inline std::optional<Shape> kernel_period(const Dataset& data) {
  const Values* const found = data.attributes.find("kernel_period");
  if (found == nullptr) return std::nullopt;
  const std::vector<double> sides = numbers(*found);
  if (sides.size() != 2 || !(sides[0] >= 1 && sides[1] >= 1 && sides[0] <= 1e9 && sides[1] <= 1e9))
    throw DataError("kernel_period", "is no pair of counts");
  return Shape{static_cast<Index>(sides[0]), static_cast<Index>(sides[1])};
}

inline void set_kernel(Dataset& data, const KernelTables& tables) {
  const std::string_view height = tables.has_height ? "m" : "1", variance = tables.has_height ? "m2" : "1";
  const std::string_view lag = tables.spacing ? "m" : "1";
  const auto [dx, dy] = tables.spacing.value_or(std::array{1.0, 1.0});
  const Axis p{"p", 0, dx, lag, "lag in x"};
  const Axis q{"q", -(tables.acf_target.cols() / 2), dy, lag, "lag in y"};
  set_table(data, "kernel", tables.kernel, {"k", 0, 1, "1", "row of noise"},
            {"l", 0, 1, "1", "column of noise"},
            {tables.translated ? "1" : height, "moving-average kernel of unit white noise"});
  set_table(data, "acf_target", tables.acf_target, p, q, {variance, "autocorrelation asked for"},
            Missing::not_a_number);
  set_table(data, "acf_achieved", tables.acf_achieved, p, q, {variance, "autocorrelation of the kernel"});
  data.attributes.set("kernel_rms", tables.rms());
  if (tables.period)
    data.attributes.set_values("kernel_period", pair_of(*tables.period));
  else
    data.attributes.erase("kernel_period");
}

/// Whether a table is in m2, or another square of a length, and not a pure number. Throws DataError for any other unit.
inline bool has_height(const Variable& acf) {
  const std::string unit = unit_of(acf);
  return !unit.empty() && unit != "1" && factor_to("m2", acf) > 0;
}

/// From the lags p and q; of a single lag, from the grid, or else from the other's.
inline Spacing lag_spacing(const Dataset& data) {
  const auto p = lags_of(data.at("p")), q = lags_of(data.at("q"));
  if (!p || !q) return std::nullopt;
  auto step = [](const char* name, const std::vector<double>& lags) {
    if (lags.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    if (!(lags[1] > lags[0])) throw DataError(name, "its lags do not grow");
    return lags[1] - lags[0];
  };
  double dx = step("p", *p), dy = step("q", *q);
  if ((std::isnan(dx) || std::isnan(dy)) && data.has("x") && data.has("y")) {
    const Grid grid = grid_of(data);
    if (std::isnan(dx)) dx = grid.dx;
    if (std::isnan(dy)) dy = grid.dy;
  }
  if (std::isnan(dx) && std::isnan(dy)) return std::nullopt;
  return std::array{std::isnan(dx) ? dy : dx, std::isnan(dy) ? dx : dy};
}

/// Throws DataError when a table is missing or makes no sense.
inline KernelTables kernel_of(const Dataset& data) {
  const bool height = has_height(data.at("acf_target")),
             translated = data.attributes.find("kernel_heights") != nullptr;
  const char* const variance = height ? "m2" : "1";
  KernelTables tables{table_of(data, "kernel", height && !translated ? "m" : "1"),
                      table_of(data, "acf_target", variance, Missing::not_a_number),
                      table_of(data, "acf_achieved", variance),
                      height,
                      {},
                      translated,
                      kernel_period(data)};
  if (tables.kernel.size() == 0) throw DataError("kernel", "it has no coefficients");
  if (shape_of(tables.acf_target) != shape_of(tables.acf_achieved))
    throw DataError("acf_achieved", "its lags are not those of acf_target");
  if (tables.acf_target.cols() % 2 == 0 || !(tables.rms() > 0))
    throw DataError("acf_target", "its middle column does not begin with the variance");
  const double variance_of_kernel = tables.kernel.square().sum(),
               told = translated ? 1 : tables.acf_achieved(0, tables.acf_achieved.cols() / 2);
  if (!(std::abs(variance_of_kernel - told) <= 1e-6 * told))
    throw DataError("kernel", "the sum of its squares, " + shortest(variance_of_kernel) +
                                  ", is not the variance that it stands for, " + shortest(told) +
                                  ": one of them was changed; solve for the kernel anew");
  tables.spacing = lag_spacing(data);
  return tables;
}

}  // namespace asperity::cli
