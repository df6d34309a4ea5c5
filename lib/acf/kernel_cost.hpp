/// What a kernel costs, known before it is solved for.
///
/// A search begins with the lags prescribed, those of a table, or those beyond which the target has fallen to
/// 5 acf_tolerance, and may go on to more, a fifth at a time. With a tool's tables a kernel of n × m lags
/// takes
///     1500 n m bytes (160 n m of them in a dataset),                                                    (1)
/// or, if it needs a wider one (exponentials of more than about 300 lags) or is the root of a spectrum,
///     250 f² n m bytes (40 f² n m of them in a dataset), f = 4, or more for tables of long waves.        (2)
///
/// Accuracy  the peaks of asperity-kernel are 0.2 to 0.8 times these at 70² to 550² lags, those of
///           asperity-generate 0.5 to 1, and up to 15 MB that the allocator keeps.
#pragma once

#include "acf/kernel.hpp"

namespace asperity {

/// Throws ParameterError("lags") where they are open and the target does not say how far it reaches.
Shape first_lags(const KernelRequest& request);

struct KernelCost {
  double memory, dataset;  ///< [byte]
};
KernelCost kernel_cost(Shape lags);                         ///< (1)
KernelCost wider_kernel_cost(Shape lags, Index torus = 4);  ///< (2)

/// 150 bytes per point of the torus of acf/periodic.hpp, including 8 in a dataset and 8 for its tables.
KernelCost periodic_kernel_cost(Shape torus);

/// Throws ParameterError("memory") where that is more than the request allows.
void check_memory(const KernelRequest& request, Shape lags, KernelCost cost);
/// The same for a kernel on a torus, given its number of bytes.
void check_memory(KernelCost cost, double memory, Shape torus);

}  // namespace asperity
