/// Stated against true errors of the grid: random contacts on n cells a side, and the same surface on 4n.
///
///     contact_grid_error [SCENES [LARGEST_N [SEED [N [HARD]]]]]
///
/// SCENES (252) of contact_grid_scenes.hpp, in turn on n = 64 to 512 cells; 4n is no more than LARGEST_N
/// (2048). With N all scenes are on N cells a side. Then HARD scenes (0), on n = 48 to 128 cells, from
/// SEED + 2; their truth is on 8n where n is 64 or less. Scenes that touch the edge of a free domain, and
/// hard ones that the grid does not resolve, are drawn again.
///
/// First table, by kind and figure; `all` scenes, `fine` ones of them, on more than 128 cells a side, and all
/// `hard` ones:
///
/// scenes        those that the grid resolves (stats/hybrid/slopes.hpp), and whose figure has an error
/// unresolved    those it does not: they get none
/// within        share of the scenes whose true error is no more than the stated one
/// ratio         median of stated over true
/// true, stated  medians, relative to the figure
///
/// Second table, by n: what the errors cost: seconds of the coarser contacts over those of the contact.
/// Third table, by scene: the figure, its true and its stated error, in SI units.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "contact/energy.hpp"
#include "contact/grid_error.hpp"
#include "contact/influence.hpp"
#include "contact/outline.hpp"
#include "contact/ratios.hpp"
#include "contact_grid_scenes.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stress/layers.hpp"
#include "stress/maximum.hpp"
#include "stress/maximum_error.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

using namespace grid_scenes;

struct Solved {
  Index times;  // as many cells a side
  Grid grid;
  Field gap;
  std::unique_ptr<ElasticOperator> influence;
  ContactParameters parameters;
  Contact contact;

  Solved(const Scene& s, Index cells)
      : times(cells),
        grid(s.grid(times)),
        gap(s.gap(times)),
        influence(make_influence(grid, modulus, 2)),
        parameters{.limit_pressure = s.limit, .tolerance = 1e-8, .stiffness = true, .threads = 2} {
    if (s.approach > 0)
      parameters.approach = s.approach;
    else
      parameters.load = s.load;
    contact = solve_contact(grid, gap, *influence, parameters);
  }

  bool at_edge() const {
    const Field& p = contact.pressure;
    return !grid.periodic.any() &&
           (p.row(0).sum() + p.row(p.rows() - 1).sum() + p.col(0).sum() + p.col(p.cols() - 1).sum()) > 0;
  }
  double corrected() const {
    return corrected_area(grid, contact, outline(grid, contact), parameters.limit_pressure);
  }
  double plastic() const {
    return contact.plastic_area + 0.1 * outline(grid, contact, Contact::plastic).sides() * grid.cell_area();
  }
};

LoadedBody loaded(const Scene& scene, const Grid& grid, const Contact& contact) {
  return {grid, contact.pressure, 0.3, {scene.friction, 0}};
}

StressMaximum largest_stress(const Scene& scene, const Grid& grid, const Contact& contact) {
  return maximum_stress(StressSolver(loaded(scene, grid, contact), 2));
}

// Of one figure in one scene.
struct Judgement {
  double value = 0, error = 0, stated = 0;
};

struct Row {
  const char* kind;
  Index n;
  std::string figure;
  double value, error, stated;
};

struct Tally {
  std::vector<Judgement> all;
  Index unresolved = 0;
};

double median(std::vector<double> values) {
  if (values.empty()) return NAN;
  std::ranges::sort(values);
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

class Page {
 public:
  void add(const Scene& scene, const std::string& figure, double value, double truth, double stated) {
    if (!(stated > 0)) return;  // none, or exact
    rows_.push_back({kinds[scene.kind], scene.shape.nx, figure, value, std::abs(value - truth), stated});
    for (const char* kind : groups(scene))
      tallies_[{kind, figure}].all.push_back({std::abs(truth), std::abs(value - truth), stated});
  }
  void leave_out(const Scene& scene) {
    for (const char* kind : groups(scene)) ++unresolved_[kind];
  }
  void cost(const Scene& scene, double contact, double coarser) {
    seconds_[scene.shape.nx].push_back({contact, coarser});
  }
  void print() {
    fmt::print("# kind\tfigure\tscenes\tunresolved\twithin\tratio\ttrue\tstated\n");
    for (auto& [key, tally] : tallies_) {
      std::vector<double> ratio, error, stated;
      double within = 0;
      for (const Judgement& j : tally.all) {
        within += j.error <= j.stated;
        if (j.error > 0) ratio.push_back(j.stated / j.error);
        error.push_back(j.error / j.value);
        stated.push_back(j.stated / j.value);
      }
      fmt::print("{}\t{}\t{}\t{}\t{:.2f}\t{:.2g}\t{:.1e}\t{:.1e}\n", key.first, key.second, tally.all.size(),
                 unresolved_[key.first], within / static_cast<double>(tally.all.size()), median(ratio),
                 median(error), median(stated));
    }
    fmt::print("# n\tscenes\tshare\n");
    for (auto& [n, list] : seconds_) {
      double contact = 0, coarser = 0;
      for (const auto& [one, other] : list) contact += one, coarser += other;
      fmt::print("{}\t{}\t{:.2f}\n", n, list.size(), coarser / contact);
    }
    fmt::print("# kind\tn\tfigure\tvalue\terror\tstated\n");
    for (const Row& r : rows_)
      fmt::print("{}\t{}\t{}\t{:.4g}\t{:.1e}\t{:.1e}\n", r.kind, r.n, r.figure, r.value, r.error, r.stated);
  }

 private:
  static std::vector<const char*> groups(const Scene& scene) {
    if (scene.kind >= first_hard) return {kinds[scene.kind], "hard"};
    std::vector<const char*> out{kinds[scene.kind], "all"};
    if (scene.shape.nx > 128) out.push_back("fine");
    return out;
  }

  std::map<std::pair<std::string, std::string>, Tally> tallies_;
  std::map<std::string, Index> unresolved_;
  std::map<Index, std::vector<std::pair<double, double>>> seconds_;
  std::vector<Row> rows_;
};

// As if both bodies were flat, so that rough spheres tell of free domains.
void judge_ratios(Page& page, const Scene& scene, const Solved& here, const Solved& truth,
                  const GridErrors& errors) {
  struct Measured {
    GapRoughness gap;
    ContactRatios ratios;
  };
  auto measured = [&](const Solved& s) {
    const Field z = scene.heights(s.times);
    const RmsSlope slope = rms_slope(z, s.grid);
    Measured out{{.rms_height = std::sqrt((z - z.mean()).square().mean()),
                  .rms_slope = slope.value,
                  .rms_slope_error = slope.error},
                 {}};
    const Bodies flats{.young = scene.bodies.young, .poisson = scene.bodies.poisson};
    out.ratios = contact_ratios(s.grid, flats, out.gap, scene.limit, s.contact, s.corrected());
    return out;
  };
  const auto [gap, found] = measured(here);
  const auto [fine_gap, exact] = measured(truth);
  const ContactRatios e = ratio_errors(found, gap, here.contact, here.corrected(), errors,
                                       here.parameters.approach ? errors.load : 0);
  page.add(scene, "rms_slope", gap.rms_slope, fine_gap.rms_slope, gap.rms_slope_error);
  page.add(scene, "reduced_pressure", found.reduced_pressure, exact.reduced_pressure, e.reduced_pressure);
  page.add(scene, "kappa", found.kappa, exact.kappa, e.kappa);
  page.add(scene, "reduced_gap", found.reduced_gap, exact.reduced_gap, e.reduced_gap);
}

bool resolved(const Scene& scene) {
  return scene.rms == 0 || slope_growth(scene.gap(1), scene.grid(1)).resolved() != Resolved::no;
}

void judge(Page& page, const Scene& scene, const Solved& here) {
  if (!resolved(scene)) return page.leave_out(scene);
  const Contact& c = here.contact;
  const CoarserContacts coarser =
      coarser_contacts(here.grid, here.gap, *here.influence, c, here.parameters, scene.bodies);
  page.cost(scene, c.seconds, coarser.seconds);
  const GridErrors e = grid_errors(here.grid, c, coarser);
  const Solved truth(scene, scene.kind >= first_hard && scene.shape.nx <= 64 ? 2 * finer : finer);
  const Contact& t = truth.contact;
  page.add(scene, "max_pressure", c.max_pressure, t.max_pressure,
           c.plastic_area > 0 && t.plastic_area > 0 ? NAN : e.max_pressure);
  page.add(scene, "area", c.area, truth.corrected(), e.area);
  page.add(scene, "area_corrected", here.corrected(), truth.corrected(), e.area_corrected);
  if (c.plastic_area > 0) page.add(scene, "plastic_area", c.plastic_area, truth.plastic(), e.plastic_area);
  page.add(scene, "load", c.load, t.load, e.load);
  page.add(scene, "approach", c.approach, t.approach, e.approach);
  page.add(scene, "mean_gap", c.mean_gap, t.mean_gap, e.mean_gap);
  page.add(scene, "stiffness", c.stiffness, t.stiffness, e.stiffness);
  page.add(scene, "elastic_energy", elastic_energy(here.grid, c), elastic_energy(truth.grid, t),
           e.elastic_energy);
  if (c.plastic_area > 0)
    page.add(scene, "plastic_work", plastic_work(here.grid, c, scene.limit),
             plastic_work(truth.grid, t, scene.limit), e.plastic_work);
  if (scene.rms > 0) judge_ratios(page, scene, here, truth, e);
  const StressMaximum largest = largest_stress(scene, here.grid, c),
                      exact = largest_stress(scene, truth.grid, t);
  const StressMaximum of_stress =
      maximum_error(loaded(scene, here.grid, c),
                    {largest, largest_stress(scene, coarser.grid[0], coarser.contact[0]),
                     largest_stress(scene, coarser.grid[1], coarser.contact[1])},
                    {}, c.plastic_area > 0);
  page.add(scene, "von_mises", largest.value, exact.value, of_stress.value);
  page.add(scene, "depth", largest.depth, exact.depth, of_stress.depth);
}

// Whether the scene counts; otherwise another is drawn.
bool judged(Page& page, const Scene& scene) {
  const bool hard = scene.kind >= first_hard;
  if (hard && !resolved(scene)) return false;
  const Solved here(scene, 1);
  const double least = hard ? 25 : 50;  // cells in contact
  if (!here.contact.converged || here.at_edge() || here.contact.area < least * here.grid.cell_area())
    return false;
  judge(page, scene, here);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const int scenes = argc > 1 ? std::atoi(argv[1]) : 252;
  const Index largest = argc > 2 ? std::atol(argv[2]) : 2048;
  const auto seed = argc > 3 ? static_cast<std::uint64_t>(std::atol(argv[3])) : 1;
  const Index n = argc > 4 ? std::atol(argv[4]) : 0;
  const int hard = argc > 5 ? std::atoi(argv[5]) : 0;
  Page page;
  Draw draw(seed, n), of_hard(seed + 2, n);
  for (int k = 0; k < scenes; ++k)
    for (int tries = 0; tries < 20; ++tries)
      if (judged(page, draw.scene(static_cast<std::size_t>(k), largest))) break;
  for (int k = 0; k < hard; ++k)
    for (int tries = 0; tries < 20; ++tries)
      if (judged(page, of_hard.hard_scene(static_cast<std::size_t>(k)))) break;
  page.print();
}
