/// The study of 2009 again: what the autocorrelation lengths of a roughness change in a contact, and what
/// they leave.
///
///     paper_study [SEEDS]         50 unless given
///
/// Two steel spheres, R = 50 mm, E = 208 GPa, ν = 0.3, under 5000 N on 3 mm × 3 mm of 128 × 128 cells;
/// pressure limited to 3600 MPa, three times a yield stress of 1200 MPa; one sphere with a roughness of 0.4
/// µm rms. Its autocorrelation is exponential and prescribed at n × m lags, (n,m) as in the study or, where
/// its print is lost, as is likely: (7,4), (3,3), (17,4), (17,14), (13,13). `cut` says what it has fallen to
/// at the last lag: 1 %, so that the 10 % lengths are n/2 × m/2 samples, or 10 %, and they are n × m. Surface
/// k of every case is drawn from the same noise, seed k. Contacts are solved to ε = 1e-8.
///
/// First table: a row a case, the mean over the seeds and, ending in _se, its standard error. The smooth
/// contact first.
///     answer        to the equations of the kernel (acf/kernel.hpp), "exact" or how else they were met
///     Sq, Ssk, Sku  of the heights, the study's Rq [µm], Rsk and Rku
///     length_x, _y  at which the surface's own autocorrelation has fallen to 10 % [samples]; 64 where it has not by then
///     p_max         greatest pressure [MPa]
///     area          real area of contact [mm²]
///     plastic       share of it at the limit pressure
///     von_mises     largest von Mises stress anywhere below the surface [MPa]
///     depth         of it [µm]
///     near          largest von Mises stress two cells below the surface, where cells do not show any more [MPa]
///
/// Second table: the study's findings, each a Student's t test.
///     near-surface  `near` is above `bound` times that of the smooth contact: one-sided
///     shallower     the largest stress lies above `bound` times the smooth contact's depth: one-sided
///     changed       a quantity of the case differs from that of `against`, seed by seed: two-sided, `bound` 0
///     same          a height parameter does not, by more than `bound`: the larger p of two one-sided tests
/// `mean` and `se` are of the ratio or difference tested, that of Sq relative to 0.4 µm; a finding `holds`
/// where p < 0.01, which a test of `changed` says of a case like the other once in a hundred.
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include "acf/kernel.hpp"
#include "contact/influence.hpp"
#include "contact/solver.hpp"
#include "contact_scenes.hpp"
#include "core/parallel.hpp"
#include "reference/exponential_target.hpp"
#include "stats/sample/moments.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/spatial/acf_length.hpp"
#include "stress/equivalent.hpp"
#include "stress/maximum.hpp"
#include "surface/synthesis.hpp"

using namespace asperity;

namespace {

constexpr Index n_cells = 128;
constexpr double side = 3e-3, rms = 0.4e-6, limit_pressure = 3.6e9, level = 0.01;

enum Quantity : Index { sq, ssk, sku, length_x, length_y, p_max, area, plastic, von_mises_max, depth, near };
constexpr std::array<const char*, 11> names{"Sq",   "Ssk",     "Sku",       "length_x", "length_y", "p_max",
                                            "area", "plastic", "von_mises", "depth",    "near"};
using Row = Eigen::Array<double, 1, static_cast<int>(names.size())>;
/// A row a seed, a column a quantity.
using Table = Eigen::Array<double, Eigen::Dynamic, static_cast<int>(names.size()), Eigen::RowMajor>;

struct Case {
  int cut;  ///< [%]
  Index n, m;
  std::string answer = "";
  Table values = {};

  std::string name() const { return fmt::format("{}x{}", n, m); }
};

Grid grid() { return {{n_cells, n_cells}, side / n_cells, side / n_cells}; }

double largest_in_layer(const StressSolver& solver, double z) {
  StressSolver::Workspace work;
  Eigen::ArrayXd row(n_cells);
  double largest = 0;
  solver.layer(z, stress::all, work, [&](Index, const StressRow& s) {
    von_mises(s, {row.data(), s[0].size()});
    largest = std::max(largest, row.maxCoeff());
  });
  return largest;
}

void measure_heights(const Field& z, Row& out) {
  const Moments m = moments(z);
  const LagField acf =
      estimate_autocorrelation(z, grid(), {.max_lag = {n_cells / 2, n_cells / 2}, .level = 0.0});
  auto length = [](const Eigen::ArrayXd& profile) {
    const auto crossing = first_crossing(profile / profile(0), 0.1);
    return crossing ? crossing->lag : static_cast<double>(profile.size() - 1);
  };
  out(sq) = 1e6 * m.sq, out(ssk) = m.ssk, out(sku) = m.sku;
  out(length_x) = length(acf.along_x()), out(length_y) = length(acf.along_y());
}

void press(Field gap, ElasticOperator& influence, Row& out) {
  const Contact c = solve_contact(grid(), std::move(gap), influence,
                                  {.load = scene_load, .limit_pressure = limit_pressure, .tolerance = 1e-8});
  if (!c.converged) throw DataError("pressure", c.reason);
  const StressSolver solver({grid(), c.pressure, scene_bodies.poisson[0]}, 1, DepthResolution::adapted);
  const StressMaximum largest = maximum_stress(solver);
  out(p_max) = 1e-6 * c.max_pressure, out(area) = 1e6 * c.area, out(plastic) = c.plastic_area / c.area;
  out(von_mises_max) = 1e-6 * largest.value, out(depth) = 1e6 * largest.depth;
  out(near) = 1e-6 * largest_in_layer(solver, accurate_depth(grid()));
}

Row smooth_contact() {
  Row out = Row::Constant(NAN);
  press(undeformed_gap(grid(), scene_bodies), *make_influence(grid(), scene_bodies.composite_modulus()), out);
  return out;
}

void run(Case& c, Index seeds) {
  const double lengths_at_cut = c.cut == 1 ? 2 : 1;
  KernelRequest request;
  request.target = ExponentialTarget{static_cast<double>(c.n) / lengths_at_cut,
                                     static_cast<double>(c.m) / lengths_at_cut, 0.1};
  request.lags = {c.n, c.m};
  request.rms = rms;
  const Kernel kernel = solve_kernel(request);
  c.answer = name_of(kernel.report.answer);
  c.values.resize(seeds, Table::ColsAtCompileTime);
  const Synthesis surfaces(kernel.values, grid().shape, {});
  const Field smooth = undeformed_gap(grid(), scene_bodies);
  parallel_ranges(seeds, resolve_threads(0), [&](Index begin, Index end, int) {
    const auto influence = make_influence(grid(), scene_bodies.composite_modulus());
    for (Index k = begin; k < end; ++k) {
      const Field z = surfaces.surface(WhiteNoise(static_cast<std::uint64_t>(k + 1)));
      Row row;
      measure_heights(z, row);
      press(smooth - z, *influence, row);
      c.values.row(k) = row;
    }
  });
}

double mean_error(const Eigen::ArrayXd& x) {
  return std::sqrt((x - x.mean()).square().sum() / static_cast<double>((x.size() - 1) * x.size()));
}

/// p of the mean being `bound` or less.
double p_above(const Eigen::ArrayXd& x, double bound) {
  return gsl_cdf_tdist_Q((x.mean() - bound) / mean_error(x), static_cast<double>(x.size() - 1));
}
double p_changed(const Eigen::ArrayXd& x) { return 2 * std::min(p_above(x, 0), p_above(-x, 0)); }
double p_within(const Eigen::ArrayXd& x, double bound) {
  return std::max(p_above(x, -bound), p_above(-x, -bound));
}

void print_finding(const char* finding, const Case& c, const std::string& against, Quantity quantity,
                   const Eigen::ArrayXd& x, double bound, double p) {
  fmt::print("{}\t{}\t{}\t{}\t{}\t{:.4g}\t{:.2g}\t{:g}\t{:.1e}\t{}\n", finding, c.cut, c.name(), against,
             names[static_cast<std::size_t>(quantity)], x.mean(), mean_error(x), bound, p,
             p < level ? "holds" : "not shown");
}

void print_against_smooth(const Case& c, const Row& smooth) {
  const Eigen::ArrayXd stress = c.values.col(near) / smooth(near),
                       place = c.values.col(depth) / smooth(depth);
  print_finding("near-surface", c, "smooth", near, stress, 1.5, p_above(stress, 1.5));
  print_finding("shallower", c, "smooth", depth, place, 0.5, p_above(-place, -0.5));
}

void print_against(const Case& c, const Case& other) {
  const Table d = c.values - other.values;
  for (Quantity q : {area, plastic, von_mises_max, depth, near})
    print_finding("changed", c, other.name(), q, d.col(q), 0, p_changed(d.col(q)));
  const std::array bounds{0.05, 0.1, 0.1};
  for (Quantity q : {sq, ssk, sku}) {
    const Eigen::ArrayXd x = q == sq ? Eigen::ArrayXd(d.col(q) / (1e6 * rms)) : Eigen::ArrayXd(d.col(q));
    const double bound = bounds[static_cast<std::size_t>(q)];
    print_finding("same", c, other.name(), q, x, bound, p_within(x, bound));
  }
}

void print_row(const std::string& head, const Row& mean, const Row& error) {
  fmt::print("{}", head);
  for (Index q = 0; q < mean.size(); ++q)
    fmt::print("{}", std::isnan(mean(q)) ? "\t-\t-" : fmt::format("\t{:.4g}\t{:.2g}", mean(q), error(q)));
  fmt::print("\n");
  std::fflush(stdout);
}

void print_case(const Case& c) {
  Row error;
  for (Index q = 0; q < error.size(); ++q) error(q) = mean_error(c.values.col(q));
  print_row(fmt::format("{}\t{}\t{}", c.cut, c.name(), c.answer), c.values.colwise().mean(), error);
}

}  // namespace

int main(int argc, char** argv) {
  const Index seeds = argc > 1 ? std::max(2L, std::atol(argv[1])) : 50;
  fmt::print("# {} seeds\n# cut\tlags\tanswer", seeds);
  for (const char* name : names) fmt::print("\t{0}\t{0}_se", name);
  fmt::print("\n");
  const Row smooth = smooth_contact();
  print_row("-\tsmooth\t-", smooth, Row::Zero());
  std::vector<Case> cases;
  for (int cut : {1, 10})
    for (Shape lags : {Shape{7, 4}, {3, 3}, {17, 4}, {17, 14}, {13, 13}}) {
      cases.push_back({cut, lags.nx, lags.ny});
      run(cases.back(), seeds);
      print_case(cases.back());
    }
  fmt::print("# finding\tcut\tlags\tagainst\tquantity\tmean\tse\tbound\tp\tverdict\n");
  for (const Case& c : cases) print_against_smooth(c, smooth);
  for (std::size_t first : {0U, 5U}) {
    print_against(cases[first], cases[first + 1]);
    print_against(cases[first + 2], cases[first + 3]);
    print_against(cases[first + 3], cases[first + 1]);
  }
  return 0;
}
