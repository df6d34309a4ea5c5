/// Unit white noise, row by row.
///
/// η(i,j), independent with mean 0 and variance 1, for any row i (negative ones too) and j = 0, 1, …; normal,
/// or of another distribution by a translation of the normal values. Every row has a generator of its own,
/// started from
///     h(seed, c, row) = mix(mix(mix(seed + g) + c + g) + row + g),   c = 2³² stream + surface,           (1)
/// with g = 2⁶⁴/φ and mix one-to-one on 64 bits: a row is the same in any order of drawing and on
/// however many threads, and a longer row begins as a shorter one. For one seed, no two pairs (stream,
/// surface) and no two rows of a surface have the same hash.
///
/// The generator is GSL's taus2 (period 2⁸⁸), the normals come from its ziggurat. Among 10⁵ rows two would
/// probably have the same seed of GSL's 32 bits; here all 88 bits of the state are set from the hash.
///
/// Accuracy  Any two of n rows of L numbers, of whatever seeds, overlap with a chance of n²/2⁶⁵ + n²L/2⁸⁸:
///           3e-6 for ten thousand surfaces of a thousand rows.
/// Cost      about 8 ns a number.
///
/// P. L'Ecuyer, Tables of maximally equidistributed combined LFSR generators, Math. Comput. 68 (1999)
/// 261-269; G. Marsaglia, W. W. Tsang, The ziggurat method for generating random variables, J. Stat. Softw. 5
/// (2000) 8; G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number generators, OOPSLA (2014)
/// 453-472 for the hash.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "core/field.hpp"

namespace asperity {

/// A function of one number, applied to many in place by several threads at once: what a value becomes does
/// not depend on its neighbours.
using Pointwise = std::function<void(std::span<double>)>;

class WhiteNoise {
 public:
  /// `surface` counts the independent noises of an ensemble, `stream` the ensembles of one seed.
  /// `translation`, of mean 0 and variance 1, if there is one, makes each value from a normal one. Throws
  /// ParameterError("first") and ("stream") from 2³² on.
  explicit WhiteNoise(std::uint64_t seed, std::uint64_t surface = 0, std::uint64_t stream = 0,
                      Pointwise translation = {});
  WhiteNoise(const WhiteNoise&);
  WhiteNoise& operator=(const WhiteNoise&) = delete;

  /// η(index, 0), η(index, 1), … into all of `out`. Not for two threads at once; copies are cheap.
  void row(std::int64_t index, std::span<double> out);

  std::uint64_t seed() const { return seed_; }
  std::uint64_t surface() const { return surface_; }
  std::uint64_t stream() const { return stream_; }
  /// Names the generator and the method, for the record.
  static std::string generator();

 private:
  std::uint64_t seed_, surface_, stream_;
  Pointwise translation_;
  std::shared_ptr<void> taus2_;  ///< GSL's
};

}  // namespace asperity
