// Profile parameters of waves in closed form, and of random fields against the spread over an ensemble.
#include "stats/profile/profile.hpp"

#include "core/error.hpp"
#include "fields.hpp"
#include "named.hpp"
#include "stats/measure.hpp"
#include "stats/measure/groups.hpp"
#include "stats/sample/quantiles.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr double whole = std::numeric_limits<double>::infinity();

Eigen::ArrayXd profile_wave(int points, int periods, double amplitude, double phase = 0.5) {
  return Eigen::ArrayXd::NullaryExpr(points * periods, [=](Index i) {
    return amplitude * std::sin(2 * std::numbers::pi * (static_cast<double>(i) + phase) / points);
  });
}

}  // namespace

// The midpoint sum of sin over half a period of M points is 1/(M sin(π/2M)) = (2/π)(1 + (π/2M)²/6 + …); with
// 2·odd points a period the crests fall on points. Between upward crossings a period stays a period, to
// round-off.
TEST_CASE(
    "a sine of amplitude A has Ra = 2A/pi, Rq = A/sqrt(2), Rz = Rt = 2A, Rsk = 0, Rku = 3/2 and RSm its "
    "wavelength",
    "[profile][exact]") {
  const double A = 3e-6, step = 0.5e-6;
  for (int points : {10, 30, 90}) {
    const ProfileParameters p = profile_parameters(profile_wave(points, 6, A), step, whole, false);
    CAPTURE(points);
    CHECK(relative_error(p[profile_a], 2 * A / points / std::sin(std::numbers::pi / points)) <= 1e-13);
    CHECK(relative_error(p[profile_q], A / std::numbers::sqrt2) <= 1e-14);
    CHECK(std::abs(p[profile_sk]) <= 1e-13);
    CHECK(relative_error(p[profile_ku], 1.5) <= 1e-13);
    CHECK(relative_error(p[profile_p], A) <= 1e-13);
    CHECK(relative_error(p[profile_v], A) <= 1e-13);
    CHECK(relative_error(p[profile_z], 2 * A) <= 1e-13);
    CHECK(relative_error(p[profile_t], 2 * A) <= 1e-13);
    CHECK(relative_error(p[profile_sm], points * step) <= 1e-13);
    CHECK(relative_error(p[profile_c], 2 * A) <= 1e-13);
    for (const ProfileParameter five : {profile_5p, profile_5v}) CHECK(relative_error(p[five], A) <= 1e-13);
    CHECK(relative_error(p[profile_10z], 2 * A) <= 1e-13);
  }
  const double few = profile_parameters(profile_wave(32, 1, 1), 1, whole, false)[profile_a] *
                         std::numbers::pi / 2 -
                     1,
               many = profile_parameters(profile_wave(64, 1, 1), 1, whole, false)[profile_a] *
                          std::numbers::pi / 2 -
                      1;
  CHECK(observed_order(few, many) == Approx(2).margin(0.01));
}

TEST_CASE("Rdq of a sine is its slope times (45 sin u - 9 sin 2u + sin 3u)/(30u), 1 - u^6/140 of it",
          "[profile][exact]") {
  for (int points : {8, 16, 31}) {
    const double u = 2 * std::numbers::pi / points, step = 0.25;
    const double factor = (45 * std::sin(u) - 9 * std::sin(2 * u) + std::sin(3 * u)) / (30 * u);
    const double slope = 2 * u / step / std::numbers::sqrt2;
    CHECK(relative_error(profile_parameters(profile_wave(points, 3, 2), step, whole, true)[profile_dq],
                         slope * factor) <= 1e-13);
    CHECK(std::abs((1 - factor) * 140 / std::pow(u, 6) - 1) <= u * u / 3);
  }
  const Eigen::ArrayXd ramp = 0.3 * Eigen::ArrayXd::LinSpaced(20, 0, 19);
  CHECK(relative_error(profile_parameters(ramp, 2, whole, false)[profile_dq], 0.15) <= 1e-13);
}

// Sections of 20 points of which the k-th has the peak k and the valley -2k: means over five of them; the
// remainder of 7 points, with a peak of 100, belongs to none, but to Rt. The balance keeps the mean at zero.
TEST_CASE("Rp, Rv and Rz are means over whole sections, Rt is that of the whole profile",
          "[profile][exact]") {
  Eigen::ArrayXd z = Eigen::ArrayXd::Zero(107);
  for (Index k = 0; k < 5; ++k) {
    z(20 * k + 3) = static_cast<double>(k + 1);
    z(20 * k + 11) = -2.0 * static_cast<double>(k + 1);
  }
  z(104) = 100;
  const double mean = z.mean();
  const ProfileParameters p = profile_parameters(z, 0.1, 2.0, false);
  CHECK(p[profile_p] == Approx(3 - mean).epsilon(1e-13));
  CHECK(p[profile_v] == Approx(6 + mean).epsilon(1e-13));
  CHECK(p[profile_z] == Approx(9).epsilon(1e-13));
  CHECK(p[profile_t] == Approx(110).epsilon(1e-13));
  CHECK(profile_parameters(z, 0.1, whole, false)[profile_z] == Approx(110).epsilon(1e-13));
}

// A ripple of a fiftieth of the amplitude crosses the mean line many times, but makes no hill.
TEST_CASE("RSm does not count what stays within a tenth of Rz of the mean line", "[profile][law]") {
  const Eigen::ArrayXd smooth = profile_wave(200, 8, 1),
                       rippled = smooth + profile_wave(8, 200, 0.02).head(1600);
  CHECK(relative_error(profile_parameters(rippled, 1, whole, false)[profile_sm], 200) <= 1e-3);
  const Eigen::ArrayXd mixed = profile_wave(200, 8, 1) + profile_wave(40, 40, 1.4);
  const double there = profile_parameters(mixed, 1, whole, false)[profile_sm],
               back = profile_parameters(mixed.reverse(), 1, whole, false)[profile_sm];
  CHECK(there <= 60);
  CHECK(relative_error(back, there) <= 1e-13);
}

// Hills k and dales k of k = 1 … 7, the last of them at the end. Above 10 % of 14 are those from 2 on. Between
// the crossings behind hill 2 and behind hill 7 dale 2 and hill 3 are an element of the height 5, hill 3 and
// dale 3 one of 6, …, dale 6 and hill 7 one of 13: 9 in the mean.
TEST_CASE("Rc is the mean height of elements, R5p and R5v are those of the five highest and deepest",
          "[profile][exact]") {
  Eigen::ArrayXd z = Eigen::ArrayXd::Zero(28);
  for (Index k = 1; k <= 7; ++k)
    z(4 * k - 3) = static_cast<double>(k), z(4 * k - 1) = -static_cast<double>(k);
  const ProfileParameters p = profile_parameters(z, 1, whole, false);
  CHECK(relative_error(p[profile_c], 9) <= 1e-14);
  CHECK(relative_error(profile_parameters(z.reverse(), 1, whole, false)[profile_c], 9) <= 1e-14);
  CHECK(relative_error(p[profile_5p], 5) <= 1e-14);
  CHECK(relative_error(p[profile_5v], (6 + 5 + 4 + 3 + 2) / 5.0) <= 1e-14);  // -7 is at the end
  CHECK(relative_error(p[profile_10z], 9) <= 1e-14);
  CHECK(relative_error(profile_parameters(z, 1, whole, true)[profile_5v], 5) <= 1e-14);
}

// A ripple of 4 % of Rz makes no peaks; a plateau is one, unless it reaches an end or a missing point. Six
// crests of which one is at an end or is cut are five, five of which one is are too few.
TEST_CASE("R5p counts neither ripples nor what is highest at an end, whichever that is, or beside a gap",
          "[profile][law]") {
  const Eigen::ArrayXd wave = profile_wave(20, 6, 1), fewer = profile_wave(20, 5, 1);
  auto five = [](const Eigen::ArrayXd& z) { return profile_parameters(z, 1, whole, false)[profile_5p]; };
  const Eigen::ArrayXd rippled = wave + profile_wave(2, 60, 0.04);
  CHECK(five(rippled) <= 1.04 * (1 + 1e-13));
  CHECK(five(rippled) >= 0.96);
  CHECK(five(wave.min(0.5)) == Approx(0.5 - wave.min(0.5).mean()).epsilon(1e-13));
  for (const bool back : {false, true}) {
    auto turned = [back](const Eigen::ArrayXd& z) -> Eigen::ArrayXd { return back ? z.reverse() : z; };
    const Eigen::ArrayXd cut = wave.min(0.5).tail(113);  // from within the first plateau on
    CHECK(std::isfinite(five(turned(cut))));
    CHECK(std::isnan(five(turned(fewer.min(0.5).tail(93)))));
    Eigen::ArrayXd gap = fewer.min(0.5);
    CHECK(std::isfinite(five(turned(gap))));
    gap(48) = std::nan("");  // behind the third plateau
    CHECK(std::isnan(five(turned(gap))));
  }
}

TEST_CASE("the material ratio parameters of a profile are those of a surface of its heights",
          "[profile][law]") {
  const Field z = moving_average({1, 300}, {1, 4}, 8);
  const Eigen::ArrayXd row = z.row(0).transpose();
  const Parameters surface = measure({.grid = grid(1, 300), .heights = z}, {.groups = {Group::material}});
  const ProfileParameters p = profile_parameters(row, 1, whole, false);
  const MeasureOptions at{
      .groups = {Group::material}, .material_heights = {{0.4, "c"}}, .profiles = Axis1D::y};
  Field two = z.replicate(2, 1);
  two.row(1) += 3;
  const Sample both(prepared({.grid = grid(2, 300), .heights = two}, {}));
  CHECK(std::abs(named(profile_averages(both, at), "Pmr_c").value -
                 named(measure({.grid = grid(1, 300), .heights = z}, at), "Smr_c").value) <= 1e-9);
  for (const auto& [k, name] : {std::pair{profile_k, "Sk"},
                                {profile_pk, "Spk"},
                                {profile_vk, "Svk"},
                                {profile_mr1, "Smr1"},
                                {profile_mr2, "Smr2"},
                                {profile_pkx, "Spkx"},
                                {profile_vkx, "Svkx"},
                                {profile_ak1, "Sak1"},
                                {profile_ak2, "Sak2"},
                                {profile_mc_p, "Smc_p"},
                                {profile_mc_q, "Smc_q"},
                                {profile_dc, "Sdc"}}) {
    CAPTURE(name);
    CHECK(std::abs(p[k] - named(surface, name).value) <= 1e3 * epsilon);
  }
  CHECK_THROWS_AS(profile_parameters(row, 1, whole, false, 0, {0.8, 0.1}), ParameterError);
}

TEST_CASE("points that a profile lacks are left out, and no element reaches over them", "[profile][exact]") {
  Eigen::ArrayXd z = profile_wave(20, 8, 1);
  z.segment(63, 20).setConstant(std::nan(""));  // a period, so that the mean and the sums are those of seven
  const ProfileParameters p = profile_parameters(z, 1, whole, false),
                          full = profile_parameters(profile_wave(20, 7, 1), 1, whole, false);
  CHECK(relative_error(p[profile_q], full[profile_q]) <= 1e-13);
  CHECK(relative_error(p[profile_a], full[profile_a]) <= 1e-13);
  CHECK(relative_error(p[profile_sm], 20) <= 1e-13);
  const double slope = full[profile_dq];
  CHECK(std::abs(p[profile_dq] / slope - 1) <= 0.05);  // other phases of the wave count
  CHECK(profile_parameters(Eigen::ArrayXd::Constant(9, std::nan("")), 1, whole, false).isNaN().all());
}

// Once, Pp of a surface that varies along y only was -2e-24 m, with an error, and Pv as much.
TEST_CASE("profiles that are straight to round-off have no heights", "[profile][contract]") {
  Field z = white_noise({1, 60}, 3).replicate(40, 1);
  for (const int degree : {0, 2}) {
    const Surface surface =
        prepared({.grid = grid(40, 60), .heights = 1e-7 * z}, {.form = {.degree = degree}});
    const Sample sample(surface);
    for (const Parameter& p : profile_averages(sample, {.profiles = Axis1D::x})) {
      CAPTURE(degree, p.name, p.value);
      if (p.name.starts_with("profiles")) continue;
      const std::array of_shape{"Psk", "Pku", "PSm", "Pc", "Pmr1", "Pmr2", "P5p", "P5v", "P10z"};
      const bool shape =
          std::ranges::any_of(of_shape, [&](const char* of) { return p.name.starts_with(of); });
      if (shape) CHECK(std::isnan(p.value));
      if (!shape) CHECK(p.value == 0);
      CHECK(std::isnan(p.standard_error));
    }
  }
}

TEST_CASE("averages are over the profiles along one axis, and do not change when the surface is transposed",
          "[profile][law]") {
  const Field z = sine({60, 7}, 2, 7);
  const LagField rho = triangular_correlation({1, 1});
  const ProfileAverages x = average_profiles(z, grid(60, 7), {100, 1}, Axis1D::x, whole, rho),
                        y = average_profiles(z.transpose(), grid(7, 60), {100, 1}, Axis1D::y, whole, rho);
  CHECK(x.profiles == 7);
  CHECK(x.of[profile_q].mean == Approx(std::numbers::sqrt2).epsilon(1e-13));
  CHECK(x.of[profile_q].spread <= 1e-13);
  for (std::size_t k = 0; k < x.of.size(); ++k) CHECK(x.of[k].mean == y.of[k].mean);
  CHECK_THROWS_AS(average_profiles(z, grid(60, 7), {100, 1}, Axis1D::x, 61, rho), ParameterError);
}

namespace {

Parameters parameters_of_profiles(const Field& z, const LagField& rho) {
  return measure(Surface{.grid = grid(z.rows(), z.cols()), .heights = 1e-6 * z, .correlation = rho},
                 {.groups = {Group::profiles}});
}

}  // namespace

TEST_CASE("parameters of profiles have Student's intervals, if three profiles are independent and differ",
          "[profile][contract]") {
  const LagField rho = triangular_correlation({4, 6});
  const Field z = moving_average({100, 60}, {4, 6}, 4);
  const Parameters all = parameters_of_profiles(z, rho);
  const ProfileAverages averages = average_profiles(z, grid(100, 60), {100, 1}, Axis1D::x, whole, rho);
  auto t_of = [](const WaveError& of) { return student_quantile(0.025, of.degrees); };
  const double t_of_spread = t_of(averages.of[profile_sm].of_spread);
  for (const auto& [name, k] : {std::pair{"Pdq", profile_dq}, {"Pz", profile_z}}) {
    const Parameter& p = named(all, name);
    CAPTURE(name);
    CHECK(std::log(p.interval_95().high / p.value) ==
          Approx(t_of(averages.of[size(k)].of_mean) * p.standard_error / p.value).epsilon(1e-12));
  }
  const Parameter& spread = named(all, "PSm_spread");
  CHECK(spread.value / spread.interval_95().low - 1 ==
        Approx(t_of_spread * spread.standard_error / spread.value).epsilon(1e-12));
  const Parameter &psk = named(all, "Psk"), &pq = named(all, "Pq");
  CHECK(psk.interval_95().high - psk.value == Approx(psk.value - psk.interval_95().low).epsilon(1e-9));
  // Of a square field, not of the one of these lengths.
  CHECK(relative_error(pq.standard_error, 1e-6 * averages.of[profile_q].of_mean.error) <= 0.1);
  for (const Parameter& p : all) CHECK(std::isfinite(p.standard_error) == !p.name.starts_with("profiles"));

  const Field few = z.leftCols(8), equal = sine({60, 7}, 2, 7);
  for (const auto& [of, why] :
       {std::pair{few, "profiles are independent, fewer than 3"}, {equal, "it is the same in all profiles"}})
    for (const Parameter& p :
         parameters_of_profiles(of, of.rows() == 60 ? triangular_correlation({1, 1}) : rho)) {
      if (p.name.starts_with("profiles")) continue;
      CAPTURE(p.name, p.why);
      CHECK(std::isnan(p.standard_error));
      CHECK_THAT(p.note(), ContainsSubstring(why));
    }
}

TEST_CASE("no interval of a kurtosis of profiles reaches below 1", "[profile][law]") {
  Field z = moving_average({96, 6}, {4, 1}, 2);
  z(40, 3) = 1000;
  const Parameter pku = named(parameters_of_profiles(z, triangular_correlation({4, 1})), "Pku");
  CHECK(pku.value > 10);
  CHECK(pku.interval_95().low >= 1);
}
