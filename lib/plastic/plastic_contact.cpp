#include "plastic/plastic_contact.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "contact/energy.hpp"
#include "core/error.hpp"
#include "math/fixed_point.hpp"

namespace asperity {
namespace {

constexpr double may_flow = 0.85;  // of the flow stress: unknowns beside those that flow
constexpr double of_residual = 1e-3, tightest_contact = 1e-10;
constexpr int most_enlargements = 30;                     // of the unknowns, or of the box, in an increment
constexpr double least_share = 0.85, aimed_share = 0.95;  // of the yield stress at the elastic end
constexpr int elastic_trials = 8;
constexpr double punch_limit = 3.2;  // of the yield stress, somewhat above Prandtl's and Shield's
constexpr double stress_with_load = 1.0 / 3, stress_with_approach = 0.5;  // exponents of Hertz's contact

}  // namespace

void PlasticParameters::check() const {
  for (const Hardening& h : hardening) h.check();
  if (!hardening[0].flows() && !hardening[1].flows())
    throw ParameterError("yield", "is infinite of both bodies: nothing flows");
  if (edges.empty()) return;
  if (edges.size() < 3 || edges.front() != 0)
    throw ParameterError("depths", "must begin with 0, the surface, and bound two layers or more");
  for (std::size_t k = 1; k < edges.size(); ++k)
    if (!(edges[k] > edges[k - 1]))
      throw ParameterError("depths", fmt::format("{} m does not lie below {} m", edges[k], edges[k - 1]));
}

void PlasticParameters::check(const PlasticBox& box, Index bodies) const {
  constexpr double megabyte = 1e6;
  const double needed = static_cast<double>(bodies) * FlowingBody::memory(box);
  if (needed > memory)
    throw ParameterError(
        "memory", fmt::format("{:.0f} MB is less than the {:.0f} MB that flow in {}x{} cells and {} "
                              "layers needs: allow more, or take fewer layers or cells",
                              memory / megabyte, needed / megabyte, box.x.count, box.y.count, box.layers()));
}

PlasticContact::PlasticContact(const Grid& grid, Field gap, const Bodies& bodies, ElasticOperator& influence,
                               ContactParameters contact_parameters, PlasticParameters parameters)
    : grid_(grid),
      gap_(std::move(gap)),
      influence_(influence),
      contact_parameters_(std::move(contact_parameters)),
      parameters_(std::move(parameters)) {
  parameters_.check();
  constexpr Index least_cells = 8;  // that the images of a body that is not periodic are taken off by
  if ((!grid_.periodic.x && grid_.shape.nx < least_cells) ||
      (!grid_.periodic.y && grid_.shape.ny < least_cells))
    throw ParameterError("plasticity",
                         fmt::format("j2 needs {} cells along each axis that is not periodic, found {} x {}",
                                     least_cells, grid_.shape.nx, grid_.shape.ny));
  for (std::size_t i = 0; i < 2; ++i) {
    materials_[i] = {parameters_.hardening[i], bodies.young[i], bodies.poisson[i]};
    if (materials_[i].hardening.flows() && !std::isfinite(bodies.young[i]))
      throw ParameterError("yield", fmt::format("{} Pa is of a rigid body, which does not flow: give inf",
                                                materials_[i].hardening.yield));
  }
  contact_parameters_.stiffness = false;
  contact_parameters_.limit_pressure = std::numeric_limits<double>::infinity();
  contact_ = untouched(gap_);
}

std::optional<Index> PlasticContact::flowing(std::size_t body) const {
  if (flowing_.empty() || !flows(body)) return std::nullopt;
  return static_cast<Index>(body == 1 && flows(0) && !alike());
}

// ---- the box ----

// By a contact whose pressure the largest yield stress limits, or an elastic one if that carries no such
// load.
void PlasticContact::choose_box(const PlasticTarget& target) {
  ContactParameters parameters = parameters_of(target);
  double largest = 0, least = std::numeric_limits<double>::infinity();
  for (const PlasticMaterial& m : materials_)
    if (m.hardening.flows()) {
      largest = std::max(largest, m.hardening.yield);
      least = std::min(least, m.hardening.yield);
    }
  check_borne(target, least);
  if (target.approach || target.load < hardness * largest * grid_.size_x() * grid_.size_y())
    parameters.limit_pressure = hardness * largest;
  const Contact pressed = solve_contact(grid_, gap_, influence_, parameters);
  convolutions_ += pressed.convolutions;
  const PlasticMaterial& first = materials_[flows(0) ? 0 : 1];
  box_ = yielding_box(grid_, pressed.pressure, first.poisson, least, parameters_.layers,
                      contact_parameters_.threads);
  if (box_.edges.empty()) return;
  if (!parameters_.edges.empty()) {
    if (const double needed = box_.edges.back() / deeper_box; parameters_.edges.back() < needed)
      throw ParameterError("depths", fmt::format("end at {:.6g} m, but the bodies yield as deep as {:.3g} m",
                                                 parameters_.edges.back(), needed));
    box_.edges = parameters_.edges;
  }
  const bool both = flows(0) && flows(1), apart = both && !alike();
  parameters_.check(box_, apart ? 2 : 1);
  auto add = [&](const PlasticMaterial& material, int count) {
    flowing_.push_back(
        std::make_unique<FlowingBody>(grid_, box_, material, count, contact_parameters_.threads));
  };
  add(first, both && !apart ? 2 : 1);
  if (apart) add(materials_[1], 1);
}

// A punch as large as the domain sinks without end under 2.9 σ_Y; what hardens bears more.
void PlasticContact::check_borne(const PlasticTarget& target, double yield) const {
  const double most = punch_limit * yield * grid_.size_x() * grid_.size_y();
  const bool hardens = std::ranges::any_of(materials_, [](const PlasticMaterial& m) {
    return m.hardening.flows() && (m.hardening.modulus > 0 || m.hardening.strength > 0);
  });
  if (target.approach || hardens || grid_.periodic.any() || target.load <= most) return;
  throw ParameterError("load",
                       fmt::format("{} N is more than perfectly plastic bodies bear on the whole domain, "
                                   "{:.6g} N: choose a larger domain, or bodies that harden",
                                   target.load, most));
}

FlowReach PlasticContact::flow_reached() const {
  FlowReach out;
  for (const auto& body : flowing_) {
    FlowReach own = body->reached();
    own.x.first += box_.x.first;
    own.y.first += box_.y.first;
    out.add(own.x, own.y, own.layers);
  }
  return out;
}

// ---- one contact ----

ContactParameters PlasticContact::parameters_of(const PlasticTarget& target) const {
  ContactParameters out = contact_parameters_;
  out.load = target.approach ? 0 : target.load;
  out.approach = target.approach;
  out.tolerance = std::min(out.tolerance, std::max(of_residual * last_residual_, tightest_contact));
  out.start = (contact_.pressure > 0).any() ? contact_.pressure : Field();
  return out;
}

Contact PlasticContact::untouched(const Field& gap, std::optional<double> approach) const {
  Contact out;
  out.approach = approach.value_or(gap.minCoeff());
  out.pressure = out.displacement = Field::Zero(gap.rows(), gap.cols());
  out.state.assign(size(gap.size()), Contact::open);
  out.gap = gap - out.approach;
  out.mean_gap = out.gap.mean();
  out.converged = true;
  out.reason = "converged";
  return out;
}

// With the displacement that the strain leaves in the box.
void PlasticContact::solve(const PlasticTarget& target, const Field& displaced) {
  Field gap = gap_;
  if (displaced.size() > 0) box_.of(gap) += displaced;
  const bool pressed = target.approach ? *target.approach > gap.minCoeff() : target.load > 0;
  if (pressed)
    contact_ = solve_contact(grid_, std::move(gap), influence_, parameters_of(target));
  else
    contact_ = untouched(gap, target.approach);
  convolutions_ += contact_.convolutions;
}

// ---- the path ----

PlasticTarget PlasticContact::between(const PlasticTarget& target, double begin, double part) const {
  if (part == 1) return target;
  if (target.approach) return {0, begin + part * (*target.approach - begin)};
  return {begin + part * (target.load - begin), {}};
}

void PlasticContact::go_to(const PlasticTarget& target, int increments) {
  if (flowing_.empty()) choose_box(target);
  if (flowing_.empty()) return solve(target, {});
  if (!flowed_) load_elastically(target);
  const double begin = target.approach ? contact_.approach : contact_.load,
               end = target.approach.value_or(target.load);
  for (int n = 1; n <= increments && converged(); ++n) {
    increment(between(target, begin, static_cast<double>(n) / increments), end > begin && n > 1);
    if (parameters_.progress) parameters_.progress(n, increments);
  }
}

double PlasticContact::yield_share() {
  double out = 0;
  for (auto& body : flowing_) {
    body->begin();
    body->displaced({});
    out = std::max(out, body->respond(box_.of(contact_.pressure), {}, {}));
  }
  return out;
}

// To just before something yields.
void PlasticContact::load_elastically(const PlasticTarget& target) {
  const double begin = target.approach ? gap_.minCoeff() : 0,
               exponent = target.approach ? stress_with_approach : stress_with_load;
  double part = 1, low = 0, low_share = 0, high = 0, high_share = 0;
  for (int trial = 0; trial < elastic_trials; ++trial) {
    solve(between(target, begin, part), {});
    const double share = yield_share();
    (share > 1 ? high : low) = part;
    (share > 1 ? high_share : low_share) = share;
    if (share <= 1 && (share >= least_share || part == 1)) return;
    double power = exponent;
    if (low > 0 && high > 0) power = std::log(high_share / low_share) / std::log(high / low);
    const double from = low > 0 ? low : high, from_share = low > 0 ? low_share : high_share;
    part = std::min(from * std::pow(aimed_share / from_share, 1 / power), 1.0);
  }
  if (low > 0) return solve(between(target, begin, low), {});
  contact_ = untouched(gap_);
}

// Again in a larger box, while the contact, or what flows, reaches a side of it.
void PlasticContact::increment(const PlasticTarget& target, bool goes_on) {
  const Contact before = contact_;
  displaced_ = {};
  for (int trial = 0; trial < most_enlargements; ++trial, goes_on = false) {
    const bool solved = flow(target, goes_on);
    FlowReach reach = flow_reached();
    const auto [x, y] = extents(contact_.pressure, [](double p) { return p > 0; });
    reach.add(x, y);
    const PlasticBox larger = grown(box_, reach, grid_);
    if (larger == box_ || !solved || trial + 1 == most_enlargements) return commit(solved);
    parameters_.check(larger, std::ssize(flowing_));
    for (auto& body : flowing_) body = std::make_unique<FlowingBody>(grid_, larger, *body, box_);
    box_ = larger;
    contact_ = before;
  }
}

void PlasticContact::commit(bool solved) {
  const auto [x, y, layers] = flow_reached();
  auto at_side = [](Extent e, Index cells) { return e.count > 0 && (e.first == 0 || e.end() == cells); };
  reaches_side_ = reaches_side_ || (!grid_.periodic.x && at_side(x, grid_.shape.nx)) ||
                  (!grid_.periodic.y && at_side(y, grid_.shape.ny));
  if (!solved && converged())
    reason_ = fmt::format("the flow has a residual of {:.1e} after {} evaluations", last_residual_,
                          parameters_.max_evaluations);
  if (!(contact_.residual <= contact_parameters_.tolerance) && converged()) reason_ = contact_.reason;
  residual_ = std::max(residual_, last_residual_);
  each_share([&](FlowingBody& body, std::size_t first, std::size_t count) {
    body.commit(std::span(changed_).subspan(first, count));
  });
  flowed_ = true;
}

// The fixed point, with all unknowns that it takes; whether it has been reached.
bool PlasticContact::flow(const PlasticTarget& target, bool goes_on) {
  std::vector<double> u;
  for (auto& body : flowing_) {
    const std::vector<double> former = body->former(goes_on ? 1 : 0);
    u.insert(u.end(), former.begin(), former.end());
  }
  last_residual_ = 1;
  changed_.resize(u.size());
  evaluate(target, u, changed_);
  if (u.empty() && largest_ <= 1) return last_residual_ = 0, true;
  const FixedPointMap map = [&](std::span<const double> x, std::span<double> g) {
    evaluate(target, x, g);
    changed_.assign(g.begin(), g.end());
  };
  const int before = evaluations_;
  for (int round = 0; round < most_enlargements; ++round) {
    extend(u);
    const int left = parameters_.max_evaluations - (evaluations_ - before);
    if (left <= 0) return false;
    const FixedPoint found =
        solve_fixed_point(map, u, scale(), {parameters_.tolerance, parameters_.depth, left});
    if (!found.converged) return false;
    if (largest_ <= 1 + parameters_.tolerance) return true;
  }
  return false;
}

// With zeros for the cells that may flow by the last evaluation.
void PlasticContact::extend(std::vector<double>& unknowns) {
  std::vector<double> out;
  each_share([&](FlowingBody& body, std::size_t first, std::size_t count) {
    const auto own = unknowns.begin() + static_cast<std::ptrdiff_t>(first);
    out.insert(out.end(), own, own + static_cast<std::ptrdiff_t>(count));
    out.resize(out.size() + size(body.add_points(may_flow) * deviator::components));
  });
  unknowns = std::move(out);
}

void PlasticContact::evaluate(const PlasticTarget& target, std::span<const double> unknowns,
                              std::span<double> out) {
  Field displaced = Field::Zero(box_.x.count, box_.y.count);
  each_share([&](FlowingBody& body, std::size_t first, std::size_t count) {
    displaced += body.displaced(unknowns.subspan(first, count));
  });
  solve(target, displaced);
  const Field p = box_.of(contact_.pressure);
  largest_ = 0;
  each_share([&](FlowingBody& body, std::size_t first, std::size_t count) {
    largest_ = std::max(largest_, body.respond(p, unknowns.subspan(first, count), out.subspan(first, count)));
  });
  const std::vector<double> scales = scale();
  last_residual_ = 0;
  for (std::size_t i = 0; i < out.size(); ++i)
    last_residual_ = std::max(last_residual_, scales[i] * std::abs(out[i] - unknowns[i]));
  ++evaluations_;
}

std::vector<double> PlasticContact::scale() {
  std::vector<double> out;
  each_share([&](FlowingBody& body, std::size_t first, std::size_t count) {
    out.resize(first + count);
    body.set_scale(std::span(out).subspan(first));
  });
  return out;
}

Field PlasticContact::displacement(std::size_t of) {
  const std::optional<Index> n = flowing(of);
  if (!n) return Field::Zero(grid_.shape.nx, grid_.shape.ny);
  FlowingBody& body = *flowing_[size(*n)];
  Field& known = displaced_[size(*n)];
  if (known.size() > 0) return known;
  body.begin();
  if (box_.x.count == grid_.shape.nx && box_.y.count == grid_.shape.ny)
    known = body.displaced({}) / body.alike();
  else
    known = surface_displacement(grid_, box_.x.first, box_.y.first, box_.edges, body.material().poisson,
                                 body.strain(), contact_parameters_.threads);
  return known;
}

}  // namespace asperity
