#include "contact/solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "contact/influence.hpp"
#include "contact/nested.hpp"
#include "contact/problem.hpp"
#include "contact/stiffness.hpp"
#include "contact/windowed.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

constexpr double coarse_tolerance = 1e-3;
constexpr double load_round_off = 1e-12;
constexpr Index near_margin = 32,
                warm_margin = 12;  // parts of the contact, about a start of another grid or load

void check_load(const Grid& grid, const ContactParameters& parameters) {
  const double largest = parameters.limit_pressure * grid.size_x() * grid.size_y();
  if (parameters.load > largest * (1 + load_round_off))
    throw ParameterError(
        "load", fmt::format("{} N is more than the limit pressure carries on the whole domain, {:.6g} N",
                            parameters.load, largest));
}

void check_approach(const Grid& grid, const Field& gap, const ContactParameters& parameters) {
  const double approach = *parameters.approach, touch = gap.minCoeff(), mean = gap.mean();
  if (!(approach > touch))
    throw ParameterError(
        "approach", fmt::format("{} m is not above {:.6g} m, where the bodies first touch", approach, touch));
  if (grid.periodic && std::isinf(parameters.limit_pressure) && !(approach < mean))
    throw ParameterError(
        "approach",
        fmt::format("{} m is not below {:.6g} m, the mean gap of a periodic surface in full contact",
                    approach, mean));
}

void check_start(const Grid& grid, const Field& start) {
  if (start.size() == 0) return;
  if (!(shape_of(start) == grid.shape)) throw DataError("pressure", "the start and the grid differ in shape");
  if (!start.isFinite().all()) throw DataError("pressure", "the start holds values that are not finite");
}

ContactProblem make_problem(const Grid& grid, Field gap, const ElasticOperator& influence,
                            const ContactParameters& parameters) {
  if (!(shape_of(gap) == grid.shape && influence.shape() == grid.shape))
    throw DataError("heights", "the field, the grid and the operator differ in shape");
  if (!gap.isFinite().all()) throw DataError("heights", "holds values that are not finite");
  if (parameters.approach)
    check_approach(grid, gap, parameters);
  else
    check_load(grid, parameters);
  check_start(grid, parameters.start);
  ContactProblem problem{std::move(gap),
                         parameters.load / grid.cell_area(),
                         parameters.limit_pressure,
                         influence.self_influence(),
                         parameters.approach,
                         parameters.threads};
  if (parameters.approach) problem.shift(*parameters.approach);
  return problem;
}

// One grid of the nested start, the finest first.
struct Level {
  ElasticOperator* influence;
  ContactProblem problem;
  std::unique_ptr<ElasticOperator> owned;
};

std::vector<Level> make_levels(ElasticOperator& influence, ContactProblem problem, bool nested) {
  std::vector<Level> levels;
  levels.push_back({&influence, std::move(problem), nullptr});
  while (nested && can_coarsen(levels.back().influence->shape())) {
    auto coarse = levels.back().influence->coarsened();
    levels.push_back({coarse.get(), coarsened(levels.back().problem), nullptr});
    levels.back().owned = std::move(coarse);
  }
  return levels;
}

WindowedGradients::Observer observer(const Grid& grid, Shape shape, const ContactParameters& parameters) {
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
void check_range(const ContactParameters& parameters, bool finite) {
  if (finite) return;
  const bool sunk = parameters.approach.has_value();
  throw ParameterError(sunk ? "approach" : "load",
                       fmt::format("{} {}: the pressures or displacements leave the range of a double",
                                   parameters.approach.value_or(parameters.load), sunk ? "m" : "N"));
}

// Everything that the solution on the finest grid tells; its fields become the result's.
void keep(Contact& contact, const Grid& grid, ContactProblem& problem, WindowedGradients& solved,
          const ContactParameters& parameters) {
  const ContactResidual& residual = solved.residual();
  const Blocks blocks = problem.blocks();
  contact.pressure = std::move(solved.pressure());
  contact.gap = std::move(solved.gap());
  contact.displacement = std::move(problem.h);  // of g = h + K p, until the pass
  contact.state.resize(static_cast<std::size_t>(grid.shape.cells()));
  const Eigen::Array3d sums = blocks.sum([&](Block b) {
    const auto p = b.of(std::as_const(contact.pressure));
    auto g = b.of(contact.gap), u = b.of(contact.displacement);
    u = g - u;
    g -= residual.approach;
    std::transform(p.begin(), p.end(), contact.state.begin() + b.begin, [&](double x) {
      return x <= 0 ? Contact::open : problem.is_free(x) ? Contact::elastic : Contact::at_limit;
    });
    return Eigen::Array3d(p.sum(), g.max(0.0).sum(), u.sum());
  });
  check_range(parameters, sums.isFinite().all());
  contact.approach = residual.approach + problem.datum;
  contact.mean_gap = sums[1] / static_cast<double>(grid.shape.cells());
  contact.max_pressure = residual.max_pressure;
  contact.residual = residual.epsilon;
  contact.area = static_cast<double>(residual.contact()) * grid.cell_area();
  contact.plastic_area = static_cast<double>(residual.at_limit) * grid.cell_area();
  contact.load = sums[0] * grid.cell_area();
  contact.load_error = problem.approach ? 0 : std::abs(sums[0] / problem.sum - 1);
}

// dQ/dδ of a solution, on the window that holds it; of what is none it is not known.
void add_stiffness(Contact& contact, const Grid& grid, WindowedGradients& solved,
                   const ContactParameters& parameters) {
  if (!contact.converged) return;
  const Window& window = solved.window();
  const double share = static_cast<double>(window.shape.cells()) / static_cast<double>(grid.shape.cells());
  const Stiffness found =
      contact_stiffness(solved.body(), window.of(contact.pressure), parameters.limit_pressure,
                        grid.cell_area(), parameters.max_convolutions / share, parameters.threads);
  contact.stiffness = found.value;
  contact.stiffness_residual = found.residual;
  contact.convolutions += share * found.convolutions;
  contact.preconditionings += share * found.preconditionings;
}

Field flat_start(const ContactProblem& problem) {
  return Field::Constant(problem.h.rows(), problem.h.cols(),
                         problem.sum / static_cast<double>(problem.h.size()));
}

// Counts a level's work by its share of the finest cells; returns its solution.
Field solve_level(Contact& contact, Level& level, Field start, bool near, WindowedGradients::Limits limits,
                  const Grid& grid, const ContactParameters& parameters, bool finest) {
  const Shape shape = level.influence->shape();
  WindowedGradients gradients(*level.influence, level.problem, limits);
  const ContactStop stop = gradients.solve(std::move(start), near, observer(grid, shape, parameters));
  const double share = static_cast<double>(shape.cells()) / static_cast<double>(grid.shape.cells());
  contact.convolutions += share * gradients.convolutions();
  contact.preconditionings += share * gradients.preconditionings();
  if (!finest) return std::move(gradients.pressure());
  contact.converged = stop == ContactStop::converged;
  contact.reason = describe(stop, gradients.residual().epsilon, parameters);
  keep(contact, grid, level.problem, gradients, parameters);
  if (parameters.stiffness) add_stiffness(contact, grid, gradients, parameters);
  return {};
}

// From the coarsest grid to the finest, each starting from the solution before it.
void solve_levels(Contact& contact, const Grid& grid, std::vector<Level> levels,
                  const ContactParameters& parameters) {
  const bool warm = parameters.start.size() > 0;
  Field start = warm ? parameters.start : flat_start(levels.back().problem);
  bool near = warm;
  for (; levels.size() > 1; levels.pop_back(), near = true) {
    const WindowedGradients::Limits limits{std::max(coarse_tolerance, parameters.tolerance), 400, false};
    Level& level = levels.back();
    start = prolonged(solve_level(contact, level, std::move(start), near, limits, grid, parameters, false),
                      grid.periodic, parameters.threads);
    contact.setup_seconds += level.influence->setup_seconds();
  }
  const WindowedGradients::Limits limits{parameters.tolerance,
                                         static_cast<double>(parameters.max_convolutions), true,
                                         warm ? warm_margin : near_margin};
  solve_level(contact, levels.front(), std::move(start), near, limits, grid, parameters, true);
}

}  // namespace

void ContactParameters::check() const {
  if (approach && load != 0)
    throw ParameterError("approach", fmt::format("{} m is given beside a load of {} N", *approach, load));
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
  std::vector<Level> levels =
      make_levels(influence, make_problem(grid, std::move(undeformed_gap), influence, parameters),
                  parameters.nested_start && parameters.start.size() == 0);
  contact.levels = static_cast<int>(levels.size());
  solve_levels(contact, grid, std::move(levels), parameters);
  contact.setup_seconds += influence.setup_seconds() - setup_before;
  contact.seconds = watch.seconds() - contact.setup_seconds;
  return contact;
}

}  // namespace asperity
