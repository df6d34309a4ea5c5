#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "contact/energy.hpp"
#include "core/error.hpp"
#include "math/fixed_point.hpp"
#include "plastic/plastic_path.hpp"

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

PlasticContact::Path::Path(const Grid& grid, Field gap, const Bodies& bodies, ElasticOperator& influence,
                           ContactParameters contact_parameters, PlasticParameters parameters)
    : grid_(grid),
      gap_(std::move(gap)),
      influence_(influence),
      contact_parameters_(std::move(contact_parameters)),
      parameters_(std::move(parameters)) {
  parameters_.check();
  for (std::size_t i = 0; i < 2; ++i) {
    materials_[i] = {parameters_.hardening[i], bodies.young[i], bodies.poisson[i]};
    if (materials_[i].hardening.flows() && !std::isfinite(bodies.young[i]))
      throw ParameterError("yield", fmt::format("{} Pa is of a rigid body, which does not flow: give inf",
                                                materials_[i].hardening.yield));
  }
  contact_parameters_.stiffness = false;
  contact_parameters_.limit_pressure = std::numeric_limits<double>::infinity();
  contact = untouched(gap_);
}

// ---- the box ----

// By a contact whose pressure the largest yield stress limits, or an elastic one if that carries no such
// load.
void PlasticContact::Path::choose_box(const PlasticTarget& target) {
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
  convolutions += pressed.convolutions;
  const PlasticMaterial& first = materials_[flowing(0) ? 0 : 1];
  box = yielding_box(grid_, pressed.pressure, first.poisson, least, parameters_.layers,
                     contact_parameters_.threads);
  if (box.edges.empty()) return;
  if (!parameters_.edges.empty()) {
    if (const double needed = box.edges.back() / deeper_box; parameters_.edges.back() < needed)
      throw ParameterError("depths", fmt::format("end at {:.6g} m, but the bodies yield as deep as {:.3g} m",
                                                 parameters_.edges.back(), needed));
    box.edges = parameters_.edges;
  }
  const bool both = flowing(0) && flowing(1);
  parameters_.check(box, both && !alike() ? 2 : 1);
  auto add = [&](const PlasticMaterial& material, int count) {
    flowing_bodies.push_back(
        std::make_unique<FlowingBody>(grid_, box, material, count, contact_parameters_.threads));
  };
  add(first, both && alike() ? 2 : 1);
  if (both && !alike()) add(materials_[1], 1);
}

// A punch as large as the domain sinks without end under 2.9 σ_Y; what hardens bears more.
void PlasticContact::Path::check_borne(const PlasticTarget& target, double yield) const {
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

// Sides of the box at which the contact is, or something flows, and where the body goes on.
BoxSides PlasticContact::Path::reached() const {
  const auto [x, y] = extents(contact.pressure, [](double p) { return p > 0; });
  BoxSides out;
  const Index east = x.end(), north = y.end();
  if (x.count > 0)
    out = {x.first <= box.x.first, east >= box.x.end(), y.first <= box.y.first, north >= box.y.end()};
  for (const auto& body : flowing_bodies) {
    const BoxSides sides = body->reached();
    out.west |= sides.west, out.east |= sides.east, out.south |= sides.south, out.north |= sides.north;
    out.bottom |= sides.bottom;
  }
  if (grid_.periodic.x) out.west = out.east = false;
  if (grid_.periodic.y) out.south = out.north = false;
  return out;
}

// Whether something flows at a free side of the domain.
bool PlasticContact::Path::flows_at_side() const {
  const bool x = !grid_.periodic.x, y = !grid_.periodic.y;
  return std::ranges::any_of(flowing_bodies, [&](const auto& body) {
    const BoxSides sides = body->reached();
    return (sides.west && x && box.x.first == 0) || (sides.east && x && box.x.end() == grid_.shape.nx) ||
           (sides.south && y && box.y.first == 0) || (sides.north && y && box.y.end() == grid_.shape.ny);
  });
}

// ---- one contact ----

ContactParameters PlasticContact::Path::parameters_of(const PlasticTarget& target) const {
  ContactParameters out = contact_parameters_;
  out.load = target.approach ? 0 : target.load;
  out.approach = target.approach;
  out.tolerance = std::min(out.tolerance, std::max(of_residual * last_residual_, tightest_contact));
  out.start = (contact.pressure > 0).any() ? contact.pressure : Field();
  return out;
}

Contact PlasticContact::Path::untouched(const Field& gap, std::optional<double> approach) const {
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
void PlasticContact::Path::solve(const PlasticTarget& target, const Field& displaced) {
  Field gap = gap_;
  if (displaced.size() > 0) gap.block(box.x.first, box.y.first, box.x.count, box.y.count) += displaced;
  const bool pressed = target.approach ? *target.approach > gap.minCoeff() : target.load > 0;
  if (pressed)
    contact = solve_contact(grid_, std::move(gap), influence_, parameters_of(target));
  else
    contact = untouched(gap, target.approach);
  convolutions += contact.convolutions;
}

// ---- the path ----

PlasticTarget PlasticContact::Path::between(const PlasticTarget& target, double begin, double part) const {
  if (part == 1) return target;
  if (target.approach) return {0, begin + part * (*target.approach - begin)};
  return {begin + part * (target.load - begin), {}};
}

void PlasticContact::Path::go_to(const PlasticTarget& target, int increments) {
  if (flowing_bodies.empty()) choose_box(target);
  if (flowing_bodies.empty()) return solve(target, {});
  if (!flowed_) load_elastically(target);
  const double begin = target.approach ? contact.approach : contact.load,
               end = target.approach.value_or(target.load);
  for (int n = 1; n <= increments && reason.empty(); ++n) {
    increment(between(target, begin, static_cast<double>(n) / increments), end > begin && n > 1);
    if (parameters_.progress) parameters_.progress(n, increments);
  }
}

// Von Mises over yield stress under the present pressure, before anything has flown.
double PlasticContact::Path::yield_share() {
  const Field p = contact.pressure.block(box.x.first, box.y.first, box.x.count, box.y.count);
  double out = 0;
  for (auto& body : flowing_bodies) {
    body->begin();
    body->displaced({});
    out = std::max(out, body->respond(p, {}, {}));
  }
  return out;
}

// To just before something yields.
void PlasticContact::Path::load_elastically(const PlasticTarget& target) {
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
  contact = untouched(gap_);
}

void PlasticContact::Path::increment(const PlasticTarget& target, bool goes_on) {
  const Contact before = contact;
  displaced_ = {};
  for (int trial = 0; trial < most_enlargements; ++trial, goes_on = false) {
    const bool solved = flow(target, goes_on);
    const BoxSides sides = reached();
    const PlasticBox larger = grown(box, sides, grid_);
    if (larger == box || !solved || trial + 1 == most_enlargements) {
      at_side = at_side || flows_at_side();
      if (!solved && reason.empty())
        reason = fmt::format("the flow has a residual of {:.1e} after {} evaluations", last_residual_,
                             parameters_.max_evaluations);
      if (!(contact.residual <= contact_parameters_.tolerance) && reason.empty()) reason = contact.reason;
      residual = std::max(residual, last_residual_);
      each_share(std::span<const double>(changed_),
                 [](FlowingBody& body, auto share) { body.commit(share); });
      flowed_ = true;
      return;
    }
    parameters_.check(larger, std::ssize(flowing_bodies));
    for (auto& body : flowing_bodies) body = std::make_unique<FlowingBody>(grid_, larger, *body, box);
    box = larger;
    contact = before;
  }
}

// The fixed point, with all unknowns that it takes; whether it has been reached.
bool PlasticContact::Path::flow(const PlasticTarget& target, bool goes_on) {
  std::vector<double> u;
  for (auto& body : flowing_bodies) {
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
  const int before = evaluations;
  for (int round = 0; round < most_enlargements; ++round) {
    extend(u);
    const int left = parameters_.max_evaluations - (evaluations - before);
    if (left <= 0) return false;
    const FixedPoint found =
        solve_fixed_point(map, u, scale(), {parameters_.tolerance, parameters_.depth, left});
    if (!found.converged) return false;
    if (largest_ <= 1 + parameters_.tolerance) return true;
  }
  return false;
}

// With zeros for the cells that may flow by the last evaluation.
void PlasticContact::Path::extend(std::vector<double>& unknowns) {
  std::vector<double> out;
  std::size_t first = 0;
  for (auto& body : flowing_bodies) {
    const std::size_t count = size(body->unknowns());
    out.insert(out.end(), unknowns.begin() + std::ptrdiff_t(first),
               unknowns.begin() + std::ptrdiff_t(first + count));
    first += count;
    out.resize(out.size() + size(body->add_points(may_flow) * deviator::components));
  }
  unknowns = std::move(out);
}

void PlasticContact::Path::evaluate(const PlasticTarget& target, std::span<const double> unknowns,
                                    std::span<double> out) {
  Field displaced = Field::Zero(box.x.count, box.y.count);
  each_share(unknowns, [&](FlowingBody& body, auto share) { displaced += body.displaced(share); });
  solve(target, displaced);
  const Field p = contact.pressure.block(box.x.first, box.y.first, box.x.count, box.y.count);
  largest_ = 0;
  std::size_t first = 0;
  each_share(unknowns, [&](FlowingBody& body, auto share) {
    largest_ = std::max(largest_, body.respond(p, share, out.subspan(first, share.size())));
    first += share.size();
  });
  const std::vector<double> scales = scale();
  last_residual_ = 0;
  for (std::size_t i = 0; i < out.size(); ++i)
    last_residual_ = std::max(last_residual_, scales[i] * std::abs(out[i] - unknowns[i]));
  ++evaluations;
}

std::vector<double> PlasticContact::Path::scale() const {
  std::vector<double> out;
  for (const auto& body : flowing_bodies) {
    out.resize(out.size() + size(body->unknowns()));
    body->set_scale(std::span(out).last(size(body->unknowns())));
  }
  return out;
}

// Computed once for each state.
Field PlasticContact::Path::displacement(std::size_t of) {
  const std::optional<Index> n = flowing(of);
  if (!n || flowing_bodies.empty()) return Field::Zero(grid_.shape.nx, grid_.shape.ny);
  FlowingBody& body = *flowing_bodies[size(*n)];
  Field& known = displaced_[size(*n)];
  if (known.size() > 0) return known;
  body.begin();
  if (box.x.count == grid_.shape.nx && box.y.count == grid_.shape.ny)
    known = body.displaced({}) / body.alike();
  else
    known = surface_displacement(grid_, box.x.first, box.y.first, box.edges, body.material().poisson,
                                 body.strain(), contact_parameters_.threads);
  return known;
}

// ---- what is seen of it ----

PlasticContact::PlasticContact(const Grid& grid, Field undeformed_gap, const Bodies& bodies,
                               ElasticOperator& influence, ContactParameters contact,
                               PlasticParameters parameters)
    : path_(std::make_unique<Path>(grid, std::move(undeformed_gap), bodies, influence, std::move(contact),
                                   std::move(parameters))) {}
PlasticContact::~PlasticContact() = default;

void PlasticContact::go_to(const PlasticTarget& target, int increments) { path_->go_to(target, increments); }
const Contact& PlasticContact::contact() const { return path_->contact; }
const PlasticBox& PlasticContact::box() const { return path_->box; }
std::optional<Index> PlasticContact::flowing(std::size_t body) const {
  return path_->flowing_bodies.empty() ? std::nullopt : path_->flowing(body);
}
FlowingBody& PlasticContact::body(Index flowing) { return *path_->flowing_bodies[size(flowing)]; }
Field PlasticContact::displacement(std::size_t body) const { return path_->displacement(body); }
int PlasticContact::evaluations() const { return path_->evaluations; }
double PlasticContact::convolutions() const { return path_->convolutions; }
double PlasticContact::residual() const { return path_->residual; }
bool PlasticContact::converged() const { return path_->reason.empty(); }
std::string PlasticContact::reason() const { return path_->reason; }
bool PlasticContact::reaches_side() const { return path_->at_side; }

}  // namespace asperity
