/// A kernel and its autocorrelation in a dataset.
///
///     kernel(k, l)         as z(i,j) = Σ kernel(k,l) η(i+k, j+l) applies it
///     acf_target(p, q)     over the half plane p = 0…, q = -…0…+
///     acf_achieved(p, q)   the same lags
/// in m and m2, or in units of the rms height; lags in metres, or in samples where no spacing is known.
/// A surface has no kernel unless asked for, and of its autocorrelation the lags that errors ask for.
/// Heights that are not Gaussian are a translation of what the kernel, of unit variance, averages
/// (marginal.hpp). Global attributes kernel_* hold the parameters and what was achieved.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "acf/kernel.hpp"
#include "core/field.hpp"
#include "dataset/dataset.hpp"

namespace asperity::cli {

/// Spacing of the samples in x and y [m], where it is known.
using Spacing = std::optional<std::array<double, 2>>;

/// The spacing of `shape` samples on `size`; throws UsageError("size") unless that is positive.
Spacing spacing_of(Shape shape, std::array<double, 2> size);
/// Throws UsageError(option) if the spacing that it gives differs from that of `whose` ("the table has") by
/// more than `tolerance`; an unknown spacing agrees with any.
void require_spacing(const std::string& option, const std::string& gives, const Spacing& given,
                     const std::string& whose, const Spacing& known, double tolerance);

struct KernelTables {
  Field kernel, acf_target, acf_achieved;
  bool has_height = false;           ///< in m and m2, not in units of the rms height
  Spacing spacing;                   ///< of the lags
  bool translated = false;           ///< the kernel's variance is 1 whatever the heights'
  std::optional<Shape> period = {};  ///< of the surfaces that it is for, all others apart
  std::optional<Shape> corner = {};  ///< or the largest surface that is a corner of one of that period

  double rms() const { return std::sqrt(acf_target(0, acf_target.cols() / 2)); }
  void scale(double factor);
};

/// Whether a table is in m2, or another square of a length, and not a pure number. Throws DataError for any
/// other unit.
bool has_height(const Variable& acf);
/// Throws DataError when a table is missing or makes no sense. Without coefficients where the dataset has
/// none.
KernelTables kernel_of(const Dataset& data);
void set_kernel(Dataset& data, const KernelTables& tables);
/// All but the coefficients.
void set_correlation(Dataset& data, const KernelTables& tables);

/// The attributes kernel_period and kernel_corner.
std::optional<Shape> kernel_period(const Dataset& data);
std::optional<Shape> kernel_corner(const Dataset& data);
/// A pair of counts as an attribute has it.
Values pair_of(Shape s);

// ---- the attributes kernel_* ----

/// The parameters of a model, its lengths in samples.
void record_model(Attributes& attributes, const EllipticTarget& model);
/// The request apart from the target, and what the solution achieved.
void record_kernel(Attributes& attributes, const KernelRequest& request, const Kernel& kernel);

/// What a solution achieved, less its answer and its counts; residual and error are NAN where the dataset
/// has none.
KernelReport recorded_report(const Attributes& attributes);
/// The tolerance of its errors.
double recorded_tolerance(const Attributes& attributes);

}  // namespace asperity::cli
