// Several ranks press as one does.
#include "reference/ranks.hpp"

#include "contact/sweep.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

struct Scene {
  std::string name;
  Grid grid;
  Field gap;
  ContactParameters parameters;
};

// What does not depend on time, of all ranks.
struct Solved {
  Field pressure, gap, displacement;
  std::vector<double> figures;

  bool operator==(const Solved& other) const {
    return (pressure == other.pressure).all() && (gap == other.gap).all() &&
           (displacement == other.displacement).all() && figures == other.figures;
  }
};

Solved solved(const Contact& c, const Slabs& slabs) {
  auto all = [&](const Field& f) { return rows_of(f, slabs, Extent{0, slabs.rows()}); };
  return {all(c.pressure),
          all(c.gap),
          all(c.displacement),
          {c.load, c.approach, c.mean_gap, c.max_pressure, c.area, c.plastic_area, c.residual,
           c.load_residual, c.convolutions, c.preconditionings, c.stiffness > 0 ? c.stiffness : 0,
           static_cast<double>(c.levels), static_cast<double>(c.converged)}};
}

Field own_rows(const Field& f, const Slabs& slabs) {
  return f.middleRows(slabs.own().first, slabs.own().count);
}

// By so many ranks, as the first has it.
Solved press_by(int count, int threads, const Scene& s) {
  ThreadRanks ranks(count);
  Solved out;
  ranks.run([&](const Ranks& one) {
    const auto body = make_influence(s.grid, modulus, threads, one);
    ContactParameters parameters = s.parameters;
    parameters.threads = threads;
    const Contact contact = solve_contact(s.grid, own_rows(s.gap, body->slabs()), *body, parameters);
    Solved found = solved(contact, body->slabs());
    if (one.rank() == 0) out = std::move(found);
  });
  return out;
}

Field rough(const Grid& grid) { return -2e-7 * exponential_heights(grid.shape, 20, 5); }

}  // namespace

TEST_CASE("every rank gets the rows that it asks for, in its own order", "[ranks][exact]") {
  const Field whole = random_field({200, 7}, 8);
  for (const int count : {1, 2, 3, 5}) {  // the last has ranks without rows
    std::vector<Field> found(static_cast<std::size_t>(count));
    ThreadRanks(count).run([&](const Ranks& ranks) {
      const Slabs slabs(whole.rows(), ranks);
      const auto k = static_cast<std::size_t>(ranks.rank());
      found[k] = rows_of(own_rows(whole, slabs), slabs, std::vector<Index>{199, ranks.rank(), 0, 64, 64});
    });
    for (std::size_t k = 0; k < found.size(); ++k)
      CHECK((found[k] == whole(std::vector<Index>{199, static_cast<Index>(k), 0, 64, 64}, Eigen::all)).all());
  }
}

TEST_CASE("where work fails on some ranks, all throw the error of the first of them", "[ranks][contract]") {
  std::vector<std::string> errors(3);
  ThreadRanks(3).run([&](const Ranks& ranks) {
    const int rank = ranks.rank();
    agree(ranks, [] {});
    try {
      agree(ranks, [&] {
        if (rank > 0) throw DataError("heights", "of rank " + std::to_string(rank));
      });
    } catch (const DataError& e) {
      errors[static_cast<std::size_t>(rank)] = e.name + ": " + e.what();
    }
  });
  for (const std::string& error : errors) CHECK(error == "heights: of rank 1");
}

TEST_CASE("several ranks find the contact of one, to the last bit", "[ranks][law][slow]") {
  const Grid free = square(576), wide = {{640, 520}, 5e-6, 6e-6, true};
  const Field spheres_and_rough = undeformed_gap(free, spheres) + rough(free);
  const std::vector<Scene> scenes{
      {"rough spheres", free, spheres_and_rough, {.load = 500, .stiffness = true}},
      {"limit pressure", free, spheres_and_rough, {.load = 5000, .limit_pressure = limit}},
      {"approach", free, spheres_and_rough, {.approach = 3e-6}},
      {"rough flat", free, rough(free), {.load = 400, .stiffness = true}},
      {"periodic", wide, rough(wide), {.load = 200, .stiffness = true}},
      {"small window", free, undeformed_gap(free, spheres), {.load = 1}},
  };
  for (const Scene& scene : scenes) {
    const Solved one = press_by(1, 1, scene);
    for (const auto& [count, threads] : {std::pair{3, 1}, std::pair{4, 2}}) {
      CAPTURE(scene.name, count, threads);
      CHECK(press_by(count, threads, scene) == one);
    }
  }
}
