#include "stress/section.hpp"

#include <algorithm>
#include <numbers>

namespace asperity {
namespace {

constexpr Index width = LayerInfluence::width, before = Interpolation::before;

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

Grid turned(const Grid& g) { return {{g.shape.ny, g.shape.nx}, g.dy, g.dx, g.periodic}; }
Friction turned(const Friction& f) { return {f.coefficient, 0.5 * std::numbers::pi - f.angle}; }

}  // namespace

StressSection::StressSection(const Grid& grid, const Field& pressure, const Friction& friction,
                             double poisson, Plane plane, int threads, DepthResolution resolution)
    : plane_(plane),
      grid_(plane.along_x ? turned(grid) : grid),
      pressure_(plane.along_x ? Field(pressure.transpose()) : pressure),
      weights_((plane.along_x ? turned(friction) : friction).weights()),
      poisson_(poisson),
      threads_(threads),
      levels_(grid_, resolution) {
  check_load(grid, pressure, friction, poisson);
}

const PlaneLoad& StressSection::load(std::size_t level) const {
  return levels_.get(level, [&](Index s) {
    return std::make_unique<const PlaneLoad>(grid_, pressure_, plane_.index, s, threads_);
  });
}

void StressSection::rows(const std::vector<double>& depths, stress::Set asked, const LayerRowSink& row,
                         const LayersFinished& finished) const {
  stress::Set needed = asked;
  if (plane_.along_x)
    for (stress::Component c : stress::components) needed[c] = asked[exchanged(c)];
  auto compute = [&](Index l, Workspace& work) {
    const StressRow found = row_at(depths[size(l)], needed, work);
    StressRow out{};
    for (stress::Component c : stress::components) out[c] = found[plane_.along_x ? exchanged(c) : c];
    row(l, plane_.index, out);
  };
  in_layers<Workspace>(static_cast<Index>(depths.size()), threads_, compute, finished);
}

StressSection::Workspace::Level& StressSection::prepared(Workspace& work, std::size_t level) const {
  const Resolution& r = load(level).resolution();
  work.levels.resize(levels_.count());
  Workspace::Level& w = work.levels[level];
  if (w.influence) return w;
  const Shape torus = r.transform().torus();
  w.influence = make_layer_influence(r.cells(), torus, poisson_, acting(weights_), r.taper());
  w.transform = std::make_unique<const RowTransform>(torus.ny);
  w.rows = w.transform->work();
  w.modes.resize(size(w.transform->blocks() * 6 * width));
  w.stride = torus.ny + 2 * width;
  w.samples.resize(size(6 * w.stride));
  return w;
}

StressRow StressSection::row_at(double z, stress::Set asked, Workspace& work) const {
  check_depth(z);
  const std::size_t level = levels_.at(z);
  const PlaneLoad& seen = load(level);
  const Resolution& r = seen.resolution();
  Workspace::Level& w = prepared(work, level);
  w.influence->descend(z, asked, seen.terms());
  Index count = 0;
  for (stress::Component c : stress::components)
    if (asked[c]) compute_modes(seen, c, count++, w);
  const Index py = r.transform().torus().ny;
  w.transform->inverse(w.modes.data(), 6 * width, count, py, w.samples.data() + before, w.stride, w.rows);

  StressRow out{};
  double* row = w.samples.data();
  for (stress::Component c : stress::components) {
    if (!asked[c]) continue;
    out[c] = row + before;
    if (r.s() > 1) {
      std::copy_n(row + py, before, row);
      for (Index j = py + before; j < w.stride; ++j) row[j] = row[j - py];
      work.refined[c].resize(size(r.interpolation().padded(points())));
      r.interpolation().refine(row, points(), work.refined[c].data());
      out[c] = work.refined[c].data();
    }
    row += w.stride;
  }
  return out;
}

void StressSection::compute_modes(const PlaneLoad& seen, stress::Component c, Index r,
                                  Workspace::Level& w) const {
  for (Index b = 0; b < w.transform->blocks(); ++b) {
    Complex* to = w.modes.data() + (6 * b + r) * width;
    std::fill_n(to, width, Complex{});
    for (stress::Traction t : stress::tractions) {
      if (weights_[t] == 0) continue;
      double sum[2 * width] = {};
      seen.add(w.influence->terms(t, c, b), odd_in_x(c, t), b, sum);
      const Complex factor = odd_in_y(c, t) ? Complex{0, -weights_[t]} : Complex{weights_[t], 0};
      for (Index q = 0; q < width; ++q) to[q] += factor * Complex{sum[q], sum[width + q]};
    }
  }
}

}  // namespace asperity
