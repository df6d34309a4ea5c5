#include "surface/synthesis.hpp"

#include <cmath>

#include "grid/error.hpp"
#include "grid/parallel.hpp"
#include "transform/pruned.hpp"

namespace asperity {
namespace {

constexpr Index width = PrunedTransform::width;

// Only their ratio decides; validation/synthesis_time.cpp holds it against the clock.
constexpr double seconds_per_product = 0.15e-9;
constexpr double seconds_per_butterfly = 0.5e-9;

// Rows of noise in a strip: long against the K - 1 that are drawn twice, short against memory.
constexpr Index kernels_in_a_strip = 8;

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

Shape noise_shape(Shape kernel, Shape surface) {
  return {surface.nx + kernel.nx - 1, surface.ny + kernel.ny - 1};
}

Shape strip_torus(Shape kernel, Shape surface) {
  const Shape noise = noise_shape(kernel, surface);
  return {fast_length(std::min(noise.nx, kernels_in_a_strip * kernel.nx)), fast_length(noise.ny, 2)};
}

}  // namespace

// How rows of noise become rows of the surface, strip by strip.
class Synthesis::Strips {
 public:
  virtual ~Strips() = default;
  Index good_rows() const { return good_rows_; }
  Index noise_rows() const { return good_rows_ + kernel_.nx - 1; }

  // Rows of noise, at most noise_rows() of M + L - 1 values, into rows of the surface. What the work needs is
  // its own.
  struct Worker {
    virtual ~Worker() = default;
    virtual void filter(const Field& noise, Eigen::Ref<Field> out) = 0;
  };
  virtual std::unique_ptr<Worker> worker() const = 0;

  class Direct;
  class Transform;

 protected:
  Strips(Shape kernel, Index good_rows) : kernel_(kernel), good_rows_(good_rows) {}
  Shape kernel_;
  Index good_rows_;
};

class Synthesis::Strips::Direct : public Strips {
 public:
  Direct(const Field& kernel, Shape surface)
      : Strips(shape_of(kernel), std::min(surface.nx, kernels_in_a_strip * kernel.rows())), values_(kernel) {}

  std::unique_ptr<Worker> worker() const override {
    struct Sum : Worker {
      explicit Sum(const Field& k) : kernel(k) {}
      void filter(const Field& noise, Eigen::Ref<Field> out) override {
        out.setZero();
        for (Index i = 0; i < out.rows(); ++i)
          for (Index k = 0; k < kernel.rows(); ++k)
            for (Index l = 0; l < kernel.cols(); ++l)
              out.row(i) += kernel(k, l) * noise.row(i + k).segment(l, out.cols());
      }
      const Field& kernel;
    };
    return std::make_unique<Sum>(values_);
  }

 private:
  Field values_;
};

class Synthesis::Strips::Transform : public Strips {
 public:
  Transform(const Field& kernel, Shape surface)
      : Strips(shape_of(kernel), strip_torus(shape_of(kernel), surface).nx - kernel.rows() + 1),
        transform_({noise_rows(), surface.ny + kernel.cols() - 1}, strip_torus(shape_of(kernel), surface)),
        symbol_(size(transform_.blocks() * transform_.block_size())) {
    Field padded = Field::Zero(transform_.field().nx, transform_.field().ny);
    padded.topLeftCorner(kernel.rows(), kernel.cols()) = kernel;
    HalfSpectrum half = transform_.half_spectrum();
    transform_.forward_rows(padded, half);
    for (Index b = 0; b < transform_.blocks(); ++b) transform_.forward_block(half, b, symbol(b));
    const double scale = 1.0 / static_cast<double>(transform_.torus().cells());
    for (Complex& s : symbol_) s = scale * std::conj(s);
  }

  std::unique_ptr<Worker> worker() const override { return std::make_unique<OverlapSave>(*this); }

 private:
  struct OverlapSave : Worker {
    explicit OverlapSave(const Transform& s)
        : strips(s),
          half(s.transform_.half_spectrum()),
          block(size(s.transform_.block_size())),
          spectrum(size(s.transform_.blocks() * width)),
          row(size(s.transform_.torus().ny + 2)) {}

    void filter(const Field& noise, Eigen::Ref<Field> out) override {
      const PrunedTransform& transform = strips.transform_;
      transform.forward_rows(noise, half);
      for (Index b = 0; b < transform.blocks(); ++b) {
        transform.forward_block(half, b, block.data());
        strips.multiply(b, block.data());
        transform.inverse_block(block.data(), b, half);
      }
      for (Index i = 0; i < out.rows(); ++i) {
        transform.inverse_row(half, i, spectrum.data(), row.data());
        std::copy_n(row.data(), out.cols(), &out(i, 0));
      }
    }

    const Transform& strips;
    HalfSpectrum half;
    AlignedVector<Complex> block, spectrum;
    AlignedVector<double> row;
  };

  Complex* symbol(Index b) { return symbol_.data() + b * transform_.block_size(); }
  void multiply(Index b, Complex* block) const {
    const Complex* s = symbol_.data() + b * transform_.block_size();
    for (Index i = 0; i < transform_.block_size(); ++i) block[i] = multiplied(block[i], s[i]);
  }
  // Without the library's care for infinities, which would forbid vector instructions.
  static Complex multiplied(Complex a, Complex b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
  }

  PrunedTransform transform_;
  AlignedVector<Complex> symbol_;
};

Synthesis::Synthesis(Field kernel, Shape surface, Options options)
    : kernel_(std::move(kernel)), surface_(surface), options_(options) {
  if (surface.nx < 1 || surface.ny < 1) throw ParameterError("shape", "a surface has at least 1x1 points");
  const SynthesisCost cost = synthesis_cost(shape_of(kernel_), surface);
  if (options_.summation == Summation::cheapest)
    options_.summation = cost.direct <= cost.transform ? Summation::direct : Summation::transform;
  if (options_.summation == Summation::direct)
    strips_ = std::make_unique<Strips::Direct>(kernel_, surface);
  else
    strips_ = std::make_unique<Strips::Transform>(kernel_, surface);
}

Synthesis::~Synthesis() = default;
Synthesis::Synthesis(Synthesis&&) noexcept = default;

void Synthesis::noise_row(WhiteNoise& noise, Index i, std::span<double> out) const {
  if (!options_.periodic) return noise.row(i, out);
  const std::size_t period = size(surface_.ny), drawn = std::min(period, out.size());
  noise.row(i % surface_.nx, out.first(drawn));
  for (std::size_t j = drawn; j < out.size(); ++j) out[j] = out[j - period];
}

Field Synthesis::surface(const WhiteNoise& noise) const {
  Field heights(surface_.nx, surface_.ny);
  const Index good = strips_->good_rows(), columns = surface_.ny + kernel_.cols() - 1;
  const Index strips = (surface_.nx + good - 1) / good;
  parallel_ranges(strips, options_.threads, [&](Index begin, Index end, int) {
    WhiteNoise source(noise);
    const auto worker = strips_->worker();
    Field rows = Field::Zero(strips_->noise_rows(), columns);
    for (Index s = begin; s < end; ++s) {
      const Index first = s * good, count = std::min(good, surface_.nx - first);
      for (Index i = 0; i < count + kernel_.rows() - 1; ++i)
        noise_row(source, first + i, {&rows(i, 0), size(columns)});
      rows.bottomRows(good - count).setZero();  // of an earlier strip
      worker->filter(rows, heights.middleRows(first, count));
    }
  });
  return heights;
}

Field Synthesis::noise_below(const WhiteNoise& noise) const {
  const Index middle_x = (kernel_.rows() - 1) / 2, middle_y = (kernel_.cols() - 1) / 2;
  Field below(surface_.nx, surface_.ny);
  WhiteNoise source(noise);
  Field row(1, surface_.ny + kernel_.cols() - 1);
  for (Index i = 0; i < surface_.nx; ++i) {
    noise_row(source, i + middle_x, {row.data(), size(row.size())});
    below.row(i) = row.row(0).segment(middle_y, surface_.ny);
  }
  return below;
}

SynthesisCost synthesis_cost(Shape kernel, Shape surface) {
  const Shape torus = strip_torus(kernel, surface);
  const Index good = torus.nx - kernel.nx + 1, strips = (surface.nx + good - 1) / good;
  const double points = static_cast<double>(torus.cells());
  return {static_cast<double>(surface.cells()) * static_cast<double>(kernel.cells()) * seconds_per_product,
          static_cast<double>(strips) * 2 * points * std::log2(points + 1) * seconds_per_butterfly};
}

void centre_and_scale(Field& heights, double rms) {
  heights -= heights.mean();
  const double present = std::sqrt(heights.square().mean());
  if (!(present > 0)) throw ParameterError("exact-rq", "all heights are equal and cannot be scaled");
  heights *= rms / present;
}

}  // namespace asperity
