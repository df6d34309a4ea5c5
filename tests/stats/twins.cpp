// Errors from twins of a field.
#include <nlohmann/json.hpp>

#include "fields.hpp"
#include "holes.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/twins/twin_errors.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const Parameter& parameter_of(const Parameters& parameters, const std::string& name) {
  const auto found = std::ranges::find(parameters, name, &Parameter::name);
  REQUIRE(found != parameters.end());
  return *found;
}

LagField exponential_twin(double length, Index reach) {
  return LagField::of({reach, reach}, [&](Index p, Index q) {
    return std::exp(-std::hypot(static_cast<double>(p), static_cast<double>(q)) / length);
  });
}

Sample twin_sample(Field z, std::optional<LagField> rho = {}, int degree = 0) {
  const Grid grid{shape_of(z), 1e-6, 1e-6, false};
  return Sample(prepared({.grid = grid, .heights = 1e-6 * z, .correlation = std::move(rho)},
                         {.form = {.degree = degree}}));
}

Parameters with_twins(const Sample& sample, const MeasureOptions& asked, const TwinOptions& options) {
  Parameters out;
  for (const Group group : asked.groups)
    for (const Parameter& p : measure(sample, group, asked)) out.push_back(p);
  TwinErrors(sample, asked, options).apply(out, [](const Parameter&) { return true; });
  return out;
}

}  // namespace

// The mean over K twins of z(i,j) z(i+p,j+q) errs by √((1+ρ²) S_2/(N K)) at most: of 64 twins of N = 48 × 40 with
// S_2 = 2π (l/2)² = 14, 1.5 %. Five of these, for the twelve lags. The torus' clamped powers change ρ by less.
TEST_CASE("twins have the known correlation, unit variance and the missing points of the field",
          "[twins][statistics]") {
  const Shape shape{48, 40};
  const LagField rho = exponential_twin(3, 40);
  for (const bool holes : {false, true}) {
    Field z = random_field(shape, 3);
    if (holes) z = with_holes(z, 0.2, 4);
    const TwinFields twins(twin_sample(z, rho));
    for (const Index p : {0, 1, 3})
      for (const Index q : {-4, 0, 2, 5}) {
        double sum = 0, pairs = 0;
        for (Index k = 0; k < 64; ++k)
          for_each_pair(twins.heights(k), false, p, q, [&](double a, double b) { sum += a * b, ++pairs; });
        CAPTURE(holes, p, q);
        CHECK(std::abs(sum / pairs - rho(p, q)) <= 5 * std::sqrt(2 * 14 / pairs));
      }
    CHECK((twins.heights(1).isNaN() == z.isNaN()).all());
    CHECK(bool((twins.heights(5) == twins.heights(5) || z.isNaN()).all()));
    CHECK(bool((twins.heights(5) != twins.heights(6) || z.isNaN()).all()));
  }
}

// Independent heights: Sq has the error Sq/√(2N), the mean Sq/√N. 200 twins know a standard deviation to 1/√398.
// A form of degree 2 takes 6 of N degrees of freedom, and Sq is low by √(1 - 6/N).
TEST_CASE("twins of white noise have the errors of independent heights, and the bias of a form",
          "[twins][statistics]") {
  const LagField white = LagField::of({1, 1}, [](Index p, Index q) { return p == 0 && q == 0 ? 1 : 0; });
  const Shape shape{12, 10};
  const double n = 120;
  for (const int degree : {0, 2}) {
    const Sample sample = twin_sample(white_noise(shape, 7), white, degree);
    const MeasureOptions asked{.groups = {Group::height}, .preparation = {.form = {.degree = degree}}};
    const Parameters parameters = with_twins(sample, asked, {.twins = 200});
    const double free = degree == 0 ? n - 1 : n - 6, known = 4 / std::sqrt(398.0);
    CAPTURE(degree);
    const Parameter& sq = parameter_of(parameters, "Sq");
    CHECK(sq.standard_error == Approx(sq.value / std::sqrt(2 * free)).epsilon(known));
    // The scale is that of 20 twins, known to 1/√(2 · 20 n); the interval is even in the logarithm.
    const double centre = std::sqrt(sq.interval->low * sq.interval->high) / sq.value;
    CHECK(std::abs(centre - std::sqrt(n / free)) <= 4 / std::sqrt(40 * n));
    CHECK(parameter_of(parameters, "Sz").standard_error > 0);
    CHECK(parameter_of(parameters, "Sp").source == "200 twins");
    CHECK(std::isnan(parameter_of(parameters, "N").standard_error));
    if (degree == 0)
      CHECK(parameter_of(parameters, "mean").standard_error ==
            Approx(sq.value / std::sqrt(n)).epsilon(known));
  }
}

TEST_CASE("errors from twins are the same on any number of threads, and hold for every group",
          "[twins][contract]") {
  const Sample sample = twin_sample(moving_average({40, 50}, {4, 4}, 5));
  MeasureOptions asked{
      .groups = {Group::height, Group::material, Group::hybrid, Group::spatial, Group::profiles}};
  const Parameters one = with_twins(sample, asked, {.twins = 12, .threads = 1}),
                   three = with_twins(sample, asked, {.twins = 12, .threads = 3});
  REQUIRE(one.size() == three.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    CAPTURE(one[k].name);
    const bool same = one[k].standard_error == three[k].standard_error ||
                      (std::isnan(one[k].standard_error) && std::isnan(three[k].standard_error));
    CHECK(same);
    const bool exact = one[k].name.starts_with("N") || one[k].name.starts_with("profiles");
    CHECK(one[k].source.empty() == (exact || !one[k].why.empty()));
  }
  CHECK(parameter_of(one, "Str").interval_95().high <= 1);
}

// White noise has no direction, and few summits on 6 x 6 points: none in some twins.
TEST_CASE("intervals from twins keep to what the parameter can be", "[twins][contract]") {
  const LagField white = LagField::of({1, 1}, [](Index p, Index q) { return p == 0 && q == 0 ? 1 : 0; });
  const MeasureOptions asked{.groups = {Group::material, Group::hybrid, Group::spatial}};
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Parameters all = with_twins(twin_sample(white_noise({6, 6}, seed), white), asked, {.twins = 40});
    for (const char* name : {"Smr1", "Smr2", "Str"}) {
      const auto found = std::ranges::find(all, name, &Parameter::name);
      if (found == all.end() || !found->interval_95().known()) continue;
      CAPTURE(seed, name);
      CHECK(found->interval_95().high <= 1);
    }
    const Parameter& density = parameter_of(all, "summit_density");
    if (density.interval_95().known()) CHECK(density.interval_95().low >= 0);
    const Parameter& lay = parameter_of(all, "Sal_direction");
    CHECK(std::isnan(lay.standard_error));
    CHECK(lay.why == "no direction is preferred");
  }
}

TEST_CASE("twins are needed where there is no error and it is not said why", "[twins][contract]") {
  const Field plain = moving_average({96, 96}, {5, 5}, 11), skewed = (2 * plain / plain.maxCoeff()).exp();
  const Parameter sq{.name = "Sq", .value = 1, .unit = "m", .standard_error = 0.1, .meaning = ""};
  for (const int degree : {0, 2}) CHECK(TwinScope(twin_sample(plain, {}, degree)).needs_none(sq));
  const Parameter sz{.name = "Sz", .value = 1, .unit = "m", .standard_error = NAN, .meaning = ""};
  CHECK(TwinScope(twin_sample(plain)).holds(sz));
  CHECK(!TwinScope(twin_sample(plain)).needs_none(sz));
  const Parameter none{.name = "slowest_direction",
                       .value = 1,
                       .unit = "rad",
                       .standard_error = NAN,
                       .meaning = "",
                       .why = "no direction is preferred"};
  CHECK(TwinScope(twin_sample(plain)).needs_none(none));
  const Parameter count{
      .name = "profiles_eff", .value = 9, .unit = "1", .standard_error = NAN, .meaning = ""};
  CHECK(!TwinScope(twin_sample(plain)).holds(count));
  CHECK(!TwinScope(twin_sample(skewed)).holds(sz));
}

// ---- twins tool ----

using Json = nlohmann::json;

namespace {

void draw() {
  static const bool drawn =
      shell(
          "asperity-generate -q --add kernel --shape 64x48 --size 1mm,0.5mm --rq 0.4um --length "
          "40um,30um --seed 1 -o t.nc")
          .exit == 0;
  REQUIRE(drawn);
}

Json stats(const std::string& options) {
  return Json::parse(require("asperity-stats -q --json " + options).out);
}

}  // namespace

TEST_CASE("errors are those of theory, of twins, of whichever holds, or none",
          "[stats-tool][twins][contract]") {
  draw();
  const Json theory = stats("--errors theory t.nc"), twins = stats("--errors twins t.nc"),
             own = stats("t.nc"), none = stats("--errors none t.nc");
  for (const char* name : {"Sa", "Sq", "Ssk"}) {
    CAPTURE(name);
    CHECK(own[name] == theory[name]);
    CHECK(twins[name]["value"] == theory[name]["value"]);
    CHECK(twins[name]["note"] == "error from 60 twins");
    CHECK_FALSE(none[name].contains("standard_error"));
  }
  for (const char* name : {"Sp", "Sv", "Sz"}) {
    CAPTURE(name);
    CHECK_FALSE(theory[name].contains("standard_error"));
    CHECK(own[name] == twins[name]);
    CHECK(own[name]["interval_95"].size() == 2);
  }
  CHECK_FALSE(twins["N"].contains("standard_error"));
  CHECK(stats("--errors twins --threads 1 t.nc") == stats("--errors twins --threads 3 t.nc"));
  const std::string above = "t.nc --remove-form plane";
  CHECK(stats(above)["Sq"] == stats(above + " --errors theory")["Sq"]);
}

TEST_CASE("several surfaces have the errors of their spread, and no twins unless asked for",
          "[stats-tool][twins][contract]") {
  draw();
  require("asperity-generate -q --seed 2 < t.nc > u.nc");
  const Json plain = stats("t.nc u.nc"), asked = stats("t.nc u.nc --errors twins");
  CHECK(plain == stats("t.nc u.nc --errors theory"));
  const std::string text = asked.dump();
  CHECK(text != plain.dump());
}

TEST_CASE("what is too large for quick twins says which option has them", "[stats-tool][twins][contract]") {
  require("asperity-generate -q --shape 400x400 --size 1mm --rq 0.4um --length 20um --seed 1 -o large.nc");
  const Outcome all = shell("asperity-stats large.nc --parameters all");
  CHECK(all.exit == 0);
  CHECK_THAT(all.error, ContainsSubstring("--errors twins"));
  CHECK_FALSE(Json::parse(require("asperity-stats -q --json --parameters all large.nc").out)["Sz"].contains(
      "standard_error"));
}

// The slope from seven points does not fit into five. With the errors, the reason was left out.
TEST_CASE("asperity-stats without errors still says why a value is missing", "[stats-tool][contract]") {
  const std::string narrow = "asperity-generate --shape 5x64 --size 0.1mm,1mm --rq 0.4um --length 4px | ";
  for (const char* errors : {"none", "auto"}) {
    const std::string table = require(narrow + "asperity-stats --profile x --errors " + errors).out;
    CHECK_THAT(table, ContainsSubstring("no value: no profile has this parameter"));
  }
}
