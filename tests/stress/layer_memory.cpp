#include "layer.hpp"
#include "reference/peak_memory.hpp"
#include "stress/equivalent.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool counts_memory = false;
#else
constexpr bool counts_memory = true;
#endif

// As many cells as threads share.
const Grid shared{{768, 768}, 1, 1};

Field mises_one_by_one(const StressSolver& solver, double z, StressSolver::Workspace& work) {
  const Shape shape = solver.shape();
  MisesLayer sum(shape);
  for (auto c : stress::components)
    solver.layer(z, stress::Set().set(c), work,
                 [&](Index i, const StressRow& row) { sum.add(c, i, row[c]); });
  Field out(shape.nx, shape.ny);
  for (Index i = 0; i < shape.nx; ++i) sum.row(i, 1, {out.row(i).data(), size(shape.ny)});
  return out;
}

Field mises_at_once(const StressSolver& solver, double z) {
  const Shape shape = solver.shape();
  Field out(shape.nx, shape.ny);
  StressSolver::Workspace work;
  solver.layer(z, stress::all, work, [&](Index i, const StressRow& row) {
    von_mises(row, {out.row(i).data(), size(shape.ny)});
  });
  return out;
}

}  // namespace

TEST_CASE("the von Mises stress of one component after the other is that of all at once, to the last bit",
          "[layers][exact]") {
  for (const Grid& grid : {Grid{{20, 13}, 0.4, 0.3}, Grid{{96, 160}, 1, 1}, Grid{{64, 40}, 1, 1, true},
                           Grid{{64, 40}, 1, 1, {true, false}}})
    for (const Friction& friction : {Friction{}, Friction{0.3, 0.4}}) {
      const StressSolver solver({grid, random_field(grid.shape, 31), 0.3, friction}, 1,
                                DepthResolution::adapted);
      StressSolver::Workspace work;
      for (double z : {0.3, 11.0, 40.0}) {
        CAPTURE(grid.shape.nx, grid.periodic.x, grid.periodic.y, friction.coefficient, z);
        CHECK((mises_one_by_one(solver, z, work) == mises_at_once(solver, z)).all());
      }
    }
}

TEST_CASE("layers that threads share have the bits of one thread, in whatever order of depths",
          "[layers][law][slow]") {
  const LoadedBody body{shared, random_field(shared.shape, 32).abs(), 0.3, {0.2, 0.5}};
  const std::vector<double> depths{0.3, 30, 12, 0.7};
  const StressSolver one(body, 1, DepthResolution::adapted), three(body, 3, DepthResolution::adapted);
  std::vector<Index> order;
  three.each_layer(
      depths,
      [&](Index l, StressSolver::Workspace& work) {
        CAPTURE(l);
        const double z = depths[size(l)];
        CHECK((mises_one_by_one(three, z, work) == mises_at_once(one, z)).all());
      },
      [&](Index begin, Index end) {
        for (Index l = begin; l < end; ++l) order.push_back(l);
      });
  CHECK(order == std::vector<Index>{0, 1, 2, 3});
}

// By count 1 for the solver's own pressure, 4 for its spectrum, 2 for the modes of a component, 2 in which the sum
// is formed: 9 doubles a cell; all six components in their own buffers would be 22 on one thread and 40 on two.
// Plans, threads' rows and what the allocator holds back depend on the system: the bound is between 9 and 22.
TEST_CASE("below the surface of a large grid the von Mises stress takes no more memory on two threads",
          "[layers][contract][slow]") {
  if (!counts_memory) return;
  const Field pressure = random_field(shared.shape, 33).abs();
  auto layers = [&](int threads, DepthResolution resolution, double deepest) {
    const double megabytes = peak_memory([&] {
      const StressSolver solver({shared, pressure, 0.3}, threads, resolution);
      MisesLayer sum(shared.shape);
      solver.each_layer({0.5, deepest}, [&](Index l, StressSolver::Workspace& work) {
        for (auto c : stress::components)
          solver.layer(l == 0 ? 0.5 : deepest, stress::Set().set(c), work,
                       [&](Index i, const StressRow& row) { sum.add(c, i, row[c]); });
      });
    });
    return megabytes * 1e6 / sizeof(double) / static_cast<double>(shared.shape.cells());
  };
  for (int threads : {1, 2}) {
    CAPTURE(threads);
    CHECK(layers(threads, DepthResolution::full, 2) <= 0.5 * (9 + 22));
    CHECK(layers(threads, DepthResolution::adapted, 12) <= 0.5 * (9 + 22));
  }
}
