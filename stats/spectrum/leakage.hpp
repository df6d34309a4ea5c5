/// Wave numbers at which a spectrum holds nothing but what leaks from others.
///
/// A field that is not periodic is cut off by its window, which spreads each wave over all wave numbers. Of a
/// wave between two wave numbers the n-th one, and beyond the main lobe, has on average the share
///     κ(n) = 1/(3π² n² (n² - 1)²),  n ≥ 2, with Hann's window,     1/(2π² n²),  n ≥ 1, without one.     (1)
/// A spectrum C that falls more steeply ends in the leakage
///     L(k) = Σ_j C(j) [κ(k - j) + κ(k + j)],                                                            (2)
/// which says nothing of the surface. Where L exceeds a quarter of C, the density has no error; of a flat
/// spectrum without a window it is a sixth, as much as leaks away. The same sum over rings stands for the
/// lines of wave numbers through the origin, which leak most.
///
/// Scope     means over profiles and rings; not along a periodic axis, where nothing leaks.
/// Cost      the square of the number of points, 10 operations each.
///
/// F. J. Harris, Proc. IEEE 66 (1978) 51-83, for the lobes of windows.
#pragma once

#include <vector>

#include "stats/spectrum/spectrum.hpp"

namespace asperity {

/// Takes the errors of points whose neighbours are one wave number apart, the first at wave number `first`,
/// where more than a quarter may be leakage.
void withhold_leakage(std::vector<SpectrumPoint>& points, Index first, DataWindow window);

}  // namespace asperity
