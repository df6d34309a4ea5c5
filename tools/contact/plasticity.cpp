#include "tools/contact/plasticity.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "contact/energy.hpp"
#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "stress/component.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/cli/record.hpp"

namespace asperity::cli {
namespace {

constexpr int first_increments = 8, most_increments = 32, most_unloading = 4;
constexpr double increments_agree = 0.01;

Hardening parse_hardening(const std::string& text, double yield) {
  const auto refuse = [&](const std::string& why) { throw UsageError("hardening", "'" + text + "' " + why); };
  const std::size_t colon = text.find(':');
  const std::string law = text.substr(0, colon), rest = colon == text.npos ? "" : text.substr(colon + 1);
  if (law == "perfect" && colon == text.npos) return {yield};
  if (law == "linear" && !rest.empty()) return {yield, parse_quantity("hardening", rest, "Pa")};
  if (law != "swift" || rest.empty()) refuse("is none of perfect, linear:4GPa, swift:B,C,n");
  const std::vector<std::string> words = split(rest, ',');
  if (words.size() != 3) refuse("has not the three values B,C,n of swift, such as swift:2GPa,4e-6,0.1");
  auto number = [&](const std::string& word) { return parse_quantities("hardening", word, "1")[0]; };
  return Hardening::swift(parse_quantity("hardening", words[0], "Pa"), number(words[1]), number(words[2]));
}

std::vector<double> parse_edges(const std::string& text, double cell) {
  if (text.empty()) return {};
  return parse_series("depths", text, Steps::uniform, [&](const std::string& word) {
    return word == "0" ? 0 : parse_length("depths", word).metres(cell);
  });
}

// What the increments change most.
struct LoadedState {
  double max_pressure, load, approach, dent;

  double difference(const LoadedState& other) const {
    double out = 0;
    for (const double LoadedState::*member :
         {&LoadedState::max_pressure, &LoadedState::load, &LoadedState::approach, &LoadedState::dent})
      if (this->*member != 0) out = std::max(out, std::abs(other.*member / this->*member - 1));
    return out;
  }
};

LoadedState state_of(PlasticContact& path) {
  const Contact& c = path.contact();
  return {c.max_pressure, c.load, c.approach,
          std::max(path.displacement(0).maxCoeff(), path.displacement(1).maxCoeff())};
}

bool has_flown(const PlasticContact& path) { return path.flowing(0) || path.flowing(1); }

// Of each body: what value(FlowingBody) is; 0 of an elastic one.
template <class Value>
std::vector<double> of_bodies(const Flow& flow, Value value) {
  std::vector<double> out(2, 0.0);
  for (std::size_t i = 0; i < 2; ++i)
    if (const auto n = flow.path->flowing(i)) out[i] = value(flow.path->body(*n));
  return out;
}

// Of the bodies that flow, each once.
template <class Value>
double of_all(const Flow& flow, Value value) {
  double out = 0;
  const auto first = flow.path->flowing(0), second = flow.path->flowing(1);
  if (first) out += value(flow.path->body(*first));
  if (second && second != first) out += value(flow.path->body(*second));
  return out;
}

void put_volume(Dataset& data, const std::string& name, const std::string& meaning,
                std::vector<double> values) {
  Variable out{name, {"layer", "x", "y"}, {}, {}};
  const auto [low, high] = std::ranges::minmax(values);
  out.attributes.set("long_name", meaning);
  out.attributes.set("units", "1");
  out.attributes.set_values("actual_range", std::vector<double>{low, high});
  out.values = std::move(values);
  data.put(std::move(out));
}

void record_strain(Dataset& data, const Grid& grid, const PlasticContact& path, FlowingBody& body,
                   const std::string& name, const std::string& of) {
  const PlasticBox& box = path.box();
  const Index layers = box.layers(), cells = grid.shape.cells();
  auto volume = [&](auto value) {
    std::vector<double> out(size(layers * cells), 0.0);
    for (Index k = 0; k < layers; ++k) {
      Eigen::Map<Field> layer(out.data() + k * cells, grid.shape.nx, grid.shape.ny);
      layer.block(box.x.first, box.y.first, box.x.count, box.y.count) = value(k);
    }
    return out;
  };
  put_volume(data, name, "equivalent plastic strain of " + of,
             volume([&](Index k) -> Field { return body.equivalent()(k, 0); }));
  for (const stress::Component c : stress::components)
    put_volume(data, name + "_" + std::string(stress::names[c]),
               fmt::format("plastic strain {} of {}, z into the body", stress::names[c], of),
               volume([&](Index k) {
                 Field out = Field::Zero(box.x.count, box.y.count);
                 for (std::size_t d = 0; d < deviator::components; ++d) {
                   deviator::Vector unit{};
                   unit[d] = 1;
                   const double weight = deviator::tensor(unit)[c];
                   if (weight != 0) out += weight * body.strain()(k, static_cast<Index>(d));
                 }
                 return out;
               }));
}

}  // namespace

// ---- options ----

void PlasticOptions::declare(Tool& tool) {
  const std::string flow = "Plastic flow";
  tool.choice(
      "--plasticity", model, {"cut", "j2"},
      "How the bodies yield; cut: the pressure is limited to 3 times the yield stress of the softer body, "
      "and the stress below is elastic; j2: each body flows where its von Mises stress reaches its yield "
      "stress, so that the surface is dented and a residual stress stays. cut suffices for area and "
      "approach at modest roughness; dents, largest pressures and stresses below need j2",
      flow);
  tool.text(
      "--hardening", hardening_, "LAW",
      "How the flow stress grows with the equivalent plastic strain e, of j2; perfect, linear:4GPa (yield "
      "stress + 4GPa e), or swift:B,C,n (B (C + e)^n, in place of --yield; swift:2.2GPa,4e-6,0.08)",
      flow);
  tool.text(
      "--depths", depths_, "DEPTHS",
      "Bounds of the layers that may flow, of j2; 0:0.8mm:25, or a list that begins with 0. Default: 24 "
      "layers as deep as it flows, a quarter of a cell thick at the surface where asperities flow",
      flow);
  tool.integer(
          "--increments", increments, {1, 10'000},
          "Increments of the load, of j2; their error falls as 1/N. Default: 8, 16 or 32, until half as many "
          "give the same to 1 %. On a way of --sweep: of the largest load, 8 by default",
          flow)
      .without_default();
  tool.flag("--unload", unload,
            "Take the load off again, of j2: what stays are dent, strain and residual stress, which "
            "asperity-stress then computes alone",
            flow);
}

void PlasticOptions::check_model(const Tool& tool) const {
  if (flows()) return;
  for (const char* option : {"--hardening", "--depths", "--increments", "--unload"})
    if (tool.given(option))
      throw UsageError(std::string(option).substr(2), "belongs to plastic flow: add --plasticity j2");
}

void PlasticOptions::check(const Tool& tool) {
  check_model(tool);
  if (!flows()) return;
  if (tool.given("--limit-pressure"))
    throw UsageError("limit-pressure", "belongs to --plasticity cut: give the yield stress, --yield");
  const bool swift = hardening_.starts_with("swift");
  if (swift && tool.given("--yield"))
    throw UsageError("yield", "is B C^n of --hardening swift:B,C,n: leave it out");
  if (!swift && !tool.given("--yield"))
    throw UsageError("yield", "is required with --plasticity j2, of each body, or --hardening swift:B,C,n");
  for (std::size_t i = 0; i < 2; ++i) {
    parameters.hardening[i] = parse_hardening(hardening_, yield[i]);
    parameters.hardening[i].check();
    yield[i] = parameters.hardening[i].yield;
  }
  parameters.edges = parse_edges(depths_, 1);
  parameters.check();
}

PlasticParameters PlasticOptions::on(const Grid& grid) const {
  PlasticParameters out = parameters;
  out.edges = parse_edges(depths_, std::min(grid.dx, grid.dy));
  return out;
}

// ---- the path ----

Contact Flow::contact() const {
  Contact out = path->contact();
  out.convolutions = path->convolutions();
  if (out.load == 0 && greatest_load > 0) out.flattening_load = greatest_load;
  if (path->converged()) return out;
  out.converged = false;
  out.reason = path->reason();
  return out;
}

Flow press_with_flow(const PlasticOptions& options, const PlasticTarget& target,
                     const std::function<std::shared_ptr<PlasticContact>()>& make) {
  auto pressed = [&](int increments) {
    Flow out{make(), increments};
    out.path->go_to(target, increments);
    out.greatest_load = out.path->contact().load;
    return out;
  };
  Flow out;
  if (options.increments > 0) {
    out = pressed(options.increments);
  } else {
    out = pressed(first_increments / 2);
    LoadedState before = state_of(*out.path);
    for (int n = first_increments; n <= most_increments && has_flown(*out.path); n *= 2) {
      const int evaluations = out.path->evaluations() + out.former_evaluations;
      out = pressed(n);
      out.former_evaluations = evaluations;
      const LoadedState now = state_of(*out.path);
      out.increment_error = now.difference(before);
      if (out.increment_error <= increments_agree || !out.path->converged()) break;
      before = now;
    }
  }
  if (options.unload) out.path->go_to({}, std::clamp(out.increments / 2, 1, most_unloading));
  return out;
}

void go_on(Flow& flow, const PlasticOptions& options, double load, double greatest) {
  const int whole = options.increments > 0 ? options.increments : first_increments;
  const double step = std::abs(load - flow.path->contact().load) / greatest;
  flow.path->go_to({.load = load}, std::max(1, static_cast<int>(std::ceil(whole * step * (1 - 1e-9)))));
  flow.increments = whole;
  flow.greatest_load = std::max(flow.greatest_load, load);
}

// ---- the record ----

void record_flow(Attributes& a, const PlasticOptions& options, const Flow& flow) {
  PlasticContact& path = *flow.path;
  a.set("contact_plasticity", options.model);
  a.set_values("contact_yield", std::vector<double>(options.yield.begin(), options.yield.end()));
  a.set("contact_hardening", options.hardening());
  a.set("contact_increments", flow.increments);
  if (std::isfinite(flow.increment_error)) a.set("contact_increment_error", flow.increment_error);
  a.set("contact_evaluations", path.evaluations() + flow.former_evaluations);
  a.set("contact_plastic_residual", path.residual());
  std::vector<double> dents{path.displacement(0).maxCoeff(), path.displacement(1).maxCoeff()};
  a.set_values("contact_dent", std::move(dents));
  if (!has_flown(path)) return;
  a.set_values("contact_layer_edges", path.box().edges);
  const std::vector<double>& edges = path.box().edges;
  a.set_values("contact_plastic_volume", of_bodies(flow, [&](FlowingBody& body) {
                 double volume = 0;
                 for (Index k = 0; k < body.layers(); ++k)
                   volume += (edges[size(k + 1)] - edges[size(k)]) * body.cell_area() *
                             static_cast<double>((body.equivalent()(k, 0) > 0).count());
                 return volume;
               }));
  a.set_values("contact_max_plastic_strain",
               of_bodies(flow, [](FlowingBody& body) { return body.equivalent().values.maxCoeff(); }));
  a.set("contact_dissipated_energy", of_all(flow, [](FlowingBody& body) { return body.dissipated(); }));
  a.set("contact_stored_energy", of_all(flow, [](FlowingBody& body) { return body.stored(); }));
}

void record_strain(Dataset& data, const Grid& grid, const Flow& flow) {
  PlasticContact& path = *flow.path;
  if (!has_flown(path)) return;
  const PlasticBox& box = path.box();
  data.set_dimension("layer", box.layers());
  std::vector<double> middles;
  for (std::size_t k = 1; k < box.edges.size(); ++k) middles.push_back((box.edges[k - 1] + box.edges[k]) / 2);
  Variable layer{"layer", {"layer"}, std::move(middles), {}};
  layer.attributes.set("long_name", "middle depth of a layer that may flow");
  layer.attributes.set("units", "m");
  layer.attributes.set("positive", "down");
  data.put(std::move(layer));
  const auto first = path.flowing(0), second = path.flowing(1);
  if (first)
    record_strain(data, grid, path, path.body(*first), "plastic_strain",
                  second == first ? "each body" : "the first body");
  if (second && second != first)
    record_strain(data, grid, path, path.body(*second), "plastic_strain_counter", "the second body");
}

}  // namespace asperity::cli
