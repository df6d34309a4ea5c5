/// One wave of plastic strain in the layers of an elastic half-space: the stress that it leaves.
///
/// A plastic strain ε, traceless and uniform in depth within each layer, varies along the surface as
/// exp(iq·x). In the frame (q, across, z) it loads the half-space like the stress T = 2με. The in-plane
/// state
///     Y = (i μq u1, μq u3, i σ13, σ33)    obeys    dY/dz = q (A Y + B T),   T = (T11, T33, i T13),     (1)
///         ⎛  0   1   1   0 ⎞        ⎛  0   0   1 ⎞
///     A = ⎜ -ℓ   0   0   m ⎟    B = ⎜  0   m   0 ⎟    ℓ = ν/(1-ν)   m = (1-2ν)/(2-2ν)   E = 2/(1-ν),     (2)
///         ⎜  E   0   0   ℓ ⎟        ⎜ -1   ℓ   0 ⎟
///         ⎝  0   0  -1   0 ⎠        ⎝  0   0   0 ⎠
/// from equilibrium and Hooke's law. A has the eigenvalues -1 and +1, each with a Jordan block of two:
///     (A ± 1) v1 = 0,  (A ± 1) v2 = v1,   v1 = (1, ±1, ∓2, -2),  v2 = (0, 3-4ν, -2(1-2ν), ∓4(1-ν)).     (3)
/// A wave is thus the sum of a part that fades downwards and one that fades upwards, two amplitudes a1, a2
/// each. Over a layer of η = q times its thickness, with the sources g = V⁻¹B T, the part that fades from its
/// start on is, at its end and on average,
///     a2 → e a2 + (1-e) g2,        a1 → e (a1 + η a2) + (1-e) g1 + η(φ-e) g2,      e = exp(-η),
///     ā2 = φ a2 + (1-φ) g2,        ā1 = φ a1 + (φ-e) a2 + (1-φ) g1 + (1-2φ+e) g2,  φ = (1-e)/η,          (4)
/// downwards; upwards g and the signs of η change. One sweep up from the bottom, below which nothing flows,
/// gives the one part; no traction at z = 0 reflects it into the other, which a sweep down gives. The
/// anti-plane state (i μq u2, i σ23) has one amplitude each way. Nothing grows in either sweep, so layers may
/// be as thick and as many as one likes. Then
///     σ11 - σ22 = 2 iμq u1 - (T11 - T22),   σ12 = iμq u2 - T12,
///     3 σ_m = (E + 2ℓ) iμq u1 + (1 + 2ℓ) (σ33 + T33).                                                    (5)
/// A uniform strain, q = 0, leaves σ = ℓ T33 - Tij in the plane and nothing else: the body is held laterally.
///
/// The response is real if xz and yz are multiplied by i first, and the stresses xz and yz by -i afterwards.
/// In the scalar product Σ h a:b over layers of thickness h it is symmetric, and -S/2μ lies in [0, 1].
///
/// Symbols   q wave number [1/m]   u displacement [m]   ε plastic strain   σ stress [Pa]   μ shear modulus
///           [Pa] ν Poisson's ratio, up to ½   h thickness of a layer [m]
/// Accuracy  ε/η of the strain, round-off: 1e-13. Exact for strains uniform in each layer.
/// Cost      two exponentials and some 250 operations a wave and layer.
///
/// C. Jacq, D. Nélias, G. Lormand, D. Girodin, Development of a three-dimensional semi-analytical
/// elastic-plastic contact code, J. Tribology 124 (2002) 653-667, solve (1) by influence coefficients of
/// cuboids; L. Frérot, M. Bonnet, J.-F. Molinari, G. Anciaux, A Fourier-accelerated volume integral method
/// for elastoplastic contact, Comput. Methods Appl. Mech. Eng. 351 (2019) 951-976, of a periodic half-space.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "plastic/deviator.hpp"
#include "transform/plan.hpp"

namespace asperity {

class LayerWaves {
 public:
  static constexpr Index lanes = 32;  ///< waves at a time
  using Lanes = Eigen::Array<double, lanes, 1>;

  LayerWaves(std::vector<double> thickness, double poisson);
  Index layers() const { return static_cast<Index>(thickness_.size()); }

  /// What depends on the waves alone, and work space.
  struct Work {
    explicit Work(Index layers);
    Lanes& of(Index layer, Index component) { return x[size(layer * deviator::components + component)]; }

    std::vector<Lanes> x;  ///< strain, then stress over 2μ, in the basis of plastic/deviator.hpp: [layer][5]
    std::vector<Lanes> mean;  ///< mean stress over 2μ: [layer]

   private:
    friend class LayerWaves;
    std::vector<Lanes> e_, phi_, eta_, up_;
    Lanes cos_, sin_, cos2_, sin2_;
    Index uniform_ = -1;  ///< the lane of q = 0
    std::vector<double> uniform_strain_;
  };
  /// For the waves of these wave numbers [1/m].
  void prepare(const Lanes& qx, const Lanes& qy, Work& work) const;
  /// Stress from strain, xz and yz multiplied by i; with its mean where that is wanted.
  void respond(Work& work, bool with_mean) const;

  /// Where in a spectrum the waves are, `count` lanes of them.
  struct Places {
    std::array<Index, lanes> at{};
    Index count = 0;
  };
  /// All of it on spectra, spectrum(layer, component) being a pointer to points of one: transforms of
  /// strains, of which it makes those of stresses over 2μ times `factor`, component 5 being the mean.
  /// add(part) may change the stress in `work` before it is stored, part 0 being the real, 1 the imaginary
  /// one.
  template <class Spectrum, class Add>
  void respond(Work& work, const Places& places, const Lanes& factor, bool with_mean, Spectrum spectrum,
               Add add) const {
    for (int part = 0; part < 2; ++part) {
      for (Index k = 0; k < layers(); ++k)
        for (Index c = 0; c < deviator::components; ++c) load(part, c, places, spectrum(k, c), work.of(k, c));
      respond(work, with_mean);
      for (Index k = 0; k < layers(); ++k) {
        for (Index c = 0; c < deviator::components; ++c) work.of(k, c) *= factor;
        work.mean[size(k)] *= factor;
      }
      add(part);
      for (Index k = 0; k < layers(); ++k)
        for (Index c = 0; c < deviator::components + (with_mean ? 1 : 0); ++c)
          store(part, c, places, c < deviator::components ? work.of(k, c) : work.mean[size(k)],
                spectrum(k, c));
    }
  }
  /// The part of a component in its lanes, xz and yz multiplied by i.
  static void load(int part, Index c, const Places& places, const Complex* spectrum, Lanes& x) {
    const auto [own, sign] = turned(part, c);
    const auto* numbers = reinterpret_cast<const double*>(spectrum);
    for (Index l = 0; l < lanes; ++l) x[l] = sign * numbers[2 * places.at[size(l)] + own];
  }

 private:
  static std::pair<int, double> turned(int part, Index c) {
    if (c != 3 && c != 4) return {part, 1};
    return {1 - part, part == 0 ? -1 : 1};
  }
  /// Back, multiplied by -i.
  static void store(int part, Index c, const Places& places, const Lanes& x, Complex* spectrum) {
    const auto [own, sign] = turned(part, c);
    auto* numbers = reinterpret_cast<double*>(spectrum);
    for (Index l = 0; l < places.count; ++l) numbers[2 * places.at[size(l)] + own] = sign * x[l];
  }
  void to_frame(Work& work, Index k) const;
  void sweep_up(Work& work, std::array<Lanes, 3>& at_surface) const;
  void sweep_down(Work& work, const std::array<Lanes, 3>& at_surface, bool with_mean) const;
  void set_uniform(Work& work) const;

  std::vector<double> thickness_;
  double l_;                             ///< ℓ
  double e_;                             ///< E
  Eigen::Matrix<double, 4, 4> states_;   ///< columns v1, v2 fading downwards, then upwards
  Eigen::Matrix<double, 4, 3> sources_;  ///< g from (d0, d1, i d3) in the frame
  Eigen::Matrix2d reflection_;           ///< amplitudes down from those up, at z = 0
};

}  // namespace asperity
