#include <limits>
#include <numbers>

#include "acf/kernel.hpp"
#include "acf/table.hpp"
#include "reference/exponential_target.hpp"
#include "stability.hpp"

namespace asperity {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = NAN;

KernelRequest request(Target target, Shape lags = {}) {
  KernelRequest out;
  out.target = std::move(target);
  out.lags = lags;
  return out;
}

// Exponential, fallen to e⁻ᶜ at the last of n × m lags.
KernelRequest cut(Index n, Index m, double c) {
  return request(ExponentialTarget{static_cast<double>(n), static_cast<double>(m), std::exp(-c)}, {n, m});
}

EllipticTarget elliptic(Model model, double length_x, double length_y) {
  EllipticTarget out;
  out.model = model;
  out.length_x = length_x, out.length_y = length_y;
  return out;
}

// An answer that changes the target is judged by the change, any other by the residual of its equations.
Finding solution(const KernelRequest& asked) {
  const Kernel k = solve_kernel(asked);
  const KernelReport& r = k.report;
  const std::string size = fmt::format("{} at {}x{} lags", name_of(r.answer), k.lags.nx, k.lags.ny);
  if (!k.values.isFinite().all()) return {size + ", coefficients not finite", "residual", nan, 0};
  if (!r.converged) return {fmt::format("not converged: {}", r.reason), "residual", r.residual, infinity};
  if (r.answer == Answer::exact || r.answer == Answer::wider)
    return {size, "residual", r.residual, asked.tolerance};
  const bool bounded = asked.infeasible == InfeasiblePolicy::automatic;
  return {size + ", target changed", "change", std::max(r.change, r.residual), bounded ? 1e-2 : 2};
}

KernelRequest with(KernelRequest asked, InfeasiblePolicy infeasible) {
  asked.infeasible = infeasible;
  return asked;
}

void lengths(const StabilityTable& table) {
  auto at_open_lags = [&](const char* name, const char* hard, double x, double y) {
    table.answered(name, hard,
                   [&] { return solution(request(elliptic(Model::exponential, x, y).target())); });
  };
  at_open_lags("lengths 100 x 1 samples", "ellipticity 100", 100, 1);
  at_open_lags("lengths 0.1 x 0.1 samples", "below a sample", 0.1, 0.1);
  at_open_lags("lengths 1e-6 x 20 samples", "below a sample in x alone", 1e-6, 20);
  table.answered("lengths 100 x 1 samples at 30 degrees", "oriented, ellipticity 100", [] {
    EllipticTarget target = elliptic(Model::exponential, 100, 1);
    target.angle = std::numbers::pi / 6;
    return solution(request(target.target(), {48, 32}));
  });
  table.answered("1 x 1 lags", "nothing to solve", [] { return solution(cut(1, 1, 4.6)); });
  table.answered("1 x 63 lags", "a line", [] { return solution(cut(1, 63, 4.6)); });
  for (double length : {0.0, -1.0, infinity, nan})
    table.refused(fmt::format("length {}", length), "no length", [&] {
      solve_kernel(request(elliptic(Model::exponential, length, 4).target(), {8, 8}));
    });
}

void infeasible(const StabilityTable& table) {
  table.answered("7 x 4 lags, cut at 10 %", "spectrum of the cut target negative",
                 [] { return solution(cut(7, 4, 2.3)); });
  table.answered("17 x 14 lags, cut at 10 %", "no kernel of its size",
                 [] { return solution(cut(17, 14, 2.3)); });
  table.answered("31 x 31 lags, cut at 10 %", "no kernel of its size",
                 [] { return solution(cut(31, 31, 2.3)); });
  const KernelRequest longer = cut(31, 31, 0.1);
  table.refused("31 x 31 lags, cut at 90 %", "lengths far beyond the lags",
                [&] { solve_kernel(with(longer, InfeasiblePolicy::error)); });
  table.refused("the same, automatic", "lengths far beyond the lags", [&] { solve_kernel(longer); });
  table.answered("the same, nearest", "lengths far beyond the lags",
                 [&] { return solution(with(longer, InfeasiblePolicy::nearest)); });
  table.answered("R = 1 at 15 x 15 lags, nearest", "a constant surface: equations of rank one", [] {
    return solution(
        with(request(Target([](double, double) { return 1.0; }), {15, 15}), InfeasiblePolicy::nearest));
  });
  auto box = [](double p, double q) { return std::hypot(p, q) < 6 ? 1.0 : 0.0; };
  table.refused("R = 1 within 6 samples, 0 beyond", "no autocorrelation at all", [&] {
    solve_kernel(request(Target(box), {15, 15}));
  });
  table.answered("the same, nearest", "no autocorrelation at all", [&] {
    return solution(with(request(Target(box), {15, 15}), InfeasiblePolicy::nearest));
  });
  auto wave = [](double p, double) { return std::cos(std::numbers::pi * p / 4); };
  table.answered("R = cos(pi p/4) at 16 x 1 lags, nearest", "a line spectrum: singular", [&] {
    return solution(with(request(Target(wave), {16, 1}), InfeasiblePolicy::nearest));
  });
}

void smooth_and_rough(const StabilityTable& table) {
  auto model = [](Model m, double length, auto set) {
    EllipticTarget target = elliptic(m, length, length);
    set(target);
    return target.target();
  };
  auto answered = [&](const char* name, const char* hard, const Target& target, Shape lags = {}) {
    table.answered(name, hard, [&] { return solution(request(target, lags)); });
  };
  const auto gaussian = [](auto&) {};
  answered("Gaussian, lengths 10", "spectrum ends in round-off", model(Model::gaussian, 10, gaussian));
  answered("Gaussian, lengths 40", "spectrum ends in round-off", model(Model::gaussian, 40, gaussian));
  answered("Matern, nu = 100", "nearly Gaussian",
           model(Model::matern, 10, [](auto& t) { t.smoothness = 100; }));
  answered("Matern, nu = 0.01", "nearly white at small lags, a long tail",
           model(Model::matern, 10, [](auto& t) { t.smoothness = 0.01; }), {31, 31});
  answered("self-affine, H = 0.01", "nearly white at small lags, a long ripple",
           model(Model::self_affine, 10, [](auto& t) { t.hurst = 0.01; }), {31, 31});
  answered("self-affine, H = 1", "smooth, a long ripple",
           model(Model::self_affine, 5, [](auto& t) { t.hurst = 1; }), {40, 40});
  answered("exponential-cosine, wavelength 0.7", "beyond Nyquist's",
           model(Model::exponential_cosine, 10, [](auto& t) { t.wavelength = 0.7; }));
  const Target tail = model(Model::stretched_exponential, 10, [](auto& t) { t.exponent = 0.05; });
  table.refused("stretched exponential, beta = 0.05", "a tail over many decades",
                [&] { solve_kernel(request(tail)); });
  answered("the same at 31 x 31 lags", "a tail over many decades", tail, {31, 31});
}

Field table_of(double first) {
  Field half_plane = Field::Zero(3, 5);
  half_plane(0, 2) = 1;
  half_plane(0, 1) = half_plane(0, 3) = first;
  return half_plane;
}

void tables_and_numbers(const StabilityTable& table) {
  table.refused("table with R(0,1) = 1.1", "above R(0,0)", [] { target_of_table(table_of(1.1)); });
  table.refused("table with R(0,1) = NaN", "no number", [] { target_of_table(table_of(nan)); });
  const KernelRequest impossible = request(target_of_table(table_of(0.9)));
  table.refused("table with R(0,1) = 0.9, 0 beyond", "not positive definite",
                [&] { solve_kernel(with(impossible, InfeasiblePolicy::error)); });
  table.refused("the same, automatic", "not positive definite", [&] { solve_kernel(impossible); });
  table.answered("the same, nearest", "not positive definite",
                 [&] { return solution(with(impossible, InfeasiblePolicy::nearest)); });
  table.answered("table with R(0,1) = 0.5, 0 beyond", "spectrum zero at one wave number",
                 [] { return solution(request(target_of_table(table_of(0.5)))); });
  for (double rms : {1e-12, 1e3})
    table.answered(fmt::format("rms {:g} m", rms), "scale of the heights", [&] {
      KernelRequest asked = cut(15, 15, 4.6), one = asked;
      asked.rms = rms;
      const Field a = solve_kernel(asked).values / rms, b = solve_kernel(one).values;
      return Finding{"exact", "difference from 1 m", (a - b).abs().maxCoeff() / b.abs().maxCoeff(), 1e-15};
    });
  for (double rms : {0.0, nan, infinity})
    table.refused(fmt::format("rms {} m", rms), "no scale", [&] {
      KernelRequest asked = cut(7, 4, 4.6);
      asked.rms = rms;
      solve_kernel(asked);
    });
  table.refused("100000 x 100000 lags", "too many equations", [] { solve_kernel(cut(100000, 100000, 4.6)); });
}

}  // namespace

void kernel_stability() {
  const StabilityTable table("kernel");
  lengths(table);
  infeasible(table);
  smooth_and_rough(table);
  tables_and_numbers(table);
}

}  // namespace asperity
