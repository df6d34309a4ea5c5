// A layer, one component after the other.
//
// A component's modes take twice the memory of its values, 2 N doubles, and there is room for those of one:
// a component that is wanted together with others is transformed back to N values at once, or N/s² where
// cells are s times as wide, and the last component's rows go from the modes to the caller. Kernels are
// stored where the modes will be (stress/kernel_columns.hpp).
#include <algorithm>

#include "core/memory.hpp"
#include "core/parallel.hpp"
#include "stress/layer_plan.hpp"

namespace asperity {
namespace {

using stress::Component;

using Transfer = std::array<LayerInfluence::TransferFunction, 3>;

constexpr Index before = Interpolation::before, taps = Interpolation::taps;
static_assert(block_columns == LayerInfluence::width && LayerWork::rows_at_a_time % RowTransform::rows == 0);

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
void respond(LayerInfluence& influence, const LayerPlan& plan, Component c, Index b, int worker,
             Complex* product) {
  Transfer transfer{};
  for (stress::Traction t : stress::tractions)
    if (plan.weights[t] != 0) transfer[t] = influence.transfer_function(t, b, worker);
  const PrunedTransform& transform = plan.resolution.transform;
  for (Index q = 0; q < block_columns; ++q)
    respond(transform.torus().nx, c, Column(transfer, plan.weights, c, q),
            plan.resolution.pressure(b) + q * transform.stride(), product + q * transform.stride());
}

class VolumeWork : public LayerWork {
 public:
  VolumeWork(const LayerPlan& plan, int threads)
      : plan_(plan),
        resolution_(plan.resolution),
        transform_(resolution_.transform),
        shape_(plan.shape),
        own_(plan.rows.own()),
        threads_(threads),
        influence_(plan.influence(threads)),
        half_(transform_.half_spectrum()),
        buffers_(size(threads), Buffers(*this)) {}

  void layer(double z, stress::Set asked, const StressRowSink& row, const BehindRows& behind) override {
    influence_->set_depth(z, asked);
    StressRow (VolumeWork::*row_at)(stress::Set, Index, Buffers&) const =
        wide() ? &VolumeWork::interpolated : &VolumeWork::inverted;
    for (Component c : stress::components)
      if (asked[c]) last_ = c;
    for (Component c : stress::components) {
      if (!asked[c]) continue;
      compute_modes(c);
      if (wide())
        invert_points(c);
      else if (c != last_)
        invert(c);
    }
    const bool shared = plan_.rows.shared() && behind;
    const Index longest = plan_.rows.longest(), part = shared ? rows_at_a_time : longest;
    for (Index begin = 0; begin < longest; begin += part) {
      const Index here = std::clamp<Index>(own_.count - begin, 0, part);
      by_groups(here, [&](Index from, Index count, Buffers& buffers) {
        for (Index i = begin + from; i < begin + from + count; ++i)
          row(own_.first + i, (this->*row_at)(asked, i, buffers));
      });
      if (shared) behind(begin);
    }
  }

 private:
  static constexpr Index group = RowTransform::rows;

  // Of one thread.
  struct Buffers {
    explicit Buffers(const VolumeWork& of)
        : row_work(of.transform_.row_work()),
          rows(size(group * (of.wide() ? of.resolution_.row_length() : of.shape_.ny))) {}

    RowTransform::Work row_work;
    AlignedVector<double> rows;                    ///< eight
    std::array<AlignedVector<double>, 6> refined;  ///< a row at every cell
  };

  bool wide() const { return resolution_.s > 1; }

  // visit(first, count, buffers) for groups of neighbouring rows.
  template <class Visit>
  void by_groups(Index rows, Visit visit) {
    parallel_ranges((rows + group - 1) / group, threads_, [&](Index begin, Index end, int worker) {
      for (Index first = begin * group; first < std::min(end * group, rows); first += group)
        visit(first, std::min(group, rows - first), buffers_[size(worker)]);
    });
  }

  void compute_modes(Component c) {
    const Index block = 2 * block_columns * transform_.slabs().own().count;
    influence_->set_component(c, {reinterpret_cast<double*>(half_.data()), block});
    transform_.compose(half_, threads_, [&](Index b, Complex* product, int worker) {
      respond(*influence_, plan_, c, b, worker, product);
    });
  }

  void invert(Component c) {
    Field& values = values_[c];
    if (values.size() == 0) values = large_field({own_.count, shape_.ny});
    by_groups(own_.count, [&](Index first, Index count, Buffers& buffers) {
      transform_.inverse_group(half_, first, count, shape_.ny, values.row(first).data(), shape_.ny,
                               buffers.row_work);
    });
  }

  // Of the last component eight rows are transformed back at a time.
  StressRow inverted(stress::Set asked, Index i, Buffers& buffers) const {
    const Index in_group = i % group;
    if (in_group == 0)
      transform_.inverse_group(half_, i, std::min(group, own_.count - i), shape_.ny, buffers.rows.data(),
                               shape_.ny, buffers.row_work);
    StressRow out{};
    for (Component c : stress::components)
      if (asked[c])
        out[c] = {c == last_ ? buffers.rows.data() + in_group * shape_.ny : values_[c].row(i).data(),
                  size(shape_.ny)};
    return out;
  }

  // The points of a wide layer around the cells, from `before` ahead of the first, in x and in y.
  void invert_points(Component c) {
    const auto [px, py] = transform_.torus();
    const Index stride = resolution_.row_length(), end = (shape_.nx - 1) / resolution_.s + taps - before,
                samples = std::min((shape_.ny - 1) / resolution_.s + 2 * taps, stride);
    const Extent here = transform_.slabs().own();
    Field points(here.count, samples);
    by_groups(here.count, [&, px = px, py = py](Index first, Index count, Buffers& buffers) {
      if (const Index i = here.first + first; i >= end && i + count <= px - before) return;  // not wanted
      double* rows = buffers.rows.data();
      transform_.inverse_group(half_, first, count, py, rows + before, stride, buffers.row_work);
      for (Index r = 0; r < count; ++r) {
        resolution_.wrap({rows + r * stride, size(stride)});
        std::copy_n(rows + r * stride, samples, points.row(first + r).data());
      }
    });
    values_[c] = rows_of(points, transform_.slabs(), wanted_points());
  }

  // Rows of points, from that which stands `before` ahead of the first own row's on.
  std::vector<Index> wanted_points() const {
    std::vector<Index> rows;
    const Index px = transform_.torus().nx;
    if (own_.count > 0)
      for (Index m = first_point(); m < (own_.end() - 1) / resolution_.s + taps; ++m)
        rows.push_back((m + px - before) % px);
    return rows;
  }
  Index first_point() const { return own_.first / resolution_.s; }

  StressRow interpolated(stress::Set asked, Index i, Buffers& buffers) const {
    const Index at = own_.first + i, m = at / resolution_.s - first_point();
    const double* weights = resolution_.interpolation.weights(at % resolution_.s);
    static_assert(taps == 8);
    StressRow out{};
    for (Component c : stress::components) {
      if (!asked[c]) continue;
      const Field& points = values_[c];
      auto row_at = [&](Index t) { return points.row(m + t); };
      Eigen::Map<Eigen::Array<double, 1, Eigen::Dynamic>>(buffers.rows.data(), points.cols()) =
          weights[0] * row_at(0) + weights[1] * row_at(1) + weights[2] * row_at(2) + weights[3] * row_at(3) +
          weights[4] * row_at(4) + weights[5] * row_at(5) + weights[6] * row_at(6) + weights[7] * row_at(7);
      buffers.refined[c].resize(size(resolution_.interpolation.padded(shape_.ny)));
      resolution_.interpolation.refine(buffers.rows.data(), shape_.ny, buffers.refined[c].data());
      out[c] = {buffers.refined[c].data(), size(shape_.ny)};
    }
    return out;
  }

  const LayerPlan& plan_;
  const Resolution& resolution_;
  const PrunedTransform& transform_;
  const Shape shape_;
  const Extent own_;  ///< rows
  const int threads_;
  std::unique_ptr<LayerInfluence> influence_;
  HalfSpectrum half_;  ///< of one component
  std::vector<Buffers> buffers_;
  std::array<Field, 6> values_;  ///< of each component but the last, or points of a wide layer
  Component last_ = stress::xx;
};

struct VolumePlan : LayerPlan {
  using LayerPlan::LayerPlan;
  std::unique_ptr<LayerWork> work(int threads) const override {
    return std::make_unique<VolumeWork>(*this, threads);
  }
};

}  // namespace

std::unique_ptr<const LayerPlan> plan_volume(const LoadedBody& body, Index s, int threads) {
  return std::make_unique<VolumePlan>(body, s, threads);
}

}  // namespace asperity
