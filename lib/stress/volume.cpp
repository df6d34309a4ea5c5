#include <algorithm>

#include "stress/layer_plan.hpp"

namespace asperity {
namespace {

using stress::Component;

using Transfer = std::array<LayerInfluence::TransferFunction, 3>;

constexpr Index width = PrunedTransform::width, before = Interpolation::before;
static_assert(width == LayerInfluence::width);

// Between rows of eight.
Index apart(Index ny) { return (ny + width - 1) / width * width; }

// -i a z.
Complex times_minus_i(double a, const Complex& z) { return {a * z.imag(), -a * z.real()}; }

// S and T of a column ky. In -kx what is odd in x changes sign.
class Column {
 public:
  Column(const Transfer& transfer, const LoadWeights& weights, Component c, Index q)
      : weights_{1, odd_in_x(c) ? weights[1] : -weights[1], odd_in_y(c) ? weights[2] : -weights[2]} {
    for (stress::Traction t : stress::tractions)
      if (!transfer[t].pairs.empty())
        first_[t] =
            reinterpret_cast<const double*>(transfer[t].pairs.data() + q / 2 * transfer[t].stride) + q % 2;
  }

  bool friction() const { return first_[stress::shear_x] != nullptr || first_[stress::shear_y] != nullptr; }
  double pressed(Index k) const { return first_[stress::normal][2 * k]; }
  /// side: 1 in kx, -1 in -kx.
  double sheared(Index k, int side) const {
    double sum = 0;
    if (first_[stress::shear_x]) sum += side * weights_[stress::shear_x] * first_[stress::shear_x][2 * k];
    if (first_[stress::shear_y]) sum += weights_[stress::shear_y] * first_[stress::shear_y][2 * k];
    return sum;
  }

 private:
  std::array<const double*, 3> first_{};
  LoadWeights weights_;
};

void respond(Index nx, Component c, const Column& column, const Complex* p, Complex* out) {
  const bool imaginary = odd_in_x(c) != odd_in_y(c);
  const double ahead = odd_in_x(c) && odd_in_y(c) ? -1 : 1, back = odd_in_x(c) ? -ahead : ahead;
  auto each_mode = [&](auto response) {
    for (Index k = 0; k <= nx / 2; ++k) out[k] = response(k, 1, ahead, p[k]);
    for (Index k = nx / 2 + 1; k < nx; ++k) out[k] = response(nx - k, -1, back, p[k]);
  };
  auto S = [&](Index k, double factor) { return factor * column.pressed(k); };
  auto T = [&](Index k, int side, double factor) { return factor * column.sheared(k, side); };
  if (!column.friction() && !imaginary)
    each_mode([&](Index k, int, double f, const Complex& z) { return S(k, f) * z; });
  else if (!column.friction())
    each_mode([&](Index k, int, double f, const Complex& z) { return times_minus_i(S(k, f), z); });
  else if (!imaginary)
    each_mode([&](Index k, int side, double f, const Complex& z) {
      return S(k, f) * z - times_minus_i(T(k, side, f), z);
    });
  else
    each_mode([&](Index k, int side, double f, const Complex& z) {
      return times_minus_i(S(k, f), z) + T(k, side, f) * z;
    });
}

// The product of (1) in stress/layer_influence.hpp for block b.
//
// A traction μx p along x and μy p along y has the modes of the pressure itself, so that of each mode
//     σ^ = (-i)^m (S + iT) p^,   T = ±μx X ± μy Y,
// X and Y the transfer functions of the tractions, a factor i from S for the one parity in which they differ.
void respond(LayerInfluence& influence, const LayerPlan& plan, Component c, Index b, Complex* product) {
  Transfer transfer{};
  for (stress::Traction t : stress::tractions)
    if (plan.weights[t] != 0) transfer[t] = influence.transfer_function(t, c, b);
  const PrunedTransform& transform = plan.resolution.transform;
  for (Index q = 0; q < width; ++q)
    respond(transform.torus().nx, c, Column(transfer, plan.weights, c, q),
            plan.resolution.pressure(b) + q * transform.stride(), product + q * transform.stride());
}

class VolumeWork : public LayerWork {
 public:
  explicit VolumeWork(const LayerPlan& plan)
      : plan_(plan),
        resolution_(plan.resolution),
        transform_(resolution_.transform),
        shape_(plan.shape),
        influence_(plan.influence()),
        block_(size(transform_.block_size())),
        work_(block_.size()),
        row_work_(transform_.row_work()) {}

  void set_depth(double z, stress::Set asked) override {
    asked_ = asked;
    allocate();
    influence_->set_depth(z, asked);
    for (Index b = 0; b < transform_.blocks(); ++b)
      for (Component c : stress::components) {
        if (!asked[c]) continue;
        respond(*influence_, plan_, c, b, block_.data());
        transform_.inverse_block(block_.data(), b, half_[c], work_.data());
      }
    if (wide())
      for (Component c : stress::components)
        if (asked[c]) invert_points(c);
  }

  StressRow row(Index i) override {
    StressRow out{};
    for (Component c : stress::components)
      if (asked_[c]) out[c] = {wide() ? interpolated(c, i) : inverted(c, i), size(shape_.ny)};
    return out;
  }

 private:
  bool wide() const { return resolution_.s > 1; }

  void allocate() {
    const Index rows =
        wide() ? resolution_.interpolation.padded(shape_.ny) : RowTransform::rows * apart(shape_.ny);
    for (Component c : stress::components) {
      if (!asked_[c] || !half_[c].empty()) continue;
      half_[c] = transform_.half_spectrum();
      rows_[c].resize(size(rows));
      if (wide()) points_[c].resize(size(transform_.torus().nx * resolution_.row_length()));
    }
    if (wide()) across_.resize(size(resolution_.row_length()));
  }

  // Eight rows are transformed back at a time.
  const double* inverted(Component c, Index i) {
    const Index in_group = i % RowTransform::rows;
    if (in_group == 0)
      transform_.inverse_group(half_[c], i, std::min(RowTransform::rows, shape_.nx - i), shape_.ny,
                               rows_[c].data(), apart(shape_.ny), row_work_);
    return rows_[c].data() + in_group * apart(shape_.ny);
  }

  // The rows of a wide layer around the cells, from `before` ahead of the first.
  void invert_points(Component c) {
    const auto [px, py] = transform_.torus();
    const Index end = std::min((shape_.nx - 1) / resolution_.s + Interpolation::taps, px) - before;
    const Index stride = resolution_.row_length();
    auto invert = [&, py = py](Index first, Index count, double* to) {
      transform_.inverse_group(half_[c], first, count, py, to + before, stride, row_work_);
      for (Index r = 0; r < count; ++r) resolution_.wrap({to + r * stride, size(stride)});
    };
    invert(px - before, before, points_[c].data());
    for (Index i = 0; i < end; i += RowTransform::rows)
      invert(i, std::min(RowTransform::rows, end - i), points_[c].data() + (before + i) * stride);
  }

  const double* interpolated(Component c, Index i) {
    const double* weights = resolution_.interpolation.weights(i % resolution_.s);
    const Index px = transform_.torus().nx, m = i / resolution_.s, stride = resolution_.row_length();
    const Index samples = std::min((shape_.ny - 1) / resolution_.s + 2 * Interpolation::taps, stride);
    using Points = Eigen::Map<const Eigen::ArrayXd>;
    auto row_at = [&](Index t) { return Points(points_[c].data() + (m + t) % px * stride, samples); };
    static_assert(Interpolation::taps == 8);
    Eigen::Map<Eigen::ArrayXd>(across_.data(), samples) =
        weights[0] * row_at(0) + weights[1] * row_at(1) + weights[2] * row_at(2) + weights[3] * row_at(3) +
        weights[4] * row_at(4) + weights[5] * row_at(5) + weights[6] * row_at(6) + weights[7] * row_at(7);
    resolution_.interpolation.refine(across_.data(), shape_.ny, rows_[c].data());
    return rows_[c].data();
  }

  const LayerPlan& plan_;
  const Resolution& resolution_;
  const PrunedTransform& transform_;
  Shape shape_;
  stress::Set asked_;
  std::unique_ptr<LayerInfluence> influence_;
  AlignedVector<Complex> block_, work_;
  RowTransform::Work row_work_;
  std::array<HalfSpectrum, 6> half_;
  std::array<AlignedVector<double>, 6> points_;  ///< of a wide layer
  std::array<AlignedVector<double>, 6> rows_;    ///< eight rows, or one that is interpolated
  AlignedVector<double> across_;                 ///< a row interpolated in x alone
};

struct VolumePlan : LayerPlan {
  using LayerPlan::LayerPlan;
  std::unique_ptr<LayerWork> work() const override { return std::make_unique<VolumeWork>(*this); }
};

}  // namespace

std::unique_ptr<const LayerPlan> plan_volume(const LoadedBody& body, Index s, int threads) {
  return std::make_unique<VolumePlan>(body, s, threads);
}

}  // namespace asperity
