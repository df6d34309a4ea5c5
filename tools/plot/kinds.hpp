/// The kinds of figures.
#pragma once

#include "tools/plot/figure.hpp"
#include "tools/plot/request.hpp"

namespace asperity::plot {

/// A field in false colours, scales equal along x and y; several cases share their colours.
Figure map(const Cases& cases, const Request& request);
/// The contact state: open, elastic, at the limit pressure.
Figure contact(const Cases& cases, const Request& request);
/// A field in perspective, the heights enlarged by a round factor that is stated.
Figure surface(const Cases& cases, const Request& request);
/// A field along x and along y; several cases share the axes.
Figure profile(const Cases& cases, const Request& request);
/// Both profile autocorrelations: the target, the kernel's, the surface's with two standard errors.
Figure acf(const Cases& cases, const Request& request);
/// The histogram of the heights with standard errors, and the Gaussian of the same mean and rms.
Figure pdf(const Cases& cases, const Request& request);
/// A volume's field in a vertical section, depth downwards.
Figure section(const Cases& cases, const Request& request);

}  // namespace asperity::plot
