#include "contact/ratios.hpp"

#include <cmath>

#include "contact/bodies.hpp"

namespace asperity {
namespace {

void set_flat(ContactRatios& out, const Grid& grid, double modulus, const GapRoughness& gap,
              const Contact& contact, double area) {
  const double nominal = grid.size_x() * grid.size_y();
  out.area_share = area / nominal;
  if (gap.rms_slope > 0) {
    out.reduced_pressure = contact.load / nominal / (modulus * gap.rms_slope);
    out.kappa = out.area_share / out.reduced_pressure;
  }
  if (gap.rms_height > 0) out.reduced_gap = contact.mean_gap / gap.rms_height;
}

}  // namespace

ContactRatios contact_ratios(const Grid& grid, const Bodies& bodies, const GapRoughness& gap,
                             double limit_pressure, const Contact& contact, double area) {
  ContactRatios out;
  const double modulus = bodies.composite_modulus();
  if (bodies.flat()) set_flat(out, grid, modulus, gap, contact, area);
  if (has_point_contact(bodies) && bodies.curvature_x() == bodies.curvature_y()) {
    const double a0 = hertz(bodies, contact.load).radius;
    out.sphere_roughness = gap.rms_height / (bodies.curvature_x() * a0 * a0);
  }
  if (std::isfinite(limit_pressure) && gap.summit_curvature > 0)
    out.plasticity_index = modulus / limit_pressure * std::sqrt(gap.summit_deviation * gap.summit_curvature);
  return out;
}

ContactRatios ratio_errors(const ContactRatios& ratios, const GapRoughness& gap, const Contact& contact,
                           double area, const GridErrors& errors, double load_error) {
  const double of_area = errors.area_corrected / area,
               of_pressure = load_error / contact.load + gap.rms_slope_error / gap.rms_slope;
  ContactRatios out;
  out.area_share = ratios.area_share * of_area;
  out.reduced_pressure = ratios.reduced_pressure * of_pressure;
  out.kappa = ratios.kappa * (of_area + of_pressure);
  out.reduced_gap = errors.mean_gap / gap.rms_height;
  return out;
}

}  // namespace asperity
