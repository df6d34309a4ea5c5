#include "contact/sweep.hpp"
#include "contact/windowed.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// A half-space that is only ever asked as a whole.
class Whole final : public ElasticOperator {
 public:
  explicit Whole(std::unique_ptr<ElasticOperator> body) : body_(std::move(body)) {}
  Shape shape() const override { return body_->shape(); }
  void apply(const Field& p, Field& u) override { body_->apply(p, u); }
  void precondition(const Field& r, Field& z) override { body_->precondition(r, z); }
  double self_influence() const override { return body_->self_influence(); }
  std::unique_ptr<ElasticOperator> coarsened(Index factor) const override {
    return std::make_unique<Whole>(body_->coarsened(factor));
  }

 private:
  std::unique_ptr<ElasticOperator> body_;
};

Contact press_whole(const Grid& grid, const Field& gap, const ContactParameters& parameters) {
  Whole body(make_influence(grid, modulus));
  return solve_contact(grid, gap, body, parameters);
}

// Two spheres of 10 mm on one side of the domain, the second 5 µm behind the first.
Field two_peaks(const Grid& grid) {
  return sample(grid, [](double x, double y) {
    auto sphere = [&](double at) { return ((x - at) * (x - at) + y * y) / (2 * 10e-3); };
    return std::min(sphere(-1e-3), sphere(1e-3) + 5e-6);
  });
}

}  // namespace

TEST_CASE("the least window of a contact holds its cells and no other row or column", "[window][exact]") {
  const auto contact = [](double value) { return value > 0; };
  Field p = Field::Zero(9, 12);
  const Slabs slabs(9);
  CHECK(window_of(p, slabs, contact).empty());
  p(2, 7) = p(5, 4) = p(3, 9) = 1;
  CHECK(window_of(p, slabs, contact) == ContactWindow{{2, 4}, {4, 6}});
  CHECK(window_of(1 - p, slabs, [](double gap) { return gap < 0.5; }) == ContactWindow{{2, 4}, {4, 6}});
  CHECK(window_of(Field::Ones(9, 12), slabs, contact) == whole({9, 12}));
}

TEST_CASE("on a period the extent is of the fewest lines that hold all", "[window][exact]") {
  Field p = Field::Zero(9, 12);
  p(1, 4) = p(8, 5) = 1;
  const auto marked = [](double value) { return value > 0; };
  CHECK(extents(p, marked) == std::array{Extent{1, 8}, Extent{4, 2}});
  CHECK(extents(p, marked, true) == std::array{Extent{8, 3}, Extent{4, 2}});
}

TEST_CASE("windows are united, widened and enlarged within their domain", "[window][exact]") {
  const Shape domain{20, 30};
  CHECK(united({{2, 4}, {3, 5}}, {{10, 2}, {1, 3}}) == ContactWindow{{2, 10}, {1, 7}});
  CHECK(united({}, {{10, 2}, {1, 3}}) == ContactWindow{{10, 2}, {1, 3}});
  CHECK(widened({{1, 4}, {20, 8}}, 3, domain) == ContactWindow{{0, 8}, {17, 13}});
  CHECK(enlarged({{1, 4}, {20, 8}}, {10, 12}, domain) == ContactWindow{{0, 10}, {18, 12}});
}

TEST_CASE("a body on a window displaces it as the whole body does", "[window][exact]") {
  const Grid grid{{64, 80}, 2e-5, 3e-5};
  const auto body = make_influence(grid, modulus);
  const auto part = body->windowed({20, 30});
  REQUIRE(part);
  const ContactWindow window{{30, part->shape().nx}, {41, part->shape().ny}};
  Field p = Field::Zero(64, 80), u, on_window;
  const Slabs all = body->slabs(), within = part->slabs();
  window.put(random_waves(window.shape(), 1), within, p, all);
  body->apply(p, u);
  part->apply(window.of(p, all, within), on_window);
  CHECK((window.of(u, all, within) - on_window).abs().maxCoeff() <= 1e-14 * u.abs().maxCoeff());
  CHECK(part->self_influence() == body->self_influence());
}

TEST_CASE("windows are shared while they fit, and none is made for most of the grid", "[window][contract]") {
  const auto body = make_influence(square(64), modulus);
  const auto part = body->windowed({20, 30});
  CHECK(body->windowed({20, 30}) == part);
  CHECK(body->windowed({19, 29}) == part);
  CHECK(body->windowed({5, 5}) != part);
  CHECK(body->windowed({60, 60}) == nullptr);
  CHECK(make_influence(periodic(square(64)), modulus)->windowed({5, 5}) == nullptr);
}

// ε of two solutions bounds their pressures' difference by some 10 ε of the maximum pressure.
TEST_CASE("a contact solved on its window is that solved on the whole grid, for fewer convolutions",
          "[window][law]") {
  const Grid grid = square(128);
  for (double q : {10.0, 500.0, 5000.0})
    for (double cap : {limit, infinity}) {
      const ContactParameters parameters{.load = q, .limit_pressure = cap, .tolerance = 1e-8};
      const Contact part = solve_contact(grid, rough_gap(grid), modulus, parameters),
                    all = press_whole(grid, rough_gap(grid), parameters);
      CAPTURE(q, cap, part.convolutions, all.convolutions);
      CHECK((part.pressure - all.pressure).abs().maxCoeff() <= 1e-6 * all.max_pressure);
      CHECK(part.area == all.area);
      CHECK(part.approach == Approx(all.approach).epsilon(1e-7));
      CHECK(part.convolutions < all.convolutions);
    }
}

// The levels' confirmations are 1 + 1/4 + 1/16 + …; the coarsest is solved on the whole, 1/64 of the cells.
TEST_CASE("a contact of a hundred cells in 256 x 256 costs two convolutions", "[window][law]") {
  const Grid grid = square(256);
  const Contact contact = press(grid, undeformed_gap(grid, spheres), {.load = 1});
  CHECK(contact.converged);
  CHECK(contact.area >= 50 * grid.cell_area());
  CHECK(contact.area <= 150 * grid.cell_area());
  CHECK(contact.convolutions <= 2);
}

TEST_CASE("a contact that begins far from the window of the start is found", "[window][law]") {
  const Grid grid = square(128);
  const Field gap = two_peaks(grid);
  const Contact first = solve_contact(grid, gap, modulus, {.load = 5, .tolerance = 1e-8});
  REQUIRE((first.pressure.bottomRows(64) == 0).all());
  const ContactParameters more{.load = 500, .tolerance = 1e-8};
  ContactParameters warm = more;
  warm.start = first.pressure;
  const Contact near = solve_contact(grid, gap, modulus, warm), all = press_whole(grid, gap, more);
  REQUIRE((all.pressure.bottomRows(64) > 0).any());
  CHECK((near.pressure - all.pressure).abs().maxCoeff() <= 1e-6 * all.max_pressure);
  CHECK(near.area == all.area);
}

// The nested start included. 22 convolutions are what the iteration takes on the whole grid.
TEST_CASE("two smooth spheres take no more than 12 convolutions to 1e-8, whatever the grid",
          "[window][law]") {
  for (Index n : {64, 128, 256}) {
    const Grid grid = square(n);
    const Contact contact = press(grid, undeformed_gap(grid, spheres));
    CAPTURE(n);
    CHECK(contact.residual <= 1e-8);
    CHECK(contact.convolutions <= 12);
    CHECK(contact.preconditionings < contact.convolutions);
  }
}

namespace {

// Two spheres with spikes of 13 µm, of a cell each and out of reach of the window about their middle.
Field spiked_gap(const Grid& grid, const std::vector<std::pair<Index, Index>>& spikes) {
  Field gap = undeformed_gap(grid, spheres);
  for (const auto& [i, j] : spikes) gap(i, j) -= 13e-6;
  return gap;
}

}  // namespace

// The window in the middle stops at round-off there; that was taken for the whole, with ε = 0.33 and 739 in
// place of 6988 MPa. ε of 1e-12 leaves pressures 1e-10 or so, ε of 1e-17 is below what round-off allows.
TEST_CASE("a window that stops at round-off is left for a spike outside it", "[window][law]") {
  const Grid grid = square(256);
  for (const auto& spikes : std::vector<std::vector<std::pair<Index, Index>>>{
           {{128, 200}}, {{128, 200}, {20, 128}, {240, 30}, {70, 70}}})
    for (double cap : {infinity, 4e9}) {
      const Field gap = spiked_gap(grid, spikes);
      ContactParameters parameters{.load = 100, .limit_pressure = cap, .tolerance = 1e-12};
      const Contact loose = solve_contact(grid, gap, modulus, parameters);
      parameters.tolerance = 1e-17;
      const Contact tight = solve_contact(grid, gap, modulus, parameters);
      CAPTURE(spikes.size(), cap, tight.reason, tight.convolutions);
      CHECK(loose.converged);
      CHECK(tight.residual <= 1e-11);
      CHECK(tight.converged == (tight.residual <= parameters.tolerance));
      CHECK(tight.pressure(128, 200) > 3e9);
      CHECK((tight.pressure - loose.pressure).abs().maxCoeff() <= 1e-9 * loose.max_pressure);
      CHECK(tight.area == loose.area);
    }
}

TEST_CASE("a window that stops at round-off is left under a given approach and in a sweep too",
          "[window][law]") {
  const Grid grid = square(256);
  const Field gap = spiked_gap(grid, {{128, 200}});
  const Contact loose = solve_contact(grid, gap, modulus, {.load = 100, .tolerance = 1e-12});
  const Contact sunk = solve_contact(grid, gap, modulus, {.approach = loose.approach, .tolerance = 1e-17});
  CHECK(relative_error(sunk.load, 100) <= 1e-9);
  const auto influence = make_influence(grid, modulus);
  solve_load_sequence(grid, gap, *influence, {.tolerance = 1e-17}, std::array{1.0, 10.0, 100.0},
                      [&](const Contact& c) {
                        CAPTURE(c.load, c.reason);
                        CHECK(c.residual <= 1e-11);
                        CHECK((c.load < 100 || relative_error(c.max_pressure, loose.max_pressure) <= 1e-9));
                      });
}

// Conjugate gradients that went on at round-off added up directions of noise: they ended anywhere, ε of 1e-3
// and more, by hundreds of convolutions.
TEST_CASE("rough spheres end at round-off, and not far from it, whatever is asked for", "[contact][law]") {
  const Grid grid = square(96);
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (double q : {30.0, 1000.0}) {
      const Contact contact =
          solve_contact(grid, rough_gap(grid, seed), modulus, {.load = q, .tolerance = 1e-17});
      CAPTURE(seed, q, contact.reason, contact.convolutions);
      CHECK(contact.residual <= 1e-11);
      CHECK(contact.convolutions <= 300);
    }
}

TEST_CASE("a periodic surface with spikes stops at round-off in the right answer too", "[window][law]") {
  const Grid grid = periodic(square(64));
  Field gap = Field::Zero(64, 64);
  gap(5, 60) = -13e-6, gap(40, 20) = -12e-6;
  ContactParameters parameters{.load = 10, .tolerance = 1e-12};
  const Contact loose = solve_contact(grid, gap, modulus, parameters);
  parameters.tolerance = 1e-17;
  const Contact tight = solve_contact(grid, gap, modulus, parameters);
  CAPTURE(tight.reason);
  CHECK(tight.residual <= 1e-11);
  CHECK(tight.converged == (tight.residual <= parameters.tolerance));
  CHECK((tight.pressure - loose.pressure).abs().maxCoeff() <= 1e-9 * loose.max_pressure);
}

// The limit divided by the window's share was cast to an int that it overflowed: "reached after 1.3".
TEST_CASE("as many convolutions may be allowed as an int holds", "[window][contract]") {
  const Grid grid = square(128);
  const Contact contact = solve_contact(grid, undeformed_gap(grid, spheres), modulus,
                                        {.load = 1, .max_convolutions = std::numeric_limits<int>::max()});
  CHECK(contact.converged);
}
