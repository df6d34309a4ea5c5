// Declared, not written yet.
#include <stdexcept>

#include "stats/filter/curved_form.hpp"
#include "stats/filter/median_filter.hpp"
#include "stats/filter/morphology.hpp"
#include "stats/filter/resampling.hpp"
#include "stats/filter/robust_gaussian.hpp"
#include "stats/filter/rotation.hpp"
#include "stats/filter/spline_filter.hpp"

namespace asperity {
namespace {

[[noreturn]] void pending() { throw std::logic_error("this filter is not written yet"); }

}  // namespace

double CurvedForm::height(double, double) const { pending(); }
CurvedForm fit_curved_form(const Field&, const Grid&, CurvedShape, int) { pending(); }
Field above_form(const Field&, const Grid&, const CurvedForm&) { pending(); }
RobustMeanSurface robust_gaussian_mean_surface(const Field&, const Grid&, double, int, int, int) {
  pending();
}
Field spline_mean_surface(const Field&, const Grid&, double, int) { pending(); }
Field dilation(const Field&, const Grid&, StructuringElement, int) { pending(); }
Field erosion(const Field&, const Grid&, StructuringElement, int) { pending(); }
Field closing(const Field&, const Grid&, StructuringElement, int) { pending(); }
Field opening(const Field&, const Grid&, StructuringElement, int) { pending(); }
Shape median_window(const Grid&, double) { pending(); }
Field median_surface(const Field&, const Grid&, Shape, int) { pending(); }
WithoutOutliers without_outliers(const Field&, const Grid&, Shape, double, int) { pending(); }
Grid resampled_grid(const Grid&, double, double) { pending(); }
Field resampled(const Field&, const Grid&, double, double, int) { pending(); }
Grid rotated_grid(const Grid&, double) { pending(); }
Field rotated(const Field&, const Grid&, double, int) { pending(); }

}  // namespace asperity
