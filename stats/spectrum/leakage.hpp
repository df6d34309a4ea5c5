/// Wave numbers at which a spectrum holds nothing but what leaks from others.
///
/// A field that is not periodic is cut off by its window, of transform W, which spreads each wave over all
/// wave numbers. The n-th one beside it has on average, beyond the main lobe,
///     κ(n) = ∫_{n-½}^{n+½} W² df / ∫ W² df,     W = sinc f, n ≥ 1;   Hann's sinc f/(1 - f²), n ≥ 2.   (1)
/// A spectrum C that falls more steeply ends in the leakage
///     L(k) = Σ_j C(j) [κ(k - j) + κ(k + j)],                                                            (2)
/// which says nothing of the surface. Where L exceeds a tenth of C, three tenths without a window, the
/// density has no error; of a flat spectrum without a window it is 0.23, as much as leaks away. The same sum
/// over rings stands for the lines of wave numbers through the origin, which leak most.
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
/// where more may be leakage.
void withhold_leakage(std::vector<SpectrumPoint>& points, Index first, DataWindow window);

}  // namespace asperity
