// Hills and dales, their pruning, and what is measured of them.
#include "stats/feature/features.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/error.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/measure.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Wolf pruning as it is worded: hills by steepest ascent, of plateaus as a whole; the hill of the least local
// height merges across its highest saddle, again and again. Returns the heights of the peaks.
class Worded {
 public:
  Worded(const Field& z, const Periodic& periodic) : z_(z), periodic_(periodic) {
    find_plateaus();
    climb();
    find_saddles();
  }

  std::multiset<double> peaks(double least) {
    while (peak_.size() > 1) {
      const auto lowest =
          std::ranges::min_element(peak_, {}, [this](const auto& p) { return local_height(p.first); });
      const int hill = lowest->first;
      if (!(local_height(hill) < least) || saddles_[hill].empty()) break;
      merge(hill);
    }
    std::multiset<double> out;
    for (const auto& [hill, height] : peak_) out.insert(height);
    return out;
  }

 private:
  double local_height(int hill) {
    double saddle = -HUGE_VAL;
    for (const auto& [other, at] : saddles_[hill]) saddle = std::max(saddle, at);
    return peak_.at(hill) - saddle;
  }
  void merge(int hill) {
    const int to =
        std::ranges::max_element(saddles_[hill], {}, [](const auto& s) { return s.second; })->first;
    for (const auto& [other, at] : saddles_[hill]) {
      saddles_[other].erase(hill);
      if (other == to) continue;
      for (const auto& [a, b] : {std::pair{to, other}, {other, to}}) {
        const auto [there, fresh] = saddles_[a].try_emplace(b, at);
        there->second = std::max(there->second, at);
      }
    }
    peak_[to] = std::max(peak_[to], peak_[hill]);
    peak_.erase(hill), saddles_.erase(hill);
  }

  std::vector<Index> beside(Index k) const {
    const Index nx = z_.rows(), ny = z_.cols();
    std::vector<Index> out;
    for (Index n = 0; n < 9; ++n) {
      Index i = k / ny + n / 3 - 1, j = k % ny + n % 3 - 1;
      if (n == 4 || (!periodic_.x && (i < 0 || i >= nx)) || (!periodic_.y && (j < 0 || j >= ny))) continue;
      i = (i + nx) % nx, j = (j + ny) % ny;
      if (!std::isnan(z_(i, j))) out.push_back(i * ny + j);
    }
    return out;
  }
  double height(Index k) const { return z_.data()[k]; }

  void find_plateaus() {
    plateau_.assign(static_cast<std::size_t>(z_.size()), -1);
    for (Index k = 0; k < z_.size(); ++k) {
      if (std::isnan(height(k)) || plateau_[static_cast<std::size_t>(k)] >= 0) continue;
      std::vector<Index> open{k};
      for (plateau_[static_cast<std::size_t>(k)] = count_; !open.empty();) {
        const Index at = open.back();
        open.pop_back();
        for (const Index q : beside(at))
          if (height(q) == height(k) && plateau_[static_cast<std::size_t>(q)] < 0)
            plateau_[static_cast<std::size_t>(q)] = count_, open.push_back(q);
      }
      level_.push_back(height(k)), ++count_;
    }
    near_.resize(level_.size());
    for (Index k = 0; k < z_.size(); ++k)
      if (const int own = plateau_[static_cast<std::size_t>(k)]; own >= 0)
        for (const Index q : beside(k))
          if (const int other = plateau_[static_cast<std::size_t>(q)]; other != own)
            near_[static_cast<std::size_t>(own)].insert(other);
  }
  void climb() {
    for (int a = 0; a < count_; ++a) {
      int at = a;
      for (bool up = true; up;) {
        const auto& all = near_[static_cast<std::size_t>(at)];
        const auto highest =
            std::ranges::max_element(all, {}, [this](int b) { return level_[static_cast<std::size_t>(b)]; });
        up = highest != all.end() &&
             level_[static_cast<std::size_t>(*highest)] > level_[static_cast<std::size_t>(at)];
        if (up) at = *highest;
      }
      hill_.push_back(at);
      peak_[at] = level_[static_cast<std::size_t>(at)], saddles_[at];
    }
  }
  void find_saddles() {
    for (std::size_t a = 0; a < near_.size(); ++a)
      for (const int b : near_[a])
        if (const int one = hill_[a], other = hill_[static_cast<std::size_t>(b)]; one != other) {
          const double at = std::min(level_[a], level_[static_cast<std::size_t>(b)]);
          const auto [there, fresh] = saddles_[one].try_emplace(other, at);
          there->second = std::max(there->second, at);
        }
  }

  const Field& z_;
  Periodic periodic_;
  int count_ = 0;
  std::vector<int> plateau_ = {}, hill_ = {};
  std::vector<double> level_ = {};
  std::vector<std::set<int>> near_ = {};
  std::map<int, double> peak_ = {};
  std::map<int, std::map<int, double>> saddles_ = {};
};

std::multiset<double> peaks_of(const Hills& hills) {
  std::multiset<double> out;
  for (const Hill& h : hills.all) out.insert(h.height);
  return out;
}

Grid grid_of(const Field& z, double spacing, Periodic periodic = {}) {
  return {shape_of(z), spacing, spacing, periodic};
}

double value_of(const Parameters& all, const std::string& name) {
  return std::ranges::find(all, name, &Parameter::name)->value;
}

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("pruning leaves the hills of local heights that are no lower, as merging one by one does",
          "[feature][exact]") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Field z = random_field({12, 9}, seed);
    if (seed % 3 == 0) z = (2 * z).round() / 2;  // with ties
    if (seed % 4 == 0) z.block(3, 2, 2, 3).setConstant(NAN);
    const Periodic periodic{seed % 2 == 0, seed % 5 == 0};
    for (const double least : {0.0, 0.2, 0.6, 1.2}) {
      CAPTURE(seed, least);
      CHECK(peaks_of(pruned(hills_of(z, periodic), least)) == Worded(z, periodic).peaks(least));
    }
  }
}

TEST_CASE("peaks within a field are the counted summits, plateaus too", "[feature][exact]") {
  for (const double step : {0.0, 0.25}) {
    Field z = random_field({40, 50}, 5);
    if (step > 0) z = (z / step).round() * step;
    for (const bool wraps : {false, true}) {
      const Grid grid = grid_of(z, 1, {wraps, wraps});
      double inside = 0;
      const Features features(z, grid, {0});
      for (const Feature& f : features.hills().all) inside += std::isfinite(f.curvature);
      CHECK(inside == counted_summits(z, grid).count);
      CHECK(features.hills().figures(1).curvature == Approx(counted_summits(z, grid).mean_curvature));
    }
  }
}

// Of z = a cos(2πx/L) cos(2πy/L): two peaks per L², of curvature a (2π/L)². Above 0 a hill is a square of side
// L/2, of volume a (L/π)², which the midpoint rule has to (π Δ/L)²/3 · 2 = 1.3 % at L = 16 Δ; its points are
// the 64 inside, or 49 and of those on its sides what round-off lifts above 0.
TEST_CASE("an egg box has its closed form", "[feature][law]") {
  const Index n = 128, period = 16;
  const double a = 1e-6, spacing = 1e-6, length = static_cast<double>(period) * spacing;
  for (const double phase : {0.5, 0.0}) {
    const Field z = Field::NullaryExpr(n, n, [&](Index i, Index j) {
      const auto at = [&](Index k) {
        return std::cos(2 * pi * (static_cast<double>(k) + phase) / static_cast<double>(period));
      };
      return a * at(i) * at(j);
    });
    CAPTURE(phase);
    const Features features(z, grid_of(z, spacing, {true, true}), {});
    const double area = features.area();
    for (const Features::Kind* kind : {&features.hills(), &features.dales()}) {
      CHECK(kind->all.size() == 128);
      CHECK(kind->closed() == 128);
      const FeatureFigures of = kind->figures(area);
      CHECK(of.density == Approx(2 / (length * length)));
      const double steps =
          2 - 2 * std::cos(2 * pi / static_cast<double>(period));  // second difference of cos
      if (phase == 0) CHECK(of.curvature == Approx(a * steps / (spacing * spacing)).epsilon(1e-9));
      CHECK(of.area >= 49 * (1 - 1e-9) * spacing * spacing);
      CHECK(of.area <= (phase > 0 ? 64 : 81) * (1 + 1e-9) * spacing * spacing);
      CHECK(of.volume == Approx(a * length * length / (pi * pi)).epsilon(phase > 0 ? 0.014 : 0.028));
      CHECK(kind->five() == Approx(z.maxCoeff()));
    }
    // Cut open, hills at the edges are not closed, but counted.
    const Features open(z, grid_of(z, spacing), {});
    CHECK(open.hills().all.size() >= 128);
    CHECK(open.hills().closed() < 128);
  }
}

// Cylinders of height h on a plane; a dip in the top of one and a hill beside another are pruned.
TEST_CASE("pillars and nested hills are single features with their area and volume", "[feature][exact]") {
  Field z = Field::Zero(60, 60);
  for (const Index i : {10, 30, 50})
    for (const Index j : {10, 30, 50}) z.block(i - 3, j - 3, 7, 7).setConstant(2e-6);
  z(30, 30) = 1.97e-6;  // a dale of 0.03 µm in a pillar: below 5 % of 2.05 µm
  z(10, 20) = 0.05e-6;  // and a hill as low
  z(50, 50) = 2.05e-6;
  const Features features(z, grid_of(z, 1e-6), {});
  CHECK(features.hills().all.size() == 9);
  CHECK(features.hills().unpruned == 10);
  const FeatureFigures hills = features.hills().figures(features.area());
  CHECK(hills.density == Approx(9 / (58e-6 * 58e-6)));
  CHECK(hills.area == Approx((9 * 49 + 1) * 1e-12 / 9));  // a hill that was merged belongs to its neighbour
  CHECK(hills.volume == Approx((9 * 49 * 2 - 0.03 + 0.05 + 0.05) * 1e-18 / 9));
  CHECK(features.dales().all.size() == 1);
  CHECK(features.hills().five() + z.mean() == Approx((4 * 2e-6 + 2.05e-6) / 5));
}

TEST_CASE("a surface turned over has dales for hills", "[feature][exact]") {
  const Field z = 1e-6 * random_field({50, 40}, 9);
  MeasureOptions asked{.groups = {Group::feature}};
  CHECK(std::isnan(measure({.grid = grid_of(z, 1e-6), .heights = z}, asked)[0].standard_error));
  asked.pruning = {0.1e-6, false};
  const Parameters up = measure({.grid = grid_of(z, 1e-6), .heights = z}, asked),
                   down = measure({.grid = grid_of(z, 1e-6), .heights = -z}, asked);
  for (const auto& [a, b] :
       {std::pair{"Spd", "Svd"}, {"Spc", "Svc"}, {"S5p", "S5v"}, {"Sha", "Sda"}, {"Shv", "Sdv"}}) {
    CAPTURE(a);
    CHECK(value_of(up, a) == Approx(value_of(down, b)).epsilon(1e-12));
    const double error = std::ranges::find(up, a, &Parameter::name)->standard_error;
    if (std::string(a) != "S5p")
      CHECK(error == Approx(std::ranges::find(down, b, &Parameter::name)->standard_error).epsilon(1e-9));
  }
  CHECK(value_of(up, "S10z") == Approx(value_of(up, "S5p") + value_of(up, "S5v")));
}

TEST_CASE("a field without hills has no features, and says why", "[feature][contract]") {
  CHECK(hills_of(Field::Constant(5, 6, 3.0), {}).all.empty());
  CHECK_THROWS_WITH(Features(Field::Constant(5, 6, 3.0), grid_of(Field(5, 6), 1), {}),
                    ContainsSubstring("all are the same"));
  CHECK_THROWS_WITH(Features(random_field({9, 2}, 1), grid_of(Field(9, 2), 1), {}),
                    ContainsSubstring("3 x 3 points, found 9x2"));
  const Field z = random_field({20, 20}, 2);
  MeasureOptions options{.groups = {Group::feature}};
  options.pruning = {1};
  CHECK_THROWS_AS(measure({.grid = grid_of(z, 1e-6), .heights = z}, options), ParameterError);
  options.pruning = {-1e-9, false};
  CHECK_THROWS_AS(measure({.grid = grid_of(z, 1e-6), .heights = z}, options), ParameterError);
  options.pruning = {};
  const Parameters volts = measure({.grid = grid_of(z, 1e-6), .heights = z, .units = "V"}, options);
  CHECK(volts[0].why == "features need heights in m, not in V");
  options.pruning = {0.9 * (z.maxCoeff() - z.minCoeff()), false};
  const Parameters few = measure({.grid = grid_of(z, 1e-6), .heights = z}, options);
  CHECK(value_of(few, "Spd") <= 1 / (18e-6 * 18e-6) * (1 + 1e-9));
  CHECK_THAT(few[0].why, ContainsSubstring(", and an error needs 10"));
}

// Peaks of steps are plateaus: fewer, and of other curvatures, than those of the surface.
TEST_CASE("peaks of heights in steps have no error, and say why", "[feature][contract]") {
  const Field z = 1e-6 * (2 * random_field({64, 64}, 3)).round() / 2;
  MeasureOptions asked{.groups = {Group::feature}};
  asked.pruning = {0.1e-6, false};
  const Parameters all = measure({.grid = grid_of(z, 1e-6), .heights = z}, asked);
  for (const char* name : {"Spd", "Svd", "Spc", "Svc"}) {
    const Parameter& p = *std::ranges::find(all, name, &Parameter::name);
    CHECK(std::isnan(p.standard_error));
    CHECK_THAT(p.why, ContainsSubstring("are plateaus of equal heights"));
  }
}
