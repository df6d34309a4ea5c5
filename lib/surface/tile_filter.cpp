#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "surface/synthesis.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

// Only their ratio decides; validation/synthesis_time.cpp holds it against the clock.
constexpr double seconds_per_product = 0.16e-9;
constexpr double seconds_per_butterfly = 0.4e-9;
constexpr double points_in_the_cache = 1 << 17;

// The longest torus worth its memory, in kernels and in points.
constexpr Index kernels_in_a_torus = 8, points_in_a_torus = 512;

// Columns whose noise and heights stay in the first-level cache during a direct sum.
constexpr Index direct_columns = 512, direct_rows = 64;

// A fast length for a side of a torus. FFTW is slower by half where it finds too few factors of two.
Index torus_length(Index least) { return fast_length(least, least < 64 ? 2 : 8); }

// One direction of a torus: its length, and how many tiles of it cover the surface.
struct Side {
  Index length, tiles;
};

// The fast lengths for n heights and a kernel of k, the shortest for each number of tiles.
std::vector<Side> sides(Index n, Index k) {
  const Index whole = torus_length(n + k - 1),
              longest = std::min(whole, torus_length(std::max(kernels_in_a_torus * k, points_in_a_torus)));
  std::vector<Side> out;
  for (Index length = torus_length(k); length <= longest; length = torus_length(length + 1)) {
    const Index good = length - k + 1, tiles = (n + good - 1) / good;
    if (out.empty() || tiles < out.back().tiles) out.push_back({length, tiles});
  }
  return out;
}

double transform_seconds(Side x, Side y) {
  const double points = static_cast<double>(x.length * y.length);
  const double slower = std::pow(std::max(1.0, points / points_in_the_cache), 0.25);
  return static_cast<double>(x.tiles * y.tiles) * 2 * points * std::log2(points) * slower *
         seconds_per_butterfly;
}

struct Tiling {
  Shape torus;
  double seconds = std::numeric_limits<double>::infinity();
};

Tiling cheapest_tiling(Shape kernel, Shape surface) {
  Tiling best;
  const std::vector<Side> columns = sides(surface.ny, kernel.ny);
  for (const Side& x : sides(surface.nx, kernel.nx))
    for (const Side& y : columns)
      if (const double seconds = transform_seconds(x, y); seconds < best.seconds)
        best = {{x.length, y.length}, seconds};
  return best;
}

// The kernel's conjugate spectrum on a torus.
struct Symbol {
  Symbol(const Field& kernel, Shape torus) : transform(torus), values(size(transform.spectrum_size())) {
    AlignedVector<double> padded(size(torus.cells()), 0.0);
    for (Index k = 0; k < kernel.rows(); ++k)
      std::copy_n(kernel.data() + k * kernel.cols(), kernel.cols(), padded.data() + k * torus.ny);
    transform.forward(padded.data(), values.data());
    const double scale = 1.0 / static_cast<double>(torus.cells());
    for (Complex& s : values) s = scale * std::conj(s);
  }

  // By Eigen, for the library's product of complex numbers takes care of infinities, which forbids vector
  // instructions.
  void multiply(AlignedVector<Complex>& spectrum) const {
    const Index n = transform.spectrum_size();
    Eigen::Map<Eigen::ArrayXcd>(spectrum.data(), n) *= Eigen::Map<const Eigen::ArrayXcd>(values.data(), n);
  }

  RealTransform2D transform;
  AlignedVector<Complex> values;
};

struct OverlapSave {
  explicit OverlapSave(std::shared_ptr<const Symbol> s)
      : symbol(std::move(s)),
        torus(size(symbol->transform.shape().cells())),
        spectrum(symbol->values.size()) {}

  void operator()(const Eigen::Ref<const Field>& noise, Eigen::Ref<Field> out) {
    const auto [rows, columns] = symbol->transform.shape();
    Eigen::Map<Field> field(torus.data(), rows, columns);
    field.topLeftCorner(noise.rows(), noise.cols()) = noise;
    field.rightCols(columns - noise.cols()).setZero();
    field.bottomRows(rows - noise.rows()).setZero();
    symbol->transform.forward(torus.data(), spectrum.data());
    symbol->multiply(spectrum);
    symbol->transform.inverse(spectrum.data(), torus.data());
    out = field.topLeftCorner(out.rows(), out.cols());
  }

  std::shared_ptr<const Symbol> symbol;
  AlignedVector<double> torus;
  AlignedVector<Complex> spectrum;
};

void direct_sum(const Field& kernel, const Eigen::Ref<const Field>& noise, Eigen::Ref<Field> out) {
  out.setZero();
  for (Index i = 0; i < out.rows(); ++i)
    for (Index k = 0; k < kernel.rows(); ++k)
      for (Index l = 0; l < kernel.cols(); ++l)
        out.row(i) += kernel(k, l) * noise.row(i + k).segment(l, out.cols());
}

}  // namespace

TileFilter direct_filter(const Field& kernel, Shape surface) {
  const TileWorker sum = [kernel = std::make_shared<const Field>(kernel)](
                             const Eigen::Ref<const Field>& noise, Eigen::Ref<Field> out) {
    direct_sum(*kernel, noise, out);
  };
  return {{std::min(surface.nx, direct_rows), std::min(surface.ny, direct_columns)},
          size(kernel.size()) * sizeof(double),
          0,
          [sum] { return sum; }};
}

TileFilter transform_filter(const Field& kernel, Shape surface) {
  const Shape torus = cheapest_tiling(shape_of(kernel), surface).torus;
  const auto symbol = std::make_shared<const Symbol>(kernel, torus);
  const std::size_t shared = symbol->values.size() * sizeof(Complex);
  return {{torus.nx - kernel.rows() + 1, torus.ny - kernel.cols() + 1},
          shared,
          size(torus.cells()) * sizeof(double) + shared,
          [symbol] { return OverlapSave(symbol); }};
}

SynthesisCost synthesis_cost(Shape kernel, Shape surface) {
  return {static_cast<double>(surface.cells()) * static_cast<double>(kernel.cells()) * seconds_per_product,
          cheapest_tiling(kernel, surface).seconds};
}

}  // namespace asperity
