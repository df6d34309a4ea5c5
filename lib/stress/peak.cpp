#include <algorithm>
#include <cmath>
#include <memory>

#include "stress/search.hpp"

namespace asperity {
namespace {

using stress::Component;
using stress::Tensor;
using Vector = std::array<double, 3>;

constexpr Index window_side = 24;               // cells along a side
constexpr double point_step = 0.03;             // of the depth, between the points of a quadratic
constexpr double widest = 0.5;                  // of the depth, from its middle
constexpr double coarse = 0.02, finest = 2e-5;  // of the depth, last steps
constexpr double settled = 2e-8;                // of the value
constexpr int most_rounds = 24;

// How many cells make up one as wide as a third of the depth, of windows of at most twice the domain.
Index width_at(double z, double spacing, Index n) {
  Index s = 1;
  while (2 * wide_cell_depth * static_cast<double>(s) * spacing <= z && window_side * s < 2 * n) s *= 2;
  return s;
}

Index cell_at(double place, double spacing, Index n) {
  return static_cast<Index>(std::floor(place / spacing + 0.5 * static_cast<double>(n)));
}

}  // namespace

// The stress about a place: the window's, and what the field has beyond it.
class PeakFinder::Model {
 public:
  // At the place alone; `quadratic` adds points around it.
  Model(const PeakFinder& of, const StressPlace& at, bool centred)
      : of_(of),
        along_x_(at.x, at.z, of.body_.grid.dx, of.body_.grid.shape.nx),
        along_y_(at.y, at.z, of.body_.grid.dy, of.body_.grid.shape.ny),
        window_(window_of(of.body_, along_x_, along_y_)),
        at_(at),
        centred_(centred),
        scale_(std::max(at.z, 0.1 * std::min(of.body_.grid.dx, of.body_.grid.dy))) {
    middle_ = beyond({});
    at_.value = value(at.x, at.y, at.z);
  }

  void quadratic() {
    const Grid& g = of_.body_.grid;
    const double d = point_step * scale_;
    const Vector by{centred_ ? g.dx : d, centred_ ? g.dy : d, d};
    const std::array<bool, 3> varies{of_.varies_x(), of_.varies_y(), true};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!varies[k]) continue;
      const bool above = k < 2 || at_.z >= d;  // else twice below
      Vector to{}, back{};
      to[k] = by[k], back[k] = above ? -by[k] : 2 * by[k];
      const Tensor once = beyond(to), other = beyond(back);
      for (Component c : stress::components) {
        const double f = middle_[c], twice = 2 * by[k] * by[k];
        bend_[k][c] = (above ? once[c] - 2 * f + other[c] : other[c] - 2 * once[c] + f) / twice;
        slope_[k][c] = (once[c] - f) / by[k] - bend_[k][c] * by[k];
      }
    }
    // Where it repeats the load is one of waves, which differ from the window's steps in products, too.
    if (g.periodic.both())
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = k == 0 ? 1 : 0, j = k == 2 ? 1 : 2;
        if (!varies[i] || !varies[j]) continue;
        Vector up{}, down{};
        up[i] = by[i], down[i] = -by[i], up[j] = down[j] = by[j];
        const Tensor one = beyond(up), other = beyond(down);
        for (Component c : stress::components)
          twist_[k][c] = (one[c] - other[c] - 2 * by[i] * slope_[i][c]) / (2 * by[i] * by[j]);
      }
  }

  Tensor at(double x, double y, double z) const {
    const Vector by{x - at_.x, y - at_.y, z - at_.z};
    Tensor s = near_at(x, y, z);
    for (Component c : stress::components) {
      s[c] += middle_[c] + by[1] * by[2] * twist_[0][c] + by[0] * by[2] * twist_[1][c] +
              by[0] * by[1] * twist_[2][c];
      for (std::size_t k = 0; k < 3; ++k) s[c] += by[k] * (slope_[k][c] + by[k] * bend_[k][c]);
    }
    return s;
  }
  double value(double x, double y, double z) const { return equivalent_stress(of_.of_, at(x, y, z)); }
  const StressPlace& place() const { return at_; }
  double scale() const { return scale_; }
  bool centred() const { return centred_; }

 private:
  // Cells along an axis, s of which make a wide one of the window.
  struct Along {
    Index s, first;
    double middle;  // of the window [m]
    Along(double place, double z, double spacing, Index n)
        : s(width_at(z, spacing, n)), first(cell_at(place, spacing, n) - window_side / 2 * s) {
      middle = (static_cast<double>(first + window_side / 2 * s) - 0.5 * static_cast<double>(n)) * spacing;
    }
  };

  static LoadedBody window_of(const LoadedBody& body, const Along& x, const Along& y) {
    const Grid& g = body.grid;
    Field p = Field::Zero(window_side, window_side);
    for (Index i = 0; i < window_side * x.s; ++i)
      for (Index j = 0; j < window_side * y.s; ++j) p(i / x.s, j / y.s) += body.at(x.first + i, y.first + j);
    p /= static_cast<double>(x.s * y.s);
    return {{{window_side, window_side}, static_cast<double>(x.s) * g.dx, static_cast<double>(y.s) * g.dy},
            p,
            body.poisson,
            body.friction};
  }

  Tensor near_at(double x, double y, double z) const {
    return window_.at(x - along_x_.middle, y - along_y_.middle, z);
  }
  // Of the field at a place seen from the middle.
  Tensor beyond(const Vector& by) const {
    const double x = at_.x + by[0], y = at_.y + by[1], z = at_.z + by[2];
    Tensor s = of_.field_.at(x, y, z);
    const Tensor near = near_at(x, y, z);
    for (Component c : stress::components) s[c] -= near[c];
    return s;
  }

  const PeakFinder& of_;
  Along along_x_, along_y_;
  CellSum window_;
  StressPlace at_;
  bool centred_;
  double scale_;
  Tensor middle_{};
  std::array<Tensor, 3> slope_{}, bend_{}, twist_{};  ///< twist_[k]: of the two axes other than k
};

PeakFinder::PeakFinder(const LoadedBody& body, Criterion of, double below, int threads)
    : body_(body),
      of_(of),
      below_(below),
      steps_show_(std::max(0.5 * accurate_depth(body.grid), below)),
      field_(body, threads) {}

// Of the cell that holds a place.
double PeakFinder::at_centre(double place, double length, double spacing, Index n, bool periodic) const {
  if (periodic) place = std::remainder(place, length);
  const Index cell = std::clamp<Index>(cell_at(place, spacing, n), 0, n - 1);
  return (static_cast<double>(cell) + 0.5) * spacing - 0.5 * length;
}

// By steps to the highest of the 26 neighbours, smaller where there is none; no farther from the middle
// than `range` times the depth, inside the outermost centres where the domain is free.
StressPlace PeakFinder::largest_of(const Model& m, const StressPlace& from, double range, double last) const {
  const Grid& g = body_.grid;
  const StressPlace& middle = m.place();
  auto inside = [&](double to, double about, double reach, bool periodic, double first, double end) {
    to = std::clamp(to, about - reach, about + reach);
    return periodic ? to : std::clamp(to, first, end);
  };
  const double reach_x = m.centred() ? 3 * g.dx : range * m.scale(),
               reach_y = m.centred() ? 3 * g.dy : range * m.scale(), reach_z = range * m.scale(),
               over = std::max(middle.z - reach_z, m.centred() ? below_ : steps_show_),
               under = m.centred() ? std::min(middle.z + reach_z, steps_show_) : middle.z + reach_z;
  const int along_x = varies_x(), along_y = varies_y();
  StressPlace top = from;
  for (double step = 0.5 * range; step >= last;) {
    const double d = step * m.scale();
    StressPlace best = top;
    for (int p = -along_x; p <= along_x; ++p)
      for (int q = -along_y; q <= along_y; ++q)
        for (int r = -1; r <= 1; ++r) {
          if (p == 0 && q == 0 && r == 0) continue;
          StressPlace next{0,
                           inside(top.x + p * (m.centred() ? g.dx : d), middle.x, reach_x, g.periodic.x,
                                  g.x(0), g.x(g.shape.nx - 1)),
                           inside(top.y + q * (m.centred() ? g.dy : d), middle.y, reach_y, g.periodic.y,
                                  g.y(0), g.y(g.shape.ny - 1)),
                           std::clamp(top.z + r * d, over, under)};
          if (m.centred() && step < coarse && (p != 0 || q != 0)) continue;
          next.value = m.value(next.x, next.y, next.z);
          if (next.value > best.value) best = next;
        }
    if (best.value - top.value > 1e-9 * std::abs(top.value))
      top = best;
    else
      step *= 0.4;
  }
  return top;
}

// On the cells' centres where the steps between the cells show, else below.
StressPlace PeakFinder::within(StressPlace place, bool centred) const {
  const Grid& g = body_.grid;
  if (!centred) {
    if (!g.periodic.x) place.x = std::clamp(place.x, g.x(0), g.x(g.shape.nx - 1));
    if (!g.periodic.y) place.y = std::clamp(place.y, g.y(0), g.y(g.shape.ny - 1));
    place.z = std::max(place.z, steps_show_);
    return place;
  }
  place.x = at_centre(place.x, g.size_x(), g.dx, g.shape.nx, g.periodic.x);
  place.y = at_centre(place.y, g.size_y(), g.dy, g.shape.ny, g.periodic.y);
  place.z = std::clamp(place.z, below_, steps_show_);
  return place;
}

PeakFinder::Estimate PeakFinder::estimate(const StressPlace& from) const {
  const bool centred = from.z < steps_show_;
  const Model model(*this, within(from, centred), centred);
  return {model.place(), largest_of(model, model.place(), widest, coarse).value};
}

// The highest maximum of a model from eight places about its middle, or this one: peaks may be closer
// together than the points of a scan.
StressPlace PeakFinder::largest_beside(const Model& m, StressPlace top) const {
  const double d = 0.8 * widest * m.scale();
  for (int p = -varies_x(); p <= varies_x(); ++p)
    for (int q = -varies_y(); q <= varies_y(); ++q) {
      StressPlace from = m.place();
      from.x += p * d, from.y += q * d;
      from = within(from, false);
      from.value = m.value(from.x, from.y, from.z);
      if (const StressPlace other = largest_of(m, from, widest, coarse); other.value > top.value) top = other;
    }
  return top;
}

StressPlace PeakFinder::refined(const StressPlace& from, bool centred, double goal) const {
  auto model = std::make_unique<Model>(*this, within(from, centred), centred);
  model->quadratic();
  double range = widest;
  for (int round = 0; round < most_rounds && range >= finest; ++round) {
    const StressPlace& here = model->place();
    const double level = settled * std::abs(here.value), scale = model->scale(), x = here.x, y = here.y,
                 z = here.z;
    StressPlace next = largest_of(*model, here, range, finest);
    if (round == 0 && !centred) next = largest_of(*model, largest_beside(*model, next), range, finest);
    if (next.value + 2e-3 * std::abs(next.value) < goal || next.value - here.value <= level) break;
    auto ahead = std::make_unique<Model>(*this, next, centred);
    const double value = ahead->place().value;
    if (value <= here.value) {  // led too far
      range *= 0.3;
      continue;
    }
    model = std::move(ahead);
    auto free = [&](double by) { return std::abs(by) < 0.9 * range * scale; };  // of the range's end
    if (std::abs(next.value - value) <= level && free(next.z - z) &&
        (centred || (free(next.x - x) && free(next.y - y))))
      break;
    model->quadratic();
  }
  return model->place();
}

StressPlace PeakFinder::find(const StressPlace& from, double goal) const {
  auto higher = [](const StressPlace& a, const StressPlace& b) { return a.value < b.value ? b : a; };
  const bool centred = from.z < steps_show_;
  const StressPlace top = refined(from, centred, goal);
  const bool leads_across =
      centred ? scan_ratio * top.z >= steps_show_ : top.z <= steps_show_ && steps_show_ > below_;
  return leads_across ? higher(top, refined(top, !centred, std::max(goal, top.value))) : top;
}

}  // namespace asperity
