#include <limits>
#include <random>

#include "stability.hpp"
#include "stats/filter/form.hpp"
#include "stats/height/material_ratio.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/sample/moments.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/spectrum/spectrum.hpp"
#include "stats/uncertainty/effective_size.hpp"

namespace asperity {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = NAN;

Field skewed_noise(Index nx, Index ny) {
  std::mt19937_64 generator(7);
  std::gamma_distribution<double> gamma(4);
  return Field::NullaryExpr(nx, ny, [&](Index, Index) { return gamma(generator); });
}

double difference(const Moments& a, const Moments& b, double scale) {
  return std::max({std::abs(a.sq / scale / b.sq - 1), std::abs(a.sa / scale / b.sa - 1),
                   std::abs(a.ssk / b.ssk - 1), std::abs(a.sku / b.sku - 1)});
}

void heights(const StabilityTable& table) {
  const Field z = skewed_noise(128, 128);
  const Moments plain = moments(z);
  for (double scale : {1e-70, 1e-12, 1e3, 1e70})
    table.answered(fmt::format("moments of heights of {:g} m", scale), "scale of the heights", [&] {
      return Finding{"computed", "change of Sa, Sq, Ssk, Sku", difference(moments(scale * z), plain, scale),
                     1e-13};
    });
  // The heights themselves are rounded to ε of the offset, 1e6 σ ε of σ each.
  for (double offset : {1e6, -1e9})
    table.answered(fmt::format("moments, offset {:g} Sq", offset), "cancellation", [&] {
      const double bound = 8 * std::abs(offset) * std::numeric_limits<double>::epsilon();
      return Finding{"computed", "change of Sa, Sq, Ssk, Sku",
                     difference(moments(z + offset * plain.sq), plain, 1), bound};
    });
  for (double scale : {1e-310, 1e-160, 1e160, 1e300})
    table.refused(fmt::format("moments of heights of {:g} m", scale), "fourth powers leave a double's range",
                  [&] { moments(scale * z); });
  for (double height : {infinity, -infinity})
    table.refused(fmt::format("moments with a height of {}", height), "no height", [&] {
      Field wrong = z;
      wrong(5, 6) = height;
      moments(wrong);
    });
  table.refused("moments of a plane at 1 m", "no roughness", [] { moments(Field::Ones(16, 16)); });
  table.refused("moments of one height", "no roughness", [] { moments(Field::Ones(1, 1)); });
  table.refused("moments, every height missing", "nothing there",
                [] { moments(Field::Constant(8, 8, nan)); });
  table.answered("moments, all but two heights missing", "next to nothing there", [] {
    Field two = Field::Constant(64, 64, nan);
    two(0, 0) = 1, two(63, 63) = 3;
    const Moments m = moments(two);
    return Finding{"computed", "error of Sq, Sku", std::abs(m.sq - 1) + std::abs(m.sku - 1), 1e-15};
  });
}

// C(p,q) over its pairs.
double acf_error(const Field& z, bool periodic) {
  const Grid grid{shape_of(z), 1, 1, periodic};
  AcfParameters parameters;
  parameters.max_lag = default_max_lag(grid);
  const LagField acf = estimate_autocorrelation(z, grid, parameters);
  const Field d = z - mean(z);
  const Index nx = z.rows(), ny = z.cols();
  double worst = 0;
  for (Index p = 0; p <= acf.max_p(); p += std::max<Index>(1, acf.max_p() / 3))
    for (Index q = 0; q <= acf.max_q(); q += std::max<Index>(1, acf.max_q() / 3)) {
      double sum = 0, pairs = 0;
      for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) {
          if (!periodic && (i + p >= nx || j + q >= ny)) continue;
          sum += d(i, j) * d((i + p) % nx, (j + q) % ny);
          ++pairs;
        }
      const double error = std::abs(acf(p, q) - sum / pairs) / acf(0, 0);
      worst = error <= worst ? worst : error;
    }
  return worst;
}

void shapes(const StabilityTable& table) {
  for (Shape s : {Shape{1, 512}, {512, 1}, {127, 131}, {128, 128}, {2, 3}})
    for (bool periodic : {false, true})
      table.answered(
          fmt::format("acf of {} x {}{}", s.nx, s.ny, periodic ? ", periodic" : ""),
          s.nx == 127                 ? "primes"
          : s.nx == 128               ? "powers of two"
          : std::min(s.nx, s.ny) == 1 ? "a line"
                                      : "a handful of points",
          [&] {
            return Finding{"computed", "error / Sq^2", acf_error(skewed_noise(s.nx, s.ny), periodic), 1e-13};
          });
  table.answered("acf, offset 1e6 Sq", "cancellation", [] {
    const Field z = skewed_noise(64, 64);
    const Grid grid{{64, 64}, 1, 1};
    const Field a = estimate_autocorrelation(z, grid, {.max_lag = {8, 8}}).half_plane(),
                b = estimate_autocorrelation(z + 2e6, grid, {.max_lag = {8, 8}}).half_plane();
    return Finding{"computed", "change / Sq^2", (a - b).abs().maxCoeff() / a.maxCoeff(), 1e-9};
  });
  const Grid line{{1, 64}, 1, 1};
  table.refused("slopes of 1 x 64", "no cell of 2 x 2 points",
                [&] { slope_parameters(skewed_noise(1, 64), line); });
  table.refused("acf to lags beyond the field", "no pairs", [&] {
    estimate_autocorrelation(skewed_noise(1, 64), line, {.max_lag = {1, 64}});
  });
  table.refused("material ratio of one height", "no curve", [] { MaterialRatioCurve(Field::Ones(1, 1)); });
  table.answered("material ratio of a plane", "every height the same", [] {
    const MaterialRatioCurve curve(Field::Ones(32, 32));
    const CoreParameters c = curve.core();
    return Finding{"computed", "Sk + Spk + Svk", std::abs(c.sk) + std::abs(c.spk) + std::abs(c.svk), 0};
  });
  table.answered("spectrum of 1 x 127", "a line of prime length", [] {
    const Field z = skewed_noise(1, 127) - 4;
    const Grid grid{{1, 127}, 1, 1, true};
    const LagField psd = power_spectrum(z, grid, {DataWindow::none, DataWindow::none});
    double sum = 0;  // of the row p = 0, which has both signs of q
    for (Index q = -psd.max_q(); q <= psd.max_q(); ++q) sum += psd(0, q);
    return Finding{"computed", "error of Parseval's sum", std::abs(sum / 127 / z.square().mean() - 1), 1e-13};
  });
}

void forms(const StabilityTable& table) {
  table.answered("form of degree 20, 64 x 64", "high polynomials", [] {
    const Grid grid{{64, 64}, 2.0 / 64, 2.0 / 64};
    const Field form =
        sample(grid, [](double x, double y) { return 1e6 * std::pow(x, 13) * std::pow(y, 7); });
    return Finding{"taken away", "left / form", remove_form(form, 20).abs().maxCoeff() / form.maxCoeff(),
                   1e-12};
  });
  table.answered("form of degree 20, 3 x 3", "more terms than points", [] {
    return Finding{"taken away", "left", remove_form(skewed_noise(3, 3), 20).abs().maxCoeff(), 1e-13};
  });
  table.refused("form of degree 2, heights in one row", "points do not determine it", [] {
    Field z = Field::Constant(16, 16, nan);
    z.row(3) = 1;
    z(3, 4) = 2;
    remove_form(z, 2);
  });
  table.refused("form of degree 21", "beyond the bound", [] { remove_form(Field::Ones(4, 4), 21); });
}

}  // namespace

void statistics_stability() {
  const StabilityTable table("statistics");
  heights(table);
  shapes(table);
  forms(table);
}

}  // namespace asperity
