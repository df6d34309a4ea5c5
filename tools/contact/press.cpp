#include "tools/contact/press.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "contact/influence.hpp"
#include "contact/stiffness.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/contact/resolution.hpp"

namespace asperity::cli {

ElasticOperator& Influence::on(const Grid& grid) {
  if (!made_ || grid.dx != grid_.dx || grid.dy != grid_.dy || !same_grid(grid, grid_)) {
    made_ =
        make_influence(grid, options_.bodies.composite_modulus(), options_.contact.threads, *options_.ranks);
    told_ = 0;
  }
  grid_ = grid;
  made_->forget_windows();
  return *made_;
}

double Influence::further_seconds() {
  const double now = made_->setup_seconds();
  return now - std::exchange(told_, now);
}

std::unique_ptr<Influence> Influences::taken() {
  const std::scoped_lock lock(mutex_);
  if (free_.empty()) return std::make_unique<Influence>(options_);
  std::unique_ptr<Influence> out = std::move(free_.back());
  free_.pop_back();
  return out;
}

void Influences::put_back(std::unique_ptr<Influence> one) {
  const std::scoped_lock lock(mutex_);
  free_.push_back(std::move(one));
}

Pressed press(const ContactOptions& options, ContactScene& scene, Influence& influence) {
  ElasticOperator& body = influence.on(scene.grid);
  const bool pressed_again = options.adds("grid_errors");  // on coarser cells; else the gap has served
  Field gap = pressed_again ? scene.gap : std::move(scene.gap);
  Pressed out{solve_contact(scene.grid, std::move(gap), body, options.contact), {}, {}};
  out.contact.setup_seconds = influence.further_seconds();
  out.figures = grid_figures(options, scene, body, out.contact);
  record(scene, options, out.contact, out.figures);
  out.doubts = doubts(scene.grid, options.bodies, out.contact);
  for (Doubt& doubt : doubts(out.figures)) out.doubts.push_back(std::move(doubt));
  return out;
}

void SweepDoubts::add(const Tool& tool, const std::vector<Doubt>& doubts, const std::string& load) {
  for (const Doubt& doubt : doubts) {
    Seen& seen = seen_[doubt.about];
    if (seen.loads++ == 0) tool.warn(load + ": " + doubt.words);
    seen.last = load;
  }
}

void SweepDoubts::tell(const Tool& tool) const {
  for (const auto& [about, seen] : seen_)
    if (const int more = seen.loads - 1; more > 0)
      tool.warn(fmt::format("the contact {} under {} more load{}, up to {}", about, more,
                            more == 1 ? "" : "s", seen.last));
}

int told_exit(const Tool& tool, const ContactOptions& options, const Contact& contact,
              const std::string& of) {
  if (!contact.converged) tool.warn(of + "not converged: " + contact.reason);
  const bool stiff = !options.contact.stiffness || !std::isnan(contact.stiffness);
  if (contact.converged && !stiff)
    tool.warn(of + fmt::format(
                       "the stiffness is not converged: residual {:.1e} above {:.0e}; see --max-convolutions",
                       contact.stiffness_residual, stiffness_tolerance));
  return contact.converged && stiff ? done : not_converged;
}

}  // namespace asperity::cli
