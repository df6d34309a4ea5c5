/// The scenes on which contact solvers are measured.
///
///     smooth            two steel spheres, R = 50 mm, E = 208 GPa, ν = 0.3, Q = 5000 N, on 3 mm × 3 mm
///     rough             the same with Gaussian roughness of 0.4 µm rms and exponential autocorrelation, 10 % length
///                       0.328 mm
///     rough, limited    the same with the pressure limited to 3600 MPa
///     periodic, tenth   periodic self-affine surface, Hurst exponent 0.8, roll-off at 4 and cut-off at 32 periods a
///                       side, rms slope 1, mean pressure 0.045 E*: a tenth in contact
///     periodic, most    the same, mean pressure 0.8 E*: nine tenths in contact
///     smooth, oblong    the smooth spheres on 4n × n cells
#pragma once

#include <string>
#include <vector>

#include "contact/bodies.hpp"
#include "core/field.hpp"

namespace asperity {

struct ContactScene {
  std::string name;
  Grid grid;
  Field gap = {};
  double composite_modulus = 0, load = 0, limit_pressure = 0;
};

inline constexpr double scene_load = 5000;
inline const Bodies scene_bodies{.radius = {50e-3, 50e-3}};

inline constexpr const char* contact_scene_names[] = {"smooth",          "rough",          "rough, limited",
                                                      "periodic, tenth", "periodic, most", "smooth, oblong"};

/// One of these on n × n cells. Rough ones sample one realisation of 1024 × 1024.
ContactScene contact_scene(const std::string& name, Index n);

}  // namespace asperity
