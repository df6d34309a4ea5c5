#include "surface/tile_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

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

class DirectFilter : public TileFilter {
 public:
  DirectFilter(const Field& kernel, Shape surface)
      : TileFilter({std::min(surface.nx, direct_rows), std::min(surface.ny, direct_columns)}),
        kernel_(kernel) {}

  std::unique_ptr<Worker> worker() const override { return std::make_unique<Sum>(kernel_); }
  std::size_t shared_bytes() const override { return size(kernel_.size()) * sizeof(double); }
  std::size_t worker_bytes() const override { return 0; }

 private:
  struct Sum : Worker {
    explicit Sum(const Field& k) : kernel(k) {}
    void filter(const Eigen::Ref<const Field>& noise, Eigen::Ref<Field> out) override {
      out.setZero();
      for (Index i = 0; i < out.rows(); ++i)
        for (Index k = 0; k < kernel.rows(); ++k)
          for (Index l = 0; l < kernel.cols(); ++l)
            out.row(i) += kernel(k, l) * noise.row(i + k).segment(l, out.cols());
    }
    const Field& kernel;
  };

  Field kernel_;
};

class TransformFilter : public TileFilter {
 public:
  TransformFilter(const Field& kernel, Shape torus)
      : TileFilter({torus.nx - kernel.rows() + 1, torus.ny - kernel.cols() + 1}),
        transform_(torus),
        symbol_(size(transform_.spectrum_size())) {
    AlignedVector<double> padded(size(torus.cells()), 0.0);
    for (Index k = 0; k < kernel.rows(); ++k)
      std::copy_n(kernel.data() + k * kernel.cols(), kernel.cols(), padded.data() + k * torus.ny);
    transform_.forward(padded.data(), symbol_.data());
    const double scale = 1.0 / static_cast<double>(torus.cells());
    for (Complex& s : symbol_) s = scale * std::conj(s);
  }

  std::unique_ptr<Worker> worker() const override { return std::make_unique<OverlapSave>(*this); }
  std::size_t shared_bytes() const override { return symbol_.size() * sizeof(Complex); }
  std::size_t worker_bytes() const override {
    return size(transform_.shape().cells()) * sizeof(double) + symbol_.size() * sizeof(Complex);
  }

 private:
  struct OverlapSave : Worker {
    explicit OverlapSave(const TransformFilter& f)
        : filter_(f), torus(size(f.transform_.shape().cells())), spectrum(f.symbol_.size()) {}

    void filter(const Eigen::Ref<const Field>& noise, Eigen::Ref<Field> out) override {
      const auto [rows, columns] = filter_.transform_.shape();
      Eigen::Map<Field> field(torus.data(), rows, columns);
      field.topLeftCorner(noise.rows(), noise.cols()) = noise;
      field.rightCols(columns - noise.cols()).setZero();
      field.bottomRows(rows - noise.rows()).setZero();
      filter_.transform_.forward(torus.data(), spectrum.data());
      filter_.multiply(spectrum);
      filter_.transform_.inverse(spectrum.data(), torus.data());
      out = field.topLeftCorner(out.rows(), out.cols());
    }

    const TransformFilter& filter_;
    AlignedVector<double> torus;
    AlignedVector<Complex> spectrum;
  };

  // By Eigen, for the library's product of complex numbers takes care of infinities, which forbids vector instructions.
  void multiply(AlignedVector<Complex>& spectrum) const {
    const Index n = transform_.spectrum_size();
    Eigen::Map<Eigen::ArrayXcd>(spectrum.data(), n) *= Eigen::Map<const Eigen::ArrayXcd>(symbol_.data(), n);
  }

  RealTransform2D transform_;
  AlignedVector<Complex> symbol_;
};

}  // namespace

std::unique_ptr<const TileFilter> direct_filter(const Field& kernel, Shape surface) {
  return std::make_unique<DirectFilter>(kernel, surface);
}

std::unique_ptr<const TileFilter> transform_filter(const Field& kernel, Shape surface) {
  return std::make_unique<TransformFilter>(kernel, cheapest_tiling(shape_of(kernel), surface).torus);
}

SynthesisCost synthesis_cost(Shape kernel, Shape surface) {
  return {static_cast<double>(surface.cells()) * static_cast<double>(kernel.cells()) * seconds_per_product,
          cheapest_tiling(kernel, surface).seconds};
}

}  // namespace asperity
