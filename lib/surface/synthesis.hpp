/// Surfaces as moving averages of white noise.
///
///     z(i,j) = Σ_{k<K} Σ_{l<L} kernel(k,l) η(i+k, j+l),    0 ≤ i < N, 0 ≤ j < M                         (1)
///
/// from noise of (N+K-1) × (M+L-1) values, or, on a periodic surface, of N × M values that repeat themselves,
/// however large the kernel. The autocorrelation of z is that of the kernel, or its periodic sum.
///
/// The sum is taken as it stands or by overlap–save: strips of P rows of noise, at most 8K, are transformed,
/// multiplied by the conjugate spectrum of the kernel and transformed back; P - K + 1 rows are good. Noise is
/// drawn strip by strip, so that memory beyond the surface itself is that of one strip a thread. Strips
/// depend on the request alone: the surface is the same on any number of threads, to the last bit.
///
/// Symbols   N × M  points of the surface   K × L  of the kernel   P × Q  of the torus of a strip
/// Accuracy  round-off: ε log2(P Q) Σ|kernel| max|η|.
/// Cost      direct: N M K L multiply-adds; by transform: two real transforms of P Q points a strip, with
///           Q ≥ M + L - 1. The cheaper one is taken. The noise costs 8 ns a value.
///
/// T. G. Stockham, High-speed convolution and correlation, AFIPS Spring Joint Computer Conf. 28 (1966)
/// 229-233.
#pragma once

#include "grid/field.hpp"
#include "surface/noise.hpp"

namespace asperity {

enum class Summation { cheapest, direct, transform };

class Synthesis {
 public:
  struct Options {
    bool periodic = false;
    Summation summation = Summation::cheapest;
    int threads = 1;
  };

  /// Throws ParameterError("shape") when the surface has no points.
  Synthesis(Field kernel, Shape surface, Options options);
  ~Synthesis();
  Synthesis(Synthesis&&) noexcept;

  /// The surface of this noise; may be called by several threads at once.
  Field surface(const WhiteNoise& noise) const;
  /// The noise under the surface: η(i + (K-1)/2, j + (L-1)/2), the value that the middle of the kernel
  /// multiplies.
  Field noise_below(const WhiteNoise& noise) const;

  Shape shape() const { return surface_; }
  Summation summation() const { return options_.summation; }  ///< the one taken

 private:
  class Strips;

  void noise_row(WhiteNoise& noise, Index i, std::span<double> out) const;

  Field kernel_;
  Shape surface_;
  Options options_;
  std::unique_ptr<const Strips> strips_;
};

/// Seconds that each way takes on one thread, by the model above.
struct SynthesisCost {
  double direct, transform;
};
SynthesisCost synthesis_cost(Shape kernel, Shape surface);

/// Subtracts the mean and scales to the root mean square `rms`. Throws ParameterError("exact-rq") when all
/// heights are equal.
void centre_and_scale(Field& heights, double rms);

}  // namespace asperity
