// Several ranks measure what one does.
#include "reference/ranks.hpp"

#include <stdexcept>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/measure.hpp"
#include "stats/measure/acf_estimate.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

using Numbers = std::vector<double>;

Field own_rows(const Field& whole, const Ranks& ranks) {
  const Extent own = Slabs(whole.rows(), ranks).own();
  return whole.middleRows(own.first, own.count);
}

// What the first of so many ranks finds; NaN where it is not a number.
template <class Find>
Numbers found_by(int count, const Find& find) {
  Numbers out;
  ThreadRanks(count).run([&](const Ranks& ranks) {
    const Numbers found = find(ranks);
    if (ranks.rank() == 0) out = found;
  });
  for (double& x : out)
    if (std::isnan(x)) x = -12345;
  return out;
}

// By one rank and by several.
template <class Find>
void check_alike(const Find& find) {
  const Numbers one = found_by(1, [&](const Ranks& ranks) { return find(ranks, 1); });
  CHECK(!one.empty());
  for (const auto& [count, threads] : {std::pair{2, 1}, std::pair{3, 2}, std::pair{4, 1}}) {
    CAPTURE(count, threads);
    CHECK(found_by(count, [&](const Ranks& ranks) { return find(ranks, threads); }) == one);
  }
}

Numbers values(const LagField& f) {
  const Field all = f.within(f.max_lag()).half_plane();
  return {all.data(), all.data() + all.size()};
}

Numbers values(const Parameters& parameters) {
  Numbers out;
  for (const Parameter& p : parameters) {
    out.insert(out.end(), {p.value, p.standard_error});
    if (p.interval) out.insert(out.end(), {p.interval->low, p.interval->high});
  }
  return out;
}

struct Case {
  Grid grid;
  Field heights;
};

std::vector<Case> cases() {
  std::vector<Case> out;
  for (const Grid& g : {grid(256, 80), grid(201, 67), Grid{{200, 96}, 2, 1.5, true}})
    out.push_back({g, 3 + moving_average(g.shape, {4, 3}, 7)});
  return out;
}

Surface surface_of(const Case& of, const Ranks& ranks) {
  Surface out{.grid = of.grid, .heights = own_rows(of.heights, ranks)};
  out.ranks = &ranks;
  return prepared(std::move(out), {});
}

}  // namespace

TEST_CASE("several ranks find the autocorrelation of one, to the last bit", "[ranks][acf][law]") {
  for (const Case& c : cases())
    for (const Shape max_lag : {default_max_lag(c.grid), Shape{9, 7}})
      for (const bool biased : {false, true}) {
        CAPTURE(text(c.grid.shape), text(max_lag), biased);
        check_alike([&](const Ranks& ranks, int threads) {
          const AcfParameters parameters{
              .max_lag = max_lag, .biased = biased, .threads = threads, .ranks = &ranks};
          const LagField R = estimate_autocorrelation(own_rows(c.heights, ranks), c.grid, parameters);
          const Index rows = Slabs(max_lag.nx + 1, ranks).own().count;
          CHECK(R.half_plane().rows() == rows);  // of memory: its share
          return values(R);
        });
      }
}

TEST_CASE("several ranks find the spectrum of one, to the last bit", "[ranks][psd][law]") {
  for (const Case& c : cases())
    for (const DataWindow window : {DataWindow::none, DataWindow::hann}) {
      CAPTURE(text(c.grid.shape), window == DataWindow::hann);
      check_alike([&](const Ranks& ranks, int threads) {
        return values(power_spectrum(own_rows(c.heights, ranks), c.grid, {window, window}, threads, ranks));
      });
    }
}

TEST_CASE("several ranks find the correlation lengths of one, their errors and its profiles, to the last bit",
          "[ranks][acf][law]") {
  for (const Case& c : cases()) {
    CAPTURE(text(c.grid.shape));
    check_alike([&](const Ranks& ranks, int threads) {
      const Surface surface = surface_of(c, ranks);
      const AcfEstimate estimate =
          AcfEstimate::of(surface, {.max_lag = default_max_lag(c.grid), .threads = threads});
      const std::optional<LengthErrors> errors(std::in_place, estimate, surface.heights, 0.1, threads);
      Numbers out =
          values(acf_lengths(estimate, {{0.5, "50", "50 %"}, {0.1, "10", "10 %"}}, 0.4, {}, errors));
      for (const bool along_x : {true, false}) {
        const ProfileErrors p = profile_errors(estimate, surface.heights, along_x, false, threads);
        out.insert(out.end(), p.acf.begin(), p.acf.end());
      }
      return out;
    });
  }
}

// Of the first 64 lags alone, where lengths are looked for first, the lobe is open and nothing falls to 10 %.
TEST_CASE("lengths beyond the first 64 lags are found as among all lags", "[acf][exact]") {
  const Grid g = grid(400, 60);
  const Surface surface = surface_of({g, moving_average(g.shape, {90, 3}, 7)}, alone());
  const AcfEstimate estimate = AcfEstimate::of(surface, {.max_lag = default_max_lag(g)});
  const Parameters lengths = acf_lengths(estimate, {{0.1, "10", "10 %"}}, {}, {}, {});
  const auto crossing = first_crossing(estimate.rho, g, 0, 0.1);
  REQUIRE(crossing);
  CHECK(crossing->lag > 64);
  CHECK(std::ranges::find(lengths, "length_10_x", &Parameter::name)->value == crossing->lag);
  CHECK(std::ranges::find(lengths, "ellipticity_10", &Parameter::name)->value ==
        central_lobe(estimate.rho, g, 0.1).ellipse->gamma());
}

TEST_CASE("several ranks find the height parameters of one with their errors, to the last bit",
          "[ranks][moments][law]") {
  for (const Case& c : cases()) {
    CAPTURE(text(c.grid.shape));
    Case skewed = c;
    skewed.heights = c.heights.exp() / 50;  // whose errors depend on an evident distribution too
    for (const Case& one : {c, skewed})
      check_alike([&](const Ranks& ranks, int threads) {
        const Sample sample(surface_of(one, ranks), false, threads);
        return values(measure(sample, Group::height, {}));
      });
  }
}

TEST_CASE("a lag that another rank has is an error, not a zero", "[ranks][acf][contract]") {
  bool thrown = false;
  ThreadRanks(2).run([&](const Ranks& ranks) {
    const Slabs rows(100, ranks);
    const LagField f(Field::Ones(rows.own().count, 5), rows);
    if (ranks.rank() > 0) return;
    CHECK(f(63, 2) == 1);
    CHECK(f(100, 0) == 0);
    CHECK(f(3, 3) == 0);
    try {
      static_cast<void>(f(64, 0));
    } catch (const std::logic_error&) {
      thrown = true;
    }
  });
  CHECK(thrown);
}

// The lags in the order of their certainty, from all of them: what two passes find in less memory.
TEST_CASE("the lags that exceed noise are those that come before the first within three errors",
          "[effective-size][exact]") {
  for (const Case& c : cases()) {
    const LagField rho =
        estimate_autocorrelation(c.heights, c.grid, {.max_lag = default_max_lag(c.grid)}).normalised();
    const Pairs pairs(c.grid);
    std::vector<std::pair<double, WeightedLag>> all;
    for_each_lag(rho, pairs, [&](Index p, Index q, double weight) {
      const double z =
          p == 0 && q == 0 ? INFINITY : std::abs(rho(p, q)) * std::sqrt(pairs.pair_fraction(p, q));
      all.push_back({z, {p, q, rho(p, q), weight}});
    });
    std::ranges::sort(all, std::greater(), [](const auto& lag) { return lag.first; });
    double sum = 0;
    std::size_t admitted = 0;
    for (const auto& [z, lag] : all) {
      if (z <= 3 * std::sqrt(sum / pairs.points())) break;
      sum += lag.weight * lag.rho * lag.rho;
      ++admitted;
    }
    CAPTURE(text(c.grid.shape));
    CHECK(admitted > 12);
    CHECK(significant(rho, pairs).size() == admitted);
  }
}
