#include "made_textures.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

namespace asperity::textures {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
using Random = std::mt19937_64;

// Isotropic Gaussian fields of unit variance, whose plans are made once for each shape.
class Isotropic {
 public:
  enum class Kind { exponential, gaussian };
  Isotropic(Kind shape, double length) : length_(length) {
    texture_.correlation = [shape, length](double x, double y) {
      const double r = std::hypot(x, y) / length;
      return std::exp(shape == Kind::gaussian ? -r * r : -r);
    };
  }
  Field operator()(Shape shape, Random& random) const {
    auto& draw = (*draws_)[{shape.nx, shape.ny}];
    if (!draw) draw = std::make_shared<Draw>(texture_, shape, static_cast<Index>(8 * length_) + 1);
    return (*draw)(random);
  }

 private:
  Texture texture_ = {};
  double length_;
  using Draws = std::map<std::pair<Index, Index>, std::shared_ptr<Draw>>;
  std::shared_ptr<Draws> draws_ = std::make_shared<Draws>();
};

Isotropic rough(double length) { return {Isotropic::Kind::exponential, length}; }
Isotropic smooth(double length) { return {Isotropic::Kind::gaussian, length}; }

double uniform(Random& random) { return std::uniform_real_distribution<>()(random); }

// f(i, j) at all points.
Field over(Shape shape, const auto& f) {
  return Field::NullaryExpr(shape.nx, shape.ny, [&](Index i, Index j) {
    return f(static_cast<double>(i), static_cast<double>(j));
  });
}

// Gaussian grooves along lines at an angle, so many in a length across them on average.
void cut(Field& z, double angle, double a_length, double width, double depth, Random& random) {
  const double nx = static_cast<double>(z.rows()), ny = static_cast<double>(z.cols()),
               reach = std::hypot(nx, ny), c = std::cos(angle), s = std::sin(angle);
  const int count = std::poisson_distribution<>(reach * a_length)(random);
  for (int k = 0; k < count; ++k) {
    const double at = (uniform(random) - 0.5) * reach, deep = depth * (0.5 + uniform(random));
    z -= over(shape_of(z), [&](double i, double j) {
      const double u = ((i - nx / 2) * s + (j - ny / 2) * c - at) / width;
      return std::abs(u) < 4 ? deep * std::exp(-u * u) : 0.0;
    });
  }
}

void scatter(Field& z, double a_point, double width, double height, Random& random) {
  const double margin = 3 * width, nx = static_cast<double>(z.rows()), ny = static_cast<double>(z.cols());
  const int count = std::poisson_distribution<>((nx + 2 * margin) * (ny + 2 * margin) * a_point)(random);
  for (int k = 0; k < count; ++k) {
    const double x = uniform(random) * (nx + 2 * margin) - margin,
                 y = uniform(random) * (ny + 2 * margin) - margin, high = height * (0.5 + uniform(random));
    z += over(shape_of(z), [&](double i, double j) {
      const double r = std::hypot(i - x, j - y) / width;
      return r < 3 ? high * std::exp(-r * r) : 0;
    });
  }
}

Field marks(Shape shape, double apart, const Field& phase) {
  return over(shape, [&](double i, double j) {
    return std::numbers::sqrt2 *
           std::sin(full_turn * j / apart + 3 * phase(static_cast<Index>(i), static_cast<Index>(j)));
  });
}

// On arcs about a centre some way off, every fourth mark deeper: of a cutter of four teeth.
Field arcs(Shape shape, double apart, const Field& phase, Random& random) {
  const double far = 60 * apart * (1 + uniform(random)), angle = full_turn * uniform(random);
  return over(shape, [&](double i, double j) {
    const double r = std::hypot(i - far * std::cos(angle), j - far * std::sin(angle)),
                 turns = r / apart + phase(static_cast<Index>(i), static_cast<Index>(j)) / 2;
    return std::sin(full_turn * turns) + 0.5 * std::sin(full_turn * turns / 4);
  });
}

Field student(const Isotropic& field, Shape shape, Random& random) {
  Field square = Field::Zero(shape.nx, shape.ny);
  for (int k = 0; k < 5; ++k) square += field(shape, random).square() / 5;
  return field(shape, random) / square.sqrt();
}

}  // namespace

std::vector<Texture> made(double l) {
  using Make = std::function<Field(Shape, Random&)>;
  const Isotropic base = rough(l), fine = rough(l / 3), coarse = smooth(3 * l), wandering = smooth(6 * l);
  const std::vector<std::pair<const char*, Make>> all{
      {"patchy",
       [=](Shape shape, Random& random) -> Field {
         return (0.7 * coarse(shape, random) - 0.49).exp() * fine(shape, random);
       }},
      {"strong_patches",
       [=](Shape shape, Random& random) -> Field {
         return (1.2 * coarse(shape, random) - 1.44).exp() * fine(shape, random);
       }},
      {"hatch",
       [=](Shape shape, Random& random) {
         Field z = 0.2 * fine(shape, random);
         for (const double side : {-1, 1}) cut(z, side * full_turn / 12, 0.1 / l, l / 2, 2, random);
         return z;
       }},
      {"turned",
       [=](Shape shape, Random& random) -> Field {
         return marks(shape, 3 * l, wandering(shape, random)) + 0.3 * fine(shape, random);
       }},
      {"milled",
       [=](Shape shape, Random& random) -> Field {
         return arcs(shape, 3 * l, wandering(shape, random), random) + 0.3 * fine(shape, random);
       }},
      {"scratches",
       [=](Shape shape, Random& random) {
         Field z = base(shape, random);
         for (int k = 0; k < 8; ++k) cut(z, full_turn * uniform(random), 0.03 / l, l / 2, 4, random);
         return z;
       }},
      {"dust",
       [=](Shape shape, Random& random) {
         Field z = base(shape, random);
         scatter(z, 0.01 / (l * l), l / 2, 6, random);
         return z;
       }},
      {"t", [=](Shape shape, Random& random) { return student(base, shape, random); }},
      {"two_processes", [=](Shape shape, Random& random) -> Field {
         return (0.3 * fine(shape, random)).min(coarse(shape, random) + 1);
       }}};
  std::vector<Texture> out;
  for (const auto& [name, make] : all) out.push_back({.name = name, .correlation = {}, .make = make});
  return out;
}

}  // namespace asperity::textures
