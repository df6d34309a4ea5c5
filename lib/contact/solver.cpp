#include "contact/solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "contact/calibration.hpp"
#include "contact/influence.hpp"
#include "contact/problem.hpp"
#include "contact/stiffness.hpp"
#include "contact/windowed.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

using namespace contact;

struct Gaps {
  double least = std::numeric_limits<double>::infinity(), sum = 0;
  void operator+=(const Gaps& other) {
    least = std::min(least, other.least);
    sum += other.sum;
  }
};

void check_approach(const Grid& grid, const Field& gap, const ContactProblem& problem,
                    const ContactParameters& parameters) {
  const Gaps gaps = problem.blocks().sum([&](Block b) {
    return Gaps{b.of(gap).minCoeff(), b.of(gap).sum()};
  });
  const double approach = *parameters.approach, touch = gaps.least,
               mean = gaps.sum / static_cast<double>(grid.shape.cells());
  if (!(approach > touch))
    throw ParameterError(
        "approach",
        fmt::format("{:.6g} m is not above {:.6g} m, where the bodies first touch", approach, touch));
  if (grid.periodic.both() && std::isinf(parameters.limit_pressure) && !(approach < mean))
    throw ParameterError(
        "approach",
        fmt::format("{} m is not below {:.6g} m, the mean gap of a periodic surface in full contact",
                    approach, mean));
}

// Of the rows that this rank has.
void check_field(const char* name, const Field& f, const char* what, const Grid& grid,
                 const ElasticOperator& influence) {
  const Slabs slabs = influence.slabs();
  if (!(shape_of(f) == Shape{slabs.own().count, grid.shape.ny}))
    throw DataError(name, fmt::format("{}, the grid and the operator differ in shape", what));
  if (largest(slabs.ranks(), f.isFinite().all() ? 0 : 1) > 0)
    throw DataError(name, fmt::format("{} holds values that are not finite", what));
}

ContactProblem make_problem(const Grid& grid, Field gap, ElasticOperator& influence,
                            const ContactParameters& parameters) {
  if (!influence.fits(grid))
    throw DataError("heights", "the operator is not one of the grid's shape, spacings and periods");
  check_field("heights", gap, "the field", grid, influence);
  if (parameters.start.size() > 0) check_field("pressure", parameters.start, "the start", grid, influence);
  ContactProblem problem{&influence,
                         {},
                         parameters.load / grid.cell_area(),
                         parameters.limit_pressure,
                         influence.self_influence(),
                         parameters.approach,
                         parameters.threads};
  if (parameters.approach)
    check_approach(grid, gap, problem, parameters);
  else
    check_carried("load", parameters.load, grid, parameters.limit_pressure);
  problem.h = std::move(gap);
  if (parameters.approach) problem.shift(*parameters.approach);
  return problem;
}

ContactObserver observer(const Grid& grid, Shape shape, const ContactParameters& parameters) {
  if (!parameters.progress) return {};
  const double cell = grid.size_x() * grid.size_y() / static_cast<double>(shape.cells());
  return [&parameters, shape, cell, finest = shape == grid.shape](const ContactResidual& residual,
                                                                  double convolutions) {
    parameters.progress({shape, residual.epsilon, static_cast<double>(residual.contact()) * cell,
                         residual.max_pressure, static_cast<int>(std::ceil(convolutions)), finest});
  };
}

std::string describe(ContactStop stop, double epsilon, const ContactParameters& parameters) {
  switch (stop) {
    case ContactStop::converged:
      return "converged";
    case ContactStop::round_off:
      return fmt::format("round-off allows no smaller residual than {:.1e}, the tolerance is {:.1e}", epsilon,
                         parameters.tolerance);
    case ContactStop::convolution_limit:
      break;
  }
  return fmt::format("the limit of {} is reached at a residual of {:.1e}",
                     counted(parameters.max_convolutions, "convolution"), epsilon);
}

// Squares of pressures beyond 1e154 are infinite: then no residual says anything.
[[noreturn]] void refuse_range(const ContactParameters& parameters) {
  const bool sunk = parameters.approach.has_value();
  throw ParameterError(sunk ? "approach" : "load",
                       fmt::format("{} {}: the pressures or displacements leave the range of a double",
                                   parameters.approach.value_or(parameters.load), sunk ? "m" : "N"));
}

// The fields of a solution, and what they sum up to.
void set_fields(Contact& contact, const Grid& grid, ContactProblem& problem, WindowedSolution& solved,
                const ContactParameters& parameters) {
  const double approach = solved.residual.approach;
  contact.pressure = std::move(solved.p);
  contact.gap = std::move(solved.g);
  contact.displacement = std::move(problem.h);  // of g = h + K p, until the pass
  contact.state.resize(size(contact.pressure.size()));
  const Eigen::Array3d sums = problem.blocks().sum([&](Block b) {
    const auto p = b.of(std::as_const(contact.pressure));
    auto g = b.of(contact.gap), u = b.of(contact.displacement);
    u = g - u;
    g -= approach;
    std::transform(p.begin(), p.end(), b.of(contact.state).begin(), [&](double x) {
      return x <= 0 ? Contact::open : problem.is_free(x) ? Contact::elastic : Contact::plastic;
    });
    return Eigen::Array3d(p.sum(), g.max(0.0).sum(), u.sum());
  });
  if (!sums.isFinite().all()) refuse_range(parameters);
  if (const Slabs slabs = problem.slabs(); slabs.shared()) {
    contact.shared = slabs;
    contact.state = gathered(slabs.ranks(), contact.state);
  }
  contact.load = sums[0] * grid.cell_area();
  contact.load_residual = problem.approach ? 0 : std::abs(sums[0] / problem.sum - 1);
  contact.mean_gap = sums[1] / static_cast<double>(grid.shape.cells());
}

void set_result(Contact& contact, const Grid& grid, const ContactProblem& problem,
                const WindowedSolution& solved, const ContactParameters& parameters) {
  const ContactResidual& residual = solved.residual;
  contact.converged = solved.stop == ContactStop::converged;
  contact.reason = describe(solved.stop, residual.epsilon, parameters);
  contact.residual = residual.epsilon;
  contact.approach = residual.approach + problem.datum;
  contact.max_pressure = residual.max_pressure;
  contact.area = static_cast<double>(residual.contact()) * grid.cell_area();
  contact.plastic_area = static_cast<double>(residual.plastic) * grid.cell_area();
}

void count(Contact& contact, double convolutions, double preconditionings, double share) {
  contact.convolutions += share * convolutions;
  contact.preconditionings += share * preconditionings;
}

double share_of(Shape part, const Grid& grid) {
  return static_cast<double>(part.cells()) / static_cast<double>(grid.shape.cells());
}

// dQ/dδ of a solution, on the window that holds it.
void add_stiffness(Contact& contact, const Grid& grid, ElasticOperator& influence, const WindowBody& body,
                   const ContactParameters& parameters) {
  const double share = share_of(body.window.shape(), grid);
  ElasticOperator& on_window = body.influence ? *body.influence : influence;
  const Stiffness found = contact_stiffness(
      on_window, body.window.of(contact.pressure, influence.slabs(), on_window.slabs()),
      parameters.limit_pressure, grid.cell_area(), parameters.max_convolutions / share, parameters.threads);
  contact.stiffness = found.value;
  contact.stiffness_residual = found.residual;
  count(contact, found.convolutions, found.preconditionings, share);
}

Field flat_start(const ContactProblem& problem) {
  return Field::Constant(problem.h.rows(), problem.h.cols(),
                         problem.sum / static_cast<double>(problem.shape().cells()));
}

// From the coarsest grid to the second finest, each starting from the solution before it.
Field nested_start(Contact& contact, const Grid& grid, std::vector<CoarseLevel> levels, const Slabs& finest,
                   const ContactParameters& parameters) {
  const WindowedLimits limits{std::max(coarse_tolerance, parameters.tolerance), coarse_convolutions, false};
  Field start = flat_start(levels.back().problem);
  for (bool near = false; !levels.empty(); levels.pop_back(), near = true) {
    auto& [body, problem] = levels.back();
    const Shape shape = body->shape();
    const WindowedSolution solved =
        minimise_on_window(problem, std::move(start), near, limits, observer(grid, shape, parameters));
    count(contact, solved.convolutions, solved.preconditionings, share_of(shape, grid));
    const Slabs finer = levels.size() > 1 ? levels[levels.size() - 2].body->slabs() : finest;
    start = prolonged(solved.p, body->slabs(), finer, grid.periodic, parameters.threads);
    contact.setup_seconds += body->setup_seconds();
  }
  return start;
}

void solve(Contact& contact, const Grid& grid, ContactProblem problem, const ContactParameters& parameters) {
  const bool warm = parameters.start.size() > 0;
  std::vector<CoarseLevel> levels;
  if (parameters.nested_start && !warm) levels = coarser_levels(problem);
  contact.levels = 1 + static_cast<int>(levels.size());
  const bool near = warm || !levels.empty();
  Field start = warm ? parameters.start
                : levels.empty()
                    ? flat_start(problem)
                    : nested_start(contact, grid, std::move(levels), problem.slabs(), parameters);

  const WindowedLimits limits{parameters.tolerance, static_cast<double>(parameters.max_convolutions), true,
                              warm ? warm_margin_part : margin_part};
  WindowedSolution solved =
      minimise_on_window(problem, std::move(start), near, limits, observer(grid, grid.shape, parameters));
  count(contact, solved.convolutions, solved.preconditionings, 1);
  set_result(contact, grid, problem, solved, parameters);
  set_fields(contact, grid, problem, solved, parameters);
  if (parameters.stiffness && contact.converged)
    add_stiffness(contact, grid, *problem.influence, solved.body, parameters);
}

}  // namespace

void ContactParameters::check() const {
  if (approach && load != 0)
    throw ParameterError("approach",
                         fmt::format("{} m is given together with a load of {} N", *approach, load));
  if (approach && !std::isfinite(*approach))
    throw ParameterError("approach", fmt::format("{} m is not finite", *approach));
  if (!approach && !(load > 0 && std::isfinite(load)))
    throw ParameterError("load", fmt::format("{} N is not above 0", load));
  if (!(limit_pressure > 0))
    throw ParameterError("limit-pressure", fmt::format("{} Pa is not above 0", limit_pressure));
  if (!(tolerance > 0 && tolerance < 1))
    throw ParameterError("tolerance", fmt::format("{} is not between 0 and 1", tolerance));
  if (max_convolutions < 1)
    throw ParameterError("max-convolutions", fmt::format("{} is less than 1", max_convolutions));
}

Contact solve_contact(const Grid& grid, Field undeformed_gap, double composite_modulus,
                      const ContactParameters& parameters) {
  const Stopwatch setup;
  const auto influence = make_influence(grid, composite_modulus, parameters.threads);
  const double seconds = setup.seconds();
  Contact contact = solve_contact(grid, std::move(undeformed_gap), *influence, parameters);
  contact.setup_seconds += seconds;
  return contact;
}

Contact solve_contact(const Grid& grid, Field undeformed_gap, ElasticOperator& influence,
                      const ContactParameters& parameters) {
  parameters.check();
  Contact contact;
  const Stopwatch watch;
  const double setup_before = influence.setup_seconds();
  ContactProblem problem = make_problem(grid, std::move(undeformed_gap), influence, parameters);
  solve(contact, grid, std::move(problem), parameters);
  contact.setup_seconds += influence.setup_seconds() - setup_before;
  contact.seconds = watch.seconds() - contact.setup_seconds;
  return contact;
}

}  // namespace asperity
