// The rows of layers in a vertical plane x = x_i, without the layers around them.
//
// Transformed along y, and only along y, a component's row in the plane is a sum over the lags m in x,
//     σ^(ky) = Σ_t w_t (-i)^[K_t odd in y] Σ_{m≥0} K_t(m, ky) P±(m, ky),                                  (1)
//     P±(m) = p^(x_i - mΔx) ± p^(x_i + mΔx),   P+(0) = p^(x_i),  P-(0) = 0,                               (2)
// + for a kernel even in x, - for one odd in x. A kernel is the difference of the corner functions on both
// sides of a cell, K(m) = t(m) (f(m) - f(m-1)) with the taper t; that passes to the pressure, once for all:
//     Σ_m K(m) P±(m) = Σ_m f(m) D±(m),
//     D±(m) = t(m) P±(m) - t(m+1) P±(m+1),   D+(0) = 2 P+(0) - t(1) P+(1).                           (3)
// No layer is transformed in x, and there are only as many lags as the plane is away from the farthest load.
//
// In a periodic half-space the sum is over the modes kx ≥ 0, with Q(kx) = p^(kx, ky) exp(i kx x_i) for p^(x),
// D+(k) = Q(k) + Q(-k), D-(k) = -i (Q(k) - Q(-k)).
//
// A plane y = y_j is the plane x = x_j of the problem with x and y exchanged, σxx ↔ σyy, α → π/2 - α.
//
// Symbols   p^  pressure of a row, transformed along y     w_t, K_t  weight of a traction, its kernel
//           f  corner function (stress/layer_influence.hpp), transformed along y
// Cost      to prepare, that of one layer of one component. Memory: 4 (lags) Py doubles.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"
#include "stress/layer_plan.hpp"

namespace asperity {
namespace {

using stress::Component;

LoadedBody exchanged(const LoadedBody& body) {
  const Grid& g = body.grid;
  const Friction& f = body.friction;
  return {{{g.shape.ny, g.shape.nx}, g.dy, g.dx, {g.periodic.y, g.periodic.x}},
          transposed(body.pressure, body.rows()),
          body.poisson,
          {f.coefficient, 0.5 * std::numbers::pi - f.angle},
          body.ranks};
}

// From row i to the farthest one that is loaded.
Index farthest_lag(const LoadedBody& body, Index i) {
  const Extent own = body.rows().own();
  Index lags = 0;
  for (Index row = 0; row < own.count; ++row)
    if ((body.pressure.row(row) != 0).any()) lags = std::max(lags, std::abs(own.first + row - i) + 1);
  return static_cast<Index>(largest(*body.ranks, static_cast<double>(lags)));
}

// exp(i kx x_i) for every mode; what the modes are prepared with for an interpolation in x is undone, as the
// row between the points is computed itself.
AlignedVector<Complex> phases(const Resolution& r, Index i) {
  const Index n = r.transform.torus().nx, period = n * r.s;
  const double angle = 2 * std::numbers::pi / static_cast<double>(period);
  AlignedVector<Complex> out(size(n));
  for (Index k = 0; k < n; ++k) {
    const Index mode = 2 * k < n ? k : k - n;
    const double prepared = r.s == 1 || 2 * k == n
                                ? 1
                                : Interpolation::prepared(angle * static_cast<double>(r.s * std::abs(mode)));
    out[size(k)] = std::polar(1 / prepared, angle * static_cast<double>(mode * i % period));
  }
  return out;
}

// The pressure as it is seen from the plane: D± of (3).
struct SectionPlan : LayerPlan {
  const bool exchanges;  // x and y, of the rows that are handed over
  Index lag_count = 0;

  // Of the plane x = x_i.
  SectionPlan(const LoadedBody& body, Index i, bool exchange, Index s, int threads)
      : LayerPlan(body, s, threads), exchanges(exchange) {
    const PrunedTransform& t = resolution.transform;
    const Index px = t.torus().nx;
    lag_count = body.grid.periodic.both()           ? px / 2 + 1
                : s > 1 || body.grid.periodic.any() ? resolution.cells.shape.nx
                                                    : farthest_lag(body, i);
    for (Folded& folded : folded_) folded.resize(size(t.own_blocks().count * lag_count * 2 * block_columns));
    fold(phases(resolution, i), threads);
  }

  std::unique_ptr<LayerWork> work(int threads) const override;

  // sum[0 … 7] += Re, sum[8 … 15] += Im of Σ_m f(m, ky) D±(m, ky) for the columns 8b … 8b+7, f as [m][8].
  void add(std::span<const double> f, bool odd, Index b, std::span<double, 2 * block_columns> sum) const {
    using Lanes = Eigen::Array<double, block_columns, 1>;
    using Given = Eigen::Map<const Lanes>;
    Eigen::Map<Lanes> to_re(sum.data()), to_im(sum.data() + block_columns);
    Lanes re = to_re, im = to_im;
    const double *value_at = f.data(), *d = folded_[odd].data() + place(b);
    for (Index m = 0; m < lag_count; ++m, value_at += block_columns, d += 2 * block_columns) {
      const Lanes value = Given(value_at);
      re += value * Given(d), im += value * Given(d + block_columns);
    }
    to_re = re, to_im = im;
  }

 private:
  using Folded = AlignedVector<double>;  // [block][m][re, im][8]

  // From the modes kx of p^ times exp(i kx x_i), a block of 8 columns after the other.
  void fold(const AlignedVector<Complex>& phases, int threads) {
    const PrunedTransform& t = resolution.transform;
    const Index px = t.torus().nx, stride = t.stride();
    const ColumnTransform columns(px, block_columns, Ways::forward_only);
    const Extent own = t.own_blocks();
    parallel_ranges(own.count, threads, [&](Index begin, Index end, int) {
      AlignedVector<Complex> modes(size(t.block_size())), lags(modes.size());
      for (Index b = own.first + begin; b < own.first + end; ++b) {
        for (Index q = 0; q < block_columns; ++q)
          for (Index k = 0; k < px; ++k)
            modes[size(q * stride + k)] = resolution.pressure(b)[q * stride + k] * phases[size(k)];
        if (resolution.cells.periodic.both()) {
          fold_ends(modes, true, b);
        } else {
          columns.forward(modes.data(), lags.data());
          resolution.cells.periodic.any() ? fold_ends(lags, false, b) : fold_lags(lags, b);
        }
      }
    });
  }

  // D± of the modes; or P± of the lags, for kernels that are differences already (stress/images.hpp).
  void fold_ends(std::span<const Complex> block, bool modes, Index b) {
    const Index n = resolution.transform.torus().nx;
    for (Index q = 0; q < block_columns; ++q) {
      const auto values = block.subspan(size(q * resolution.transform.stride()));
      for (Index m = 0; m < lag_count; ++m) {
        const bool alone = m == 0 || 2 * m == n;
        const Complex ahead = values[size(m)], back = alone ? Complex{} : values[size(n - m)],
                      difference = alone ? Complex{} : ahead - back;
        set(false, b, m, q, ahead + back);
        set(true, b, m, q, alone || !modes ? difference : Complex{difference.imag(), -difference.real()});
      }
    }
  }

  void fold_lags(std::span<const Complex> block, Index b) {
    const Index n = resolution.transform.torus().nx;
    const std::vector<double>& taper = resolution.taper[0];
    for (Index q = 0; q < block_columns; ++q) {
      const auto lags = block.subspan(size(q * resolution.transform.stride()));
      for (double sign : {1.0, -1.0}) {
        auto seen = [&](Index m) {
          return m < lag_count ? taper[size(m)] * (lags[size(m)] + sign * lags[size(n - m)]) : Complex{};
        };
        for (Index m = 0; m < lag_count; ++m)
          set(sign < 0, b, m, q, (m > 0 ? seen(m) : (1 + sign) * lags[0]) - seen(m + 1));
      }
    }
  }

  Index place(Index b) const {
    return (b - resolution.transform.own_blocks().first) * lag_count * 2 * block_columns;
  }
  void set(bool odd, Index b, Index m, Index q, Complex value) {
    double* to = folded_[odd].data() + place(b) + m * 2 * block_columns + q;
    to[0] = value.real(), to[block_columns] = value.imag();
  }

  std::array<Folded, 2> folded_;  // even, odd
};

class SectionWork : public LayerWork {
 public:
  SectionWork(const SectionPlan& plan, int threads)
      : plan_(plan),
        threads_(threads),
        influence_(plan.influence(threads)),
        transform_(plan.resolution.transform.torus().ny),
        row_work_(transform_.work()),
        modes_(size(transform_.blocks() * 6 * block_columns)),
        own_modes_(size(own_blocks().count * 6 * block_columns)),
        samples_(size(6 * plan.resolution.row_length())) {}

  void layer(double z, stress::Set asked, const StressRowSink& row, const BehindRows&) override {
    asked_ = {};
    for (Component c : stress::components) asked_[c] = asked[own(c)];
    influence_->set_depth(z, asked_, plan_.lag_count);
    Index count = 0;
    for (Component c : stress::components)
      if (asked_[c]) compute_modes(c, count++);
    std::ranges::copy(gathered(plan_.rows.ranks(), own_modes_), modes_.begin());
    transform_.inverse(modes_.data(), 6 * block_columns, count, transform_.points(),
                       samples_.data() + Interpolation::before, plan_.resolution.row_length(), row_work_);
    StressRow values{};
    count = 0;
    for (Component c : stress::components)
      if (asked_[c]) values[own(c)] = {row_of(c, count++), size(plan_.shape.ny)};
    if (plan_.rows.ranks().rank() == 0) row(0, values);
  }

 private:
  // The component that c of the exchanged problem is in the one requested, and the other way round.
  Component own(Component c) const { return plan_.exchanges ? stress::exchanged(c) : c; }

  const double* row_of(Component c, Index r) {
    const Resolution& resolution = plan_.resolution;
    double* row = samples_.data() + r * resolution.row_length();
    if (resolution.s == 1) return row + Interpolation::before;
    resolution.wrap({row, size(resolution.row_length())});
    refined_[c].resize(size(resolution.interpolation.padded(plan_.shape.ny)));
    resolution.interpolation.refine(row, plan_.shape.ny, refined_[c].data());
    return refined_[c].data();
  }

  Extent own_blocks() const { return plan_.resolution.transform.own_blocks(); }

  // Row r of the modes: component c.
  void compute_modes(Component c, Index r) {
    influence_->set_component(c);
    parallel_ranges(own_blocks().count, threads_, [&](Index begin, Index end, int worker) {
      for (Index k = begin; k < end; ++k)
        add_modes(c, k, worker, own_modes_.data() + (6 * k + r) * block_columns);
    });
  }

  // Of the k-th own block.
  void add_modes(Component c, Index k, int worker, Complex* to) const {
    const LoadWeights& weights = plan_.weights;
    const Index b = own_blocks().first + k;
    std::fill_n(to, block_columns, Complex{});
    for (stress::Traction t : stress::tractions) {
      if (weights[t] == 0) continue;
      std::array<double, 2 * block_columns> sum{};
      plan_.add(influence_->by_lags(t, b, worker), odd_in_x(c, t), b, sum);
      const Complex factor = odd_in_y(c, t) ? Complex{0, -weights[t]} : Complex{weights[t], 0};
      for (std::size_t q = 0; q < block_columns; ++q)
        to[q] += factor * Complex{sum[q], sum[block_columns + q]};
    }
  }

  const SectionPlan& plan_;
  const int threads_;
  stress::Set asked_;  // of the exchanged problem
  std::unique_ptr<LayerInfluence> influence_;
  RowTransform transform_;
  RowTransform::Work row_work_;
  AlignedVector<Complex> modes_;  // of the row: [block][asked component][8]
  std::vector<Complex> own_modes_;
  AlignedVector<double> samples_;  // six rows
  std::array<AlignedVector<double>, 6> refined_;
};

std::unique_ptr<LayerWork> SectionPlan::work(int threads) const {
  return std::make_unique<SectionWork>(*this, threads);
}

}  // namespace

std::unique_ptr<const LayerPlan> plan_section(const LoadedBody& body, const Plane& plane, Index s,
                                              int threads) {
  return std::make_unique<SectionPlan>(plane.along_x ? exchanged(body) : body, plane.index, plane.along_x, s,
                                       threads);
}

}  // namespace asperity
