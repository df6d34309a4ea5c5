/// Plastic flow below a sphere: against finite elements, and its error against its cost.
///
///     flow_error_time [CELLS]         41 unless given
///
/// A sphere of E' = 1, ν = 0.3 and σ_Y/E' = 0.003, perfectly plastic, against a rigid flat, on a domain 1.5
/// contact radii wide each way: pressed to ω* times the approach ω_c at which it yields. One thread.
///
/// Table 1   load over that at ω_c, contact area over π ω_c R, largest pressure and von Mises stress over σ_Y,
///           and dent over approach after unloading, with the fits of Kogut & Etsion 2002 (ke), Jackson & Green
///           2005 (jg) and Etsion, Kligerman & Kadin 2005 (ekk)
///           cut: a contact under the same load whose pressure is limited to 3 σ_Y, with the largest von Mises
///           stress more than two cells below it
/// Table 2   at ω* = 6, by cells, layers or increments: relative errors of load, largest pressure and dent,
///           the reference being the last row of each kind
///
/// The papers of the fits were not at hand. The constants of jg, and of the load of ke, are those of other
/// programs, which agree; those of the area of ke and of ekk are from memory, not confirmed.
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "contact/energy.hpp"
#include "contact/influence.hpp"
#include "plastic/plastic_contact.hpp"
#include "stress/maximum.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr double nu = 0.3, young = 1, plane = young / (1 - nu * nu), yield = 0.003 * plane;
const double first_approach = std::pow(std::numbers::pi * 1.613 * yield / (2 * plane), 2),
             first_load = 4.0 / 3 * plane * std::pow(first_approach, 1.5);

struct Fit {
  double load, area;
};

Fit kogut_etsion(double w) {
  if (w <= 6) return {1.03 * std::pow(w, 1.425), 0.93 * std::pow(w, 1.136)};
  return {1.40 * std::pow(w, 1.263), 0.94 * std::pow(w, 1.146)};
}

Fit jackson_green(double w) {
  const double strain = yield / plane, area = w * std::pow(w / 1.9, 0.14 * std::exp(23 * strain)),
               radius = std::sqrt(area * first_approach),
               hardness_share = 2.84 - 0.92 * (1 - std::cos(std::numbers::pi * radius));
  return {std::exp(-0.25 * std::pow(w, 5.0 / 12)) * std::pow(w, 1.5) +
              4 * hardness_share / 1.613 * (1 - std::exp(-std::pow(w, 5.0 / 9) / 25)) * w,
          area};
}

double dent_after(double w) { return (1 - std::pow(w, -0.28)) * (1 - std::pow(w, -0.69)); }

struct Setting {
  Index cells, layers;
  int increments;
};

struct Pressed {
  double load, area, max_pressure, dent, mises, seconds, evaluations;
};

struct Sphere {
  Sphere(double w, Index cells) : approach(w * first_approach) {
    const double side = 3 * std::sqrt(jackson_green(w).area * first_approach),
                 cell = side / static_cast<double>(cells);
    grid = {{cells, cells}, cell, cell};
    bodies = {{Radii(1.0), Radii()}, {young, std::numeric_limits<double>::infinity()}, {nu, nu}};
    influence = make_influence(grid, plane);
  }
  double approach;
  Grid grid;
  Bodies bodies;
  std::unique_ptr<ElasticOperator> influence;
};

Pressed press(double w, const Setting& setting) {
  const Sphere sphere(w, setting.cells);
  PlasticParameters parameters{.hardening = {Hardening{yield}, Hardening{}}, .layers = setting.layers};
  const Stopwatch watch;
  PlasticContact contact(sphere.grid, undeformed_gap(sphere.grid, sphere.bodies), sphere.bodies,
                         *sphere.influence, {.load = 1}, parameters);
  contact.go_to({.approach = sphere.approach}, setting.increments);
  Pressed out{contact.contact().load / first_load,
              contact.contact().area / (std::numbers::pi * first_approach),
              contact.contact().max_pressure / yield,
              0,
              contact.yield_share(),
              watch.seconds(),
              static_cast<double>(contact.evaluations())};
  contact.go_to({}, 3);
  out.dent = contact.displacement(0).maxCoeff() / sphere.approach;
  return out;
}

struct Cut {
  double approach, area, max_pressure, mises;
};

Cut cut(double w, double load, Index cells) {
  const Sphere sphere(w, cells);
  const Contact contact =
      solve_contact(sphere.grid, undeformed_gap(sphere.grid, sphere.bodies), *sphere.influence,
                    {.load = load * first_load, .limit_pressure = hardness * yield});
  const StressMaximum below = maximum_stress(StressSolver({sphere.grid, contact.pressure, nu}),
                                             {.below = accurate_depth(sphere.grid)});
  return {contact.approach / first_approach, contact.area / (std::numbers::pi * first_approach),
          contact.max_pressure / yield, below.value / yield};
}

void compare(Index cells) {
  fmt::print(
      "# "
      "approach\tload\tload_ke\tload_jg\tarea\tarea_ke\tarea_jg\tp_max\tmises\tdent\tdent_ekk\tcut_approach\t"
      "cut_area\tcut_p_max\tcut_mises\tevaluations\tseconds\n");
  for (const double w : {2.0, 6.0, 10.0, 20.0, 42.0, 70.0}) {
    const Pressed p = press(w, {cells, 16, 12});
    const Fit ke = kogut_etsion(w), jg = jackson_green(w);
    const Cut limited = cut(w, p.load, cells);
    fmt::print("{}", w);
    for (const double v : {p.load, ke.load, jg.load, p.area, ke.area, jg.area}) fmt::print("\t{:.4g}", v);
    fmt::print("\t{:.3f}\t{:.5f}\t{:.4f}\t{:.4f}", p.max_pressure, p.mises, p.dent, dent_after(w));
    fmt::print("\t{:.4g}\t{:.4g}\t{:.3f}\t{:.3f}\t{}\t{:.2f}\n", limited.approach, limited.area,
               limited.max_pressure, limited.mises, p.evaluations, p.seconds);
  }
}

void converge(Index cells) {
  fmt::print(
      "\n# by\tcells\tlayers\tincrements\tload\tp_max\tdent\tload_error\tp_max_error\tdent_error\tseconds\n");
  const std::vector<std::pair<const char*, std::vector<Setting>>> kinds{
      {"cells", {{cells / 2, 16, 8}, {cells, 16, 8}, {3 * cells / 2, 16, 8}, {2 * cells, 16, 8}}},
      {"layers", {{cells, 8, 8}, {cells, 12, 8}, {cells, 16, 8}, {cells, 24, 8}, {cells, 32, 8}}},
      {"increments", {{cells, 16, 2}, {cells, 16, 4}, {cells, 16, 8}, {cells, 16, 16}, {cells, 16, 32}}}};
  for (const auto& [by, settings] : kinds) {
    std::vector<Pressed> all;
    for (const Setting& s : settings) all.push_back(press(6, s));
    const Pressed& last = all.back();
    for (std::size_t n = 0; n < all.size(); ++n) {
      const auto& [s, p] = std::pair(settings[n], all[n]);
      fmt::print("{}\t{}\t{}\t{}\t{:.5g}\t{:.4f}\t{:.4f}\t{:.1e}\t{:.1e}\t{:.1e}\t{:.2f}\n", by, s.cells,
                 s.layers, s.increments, p.load, p.max_pressure, p.dent, std::abs(p.load / last.load - 1),
                 std::abs(p.max_pressure / last.max_pressure - 1), std::abs(p.dent / last.dent - 1),
                 p.seconds);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Index cells = argc > 1 ? std::atoi(argv[1]) : 41;
  compare(cells);
  converge(cells);
}
