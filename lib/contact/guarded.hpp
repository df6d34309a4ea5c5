/// Guarded conjugate gradients: the contact problem on the cells of one operator.
///
///     p ← clip and rescale the start,  g ← h + K p;  under a given approach, the multiple of least energy
///     until ε ≤ tolerance:
///       face step     F ← free cells and cells that want off their bound            contact/face.hpp
///                     minimise on F by preconditioned conjugate gradients
///                     within bounds: take it.  Otherwise clip, rescale, and take it if the energy falls
///                     as it should (guarded step); if not, go along it to the lowest point and
///       gradient step p ← p + λ (Proj(p - α (g - δ)) - p),  λ = min(1, -(g-δ)·d / d·Kd)
///                     a few times; also when ε has not halved in four rounds, or |F| < 2
///
/// Cells leave a bound all at once when a face is built, or in a gradient step; they join one only in a
/// guarded or a gradient step, and then exactly. Every iterate is feasible and the energy falls, so that the
/// sets cannot cycle. The residual on a face is not driven to zero: while no bound is violated the conjugate
/// gradients go on, and once it has fallen to a quarter they stop at the first violation; they stop too where it
/// has grown a thousandfold, for at round-off directions are noise that adds up.
///
/// Accuracy  g follows p by recurrence, fresh after 50 updates; contact/windowed.hpp confirms ε.
/// Cost      one application of K a step, one of M a conjugate gradient step, a few passes over the cells; six
///           fields and a mask.
///
/// E. G. Birgin, J. M. Martínez, M. Raydan, Nonmonotone spectral projected gradient methods on convex sets,
/// SIAM J. Optim. 10 (2000) 1196-1211; J. J. Moré, G. Toraldo, On the solution of large quadratic programming
/// problems with bound constraints, SIAM J. Optim. 1 (1991) 93-113.
#pragma once

#include <functional>

#include "contact/elastic_operator.hpp"
#include "contact/face.hpp"
#include "contact/problem.hpp"

namespace asperity {

/// An operator that counts what is asked of it.
class CountedOperator final : public ElasticOperator {
 public:
  explicit CountedOperator(ElasticOperator& counted) : counted_(counted) {}

  Shape shape() const override { return counted_.shape(); }
  void apply(const Field& p, Field& u) override { ++convolutions, counted_.apply(p, u); }
  void precondition(const Field& r, Field& z) override { ++preconditionings, counted_.precondition(r, z); }
  double self_influence() const override { return counted_.self_influence(); }
  std::unique_ptr<ElasticOperator> coarsened() const override { return counted_.coarsened(); }

  int convolutions = 0, preconditionings = 0;

 private:
  ElasticOperator& counted_;
};

inline constexpr double round_off_floor = 1e-11;  ///< of ε: below it gains may end
enum class ContactStop { converged, convolution_limit, round_off };

class GuardedGradients {
 public:
  struct Limits {
    double tolerance = 1e-6;  ///< of ε
    double convolutions = 1000;
  };
  using Observer = std::function<void(const ContactResidual&, const CountedOperator&)>;

  /// Shifts the problem's datum where round-off demands it.
  GuardedGradients(ElasticOperator& influence, ContactProblem& problem, Limits limits);

  /// Solves from p and g = h + K p; an empty g is made. `near` says that p is nearly the solution.
  ContactStop solve(Field p, Field g, bool near, const Observer& observe = {});

  /// The solution, to be read or moved away. Where g is not fresh it comes from recurrences.
  Field& pressure() { return p_; }
  Field& gap() { return g_; }  ///< h + K p
  bool gap_is_fresh() const { return updates_ == 0; }
  const ContactResidual& residual() const { return residual_; }
  const CountedOperator& work() const { return influence_; }

 private:
  void begin(Field p, Field g);
  void scale_start();
  void look();
  bool finished();
  bool stalled();
  void refresh();
  void begin_gradient_steps(int count);
  void gradient_step();
  void face_step();
  void take_minimum();
  void guarded_step();
  void minimise_on_face();
  /// d = trial - p, q = K d; returns the slope (g - δ)·d and the curvature d·q of the energy along d.
  Eigen::Array2d look_towards_trial();
  /// p += λ d, g += λ q, 0 ≤ λ ≤ 1; the trial itself for λ = 1.
  void move(double lambda);

  CountedOperator influence_;
  ContactProblem& problem_;
  Limits limits_;
  Field p_, g_;
  Trial trial_;
  Face face_;
  FaceGradients face_gradients_;
  ContactResidual residual_;
  ContactStop stop_ = ContactStop::converged;
  int gradient_steps_left_ = 0, gradient_steps_ = 0, updates_ = 0;
  double alpha_ = 0;  // step of the projected gradient [Pa/m]
  double halved_from_ = 0, best_ = 0;
  int rounds_without_half_ = 0, rounds_without_gain_ = 0;
};

}  // namespace asperity
