/// The scenes on which contact solvers are measured.
///
///     A         two smooth steel spheres, R = 50 mm, E = 208 GPa, ν = 0.3, Q = 5000 N, on 3 mm × 3 mm
///     B, B2     A with Gaussian roughness of 0.4 µm rms and exponential autocorrelation, 10 % length 0.328 mm; B2
///               with the pressure limited to 3600 MPa
///     C10, C90  periodic self-affine surfaces, Hurst exponent 0.8, roll-off at 4 and cut-off at 32 periods a side,
///               rms slope 1, mean pressure 0.045 and 0.8 E*: a tenth and nine tenths in contact
///     D         A on 4n × n cells
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

/// "A", "B", "B2", "C10", "C90" or "D" on n × n cells. Rough ones sample one realisation of 1024 × 1024.
ContactScene contact_scene(const std::string& name, Index n);

}  // namespace asperity
