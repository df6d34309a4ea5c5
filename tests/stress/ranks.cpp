// Several ranks compute layers, sections and their maxima as one does, to the last bit.
#include "reference/ranks.hpp"

#include <atomic>
#include <mutex>

#include "core/error.hpp"
#include "stress/load.hpp"
#include "stress/maximum.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Rows of layers, [layer][component], each of the rows that were handed over, by their number.
struct Layers {
  Layers(std::size_t count, Shape shape)
      : values(count, std::vector<Field>(6, Field::Zero(shape.nx, shape.ny))), seen(shape.nx) {}
  std::vector<std::vector<Field>> values;
  std::vector<int> seen;

  bool operator==(const Layers& other) const {
    for (std::size_t l = 0; l < values.size(); ++l)
      for (std::size_t c = 0; c < 6; ++c)
        if (!(values[l][c] == other.values[l][c]).all()) return false;
    return seen == other.seen;
  }
};

// All components at once, and then xx and xz one by one.
void compute(const StressSolver& solver, const std::vector<double>& depths, Layers& out, std::mutex& mutex) {
  for (const stress::Set asked : {stress::all, stress::Set().set(stress::xx), stress::Set().set(stress::xz)})
    solver.layers(depths, asked, [&](Index l, Index i, const StressRow& row) {
      const std::scoped_lock lock(mutex);
      ++out.seen[static_cast<std::size_t>(i)];
      for (auto c : stress::components)
        if (asked[c])
          out.values[static_cast<std::size_t>(l)][c].row(i) +=
              Eigen::Map<const Eigen::Array<double, 1, Eigen::Dynamic>>(row[c].data(),
                                                                        static_cast<Index>(row[c].size()));
    });
}

LoadedBody shared(const LoadedBody& body, const Ranks& ranks) {
  const Extent own = Slabs(body.grid.shape.nx, ranks).own();
  return {body.grid, body.pressure.middleRows(own.first, own.count), body.poisson, body.friction, &ranks};
}

// Below 5.4 from cells twice as wide, below 10.8 four times.
const std::vector<double> depths{0, 1.3, 5.6, 12};

std::vector<LoadedBody> bodies() {
  std::vector<LoadedBody> out;
  for (const Periodic periodic :
       {Periodic{}, Periodic{true, true}, Periodic{true, false}, Periodic{false, true}})
    for (const Friction& friction : {Friction{}, Friction{0.4, 0.6}}) {
      const Grid grid{{200, 72}, 0.5, 0.3, periodic};
      Field p = random_field(grid.shape, 71).abs();
      p *= (p > 0.3).cast<double>();
      p.bottomRows(20) = 0;
      out.push_back({grid, p, 0.3, friction});
    }
  return out;
}

}  // namespace

TEST_CASE("several ranks compute layers and sections as one does, to the last bit", "[stress][ranks][law]") {
  for (const LoadedBody& body : bodies())
    for (const auto& plane :
         {std::optional<Plane>(), std::optional(Plane{true, 40}), std::optional(Plane{false, 30})}) {
      std::mutex mutex;
      const StressSolver alone(body, plane, 1, DepthResolution::adapted);
      Layers wanted(depths.size(), alone.shape());
      compute(alone, depths, wanted, mutex);
      for (const int count : {2, 3, 5}) {
        Layers found(depths.size(), alone.shape());
        ThreadRanks(count).run([&](const Ranks& ranks) {
          compute({shared(body, ranks), plane, 1 + count % 2, DepthResolution::adapted}, depths, found,
                  mutex);
        });
        CAPTURE(body.grid.periodic.x, body.grid.periodic.y, body.friction.coefficient, plane.has_value(),
                count);
        CHECK(found == wanted);
      }
    }
}

TEST_CASE("several ranks find the largest stress of layers, and its bound, as one does",
          "[stress][ranks][law]") {
  for (const LoadedBody& body : bodies()) {
    const auto wanted = maximum_by_depth(StressSolver(body), Criterion::max_shear, depths);
    ThreadRanks(3).run([&](const Ranks& ranks) {
      const LoadedBody own = shared(body, ranks);
      const auto found = maximum_by_depth(StressSolver(own), Criterion::max_shear, depths);
      const double bound = stress_bound(own), largest = own.largest(), least = own.least();
      const Field whole = own.on_the_first().pressure;
      if (ranks.rank() > 0) return;
      for (std::size_t l = 0; l < depths.size(); ++l) {
        CHECK(found[l].value == wanted[l].value);
        CHECK((found[l].x == wanted[l].x && found[l].y == wanted[l].y));
      }
      CHECK(bound == stress_bound(body));
      CHECK((largest == body.pressure.maxCoeff() && least == 0));
      CHECK((whole == body.pressure).all());
    });
  }
}

TEST_CASE("several ranks find no stress below an unloaded surface", "[stress][ranks][exact]") {
  LoadedBody body = bodies().front();
  body.pressure = 0;
  std::atomic<bool> stressed = false;
  for (const auto& plane : {std::optional<Plane>(), std::optional(Plane{true, 40})})
    ThreadRanks(2).run([&](const Ranks& ranks) {
      const StressSolver solver(shared(body, ranks), plane);
      StressSolver::Workspace work;
      solver.layer(1, stress::all, work, [&](Index, const StressRow& row) {
        for (auto c : stress::components)
          for (const double value : row[c]) stressed = stressed || value != 0;
      });
    });
  CHECK_FALSE(stressed);
}

TEST_CASE("a pressure that is not finite on one rank is refused on all", "[stress][ranks][contract]") {
  LoadedBody body = bodies().front();
  body.pressure(190, 3) = NAN;
  CHECK_THROWS_AS(ThreadRanks(3).run([&](const Ranks& ranks) { StressSolver(shared(body, ranks)); }),
                  DataError);
}
