#include "stress/images.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"
#include "math/gauss_legendre.hpp"
#include "stress/corner.hpp"
#include "stress/kernel_columns.hpp"

namespace asperity {
namespace {

using stress::Component;
using stress::Traction;

constexpr double pi = std::numbers::pi;
constexpr double flat = 1, fall = image_periods - flat;  // of w [periods]
constexpr double endless = 1e20;                         // a coordinate in cells, beyond round-off of any

// The integral of exp(β (√(1-u²) - 1)) over panels of [-1, 1].
class Slope {
 public:
  Slope() {
    for (std::size_t k = 0; k < panels; ++k) below_[k + 1] = below_[k] + part(at(k), at(k + 1));
  }
  double share(double u) const {
    const auto k = std::min(static_cast<std::size_t>((u + 1) / 2 * panels), panels - 1);
    return (below_[k] + part(at(k), u)) / below_[panels];
  }

 private:
  static constexpr std::size_t panels = 64;
  static double at(std::size_t k) { return 2 * static_cast<double>(k) / panels - 1; }
  static double part(double from, double to) {
    const double beta = pi * fall, half = (to - from) / 2, middle = (to + from) / 2;
    double sum = 0;
    for (std::size_t i = 0; i < gauss8.nodes.size(); ++i) {
      const double u = middle + half * gauss8.nodes[i];
      sum += gauss8.weights[i] * std::exp(beta * (std::sqrt(1 - u * u) - 1));
    }
    return half * sum;
  }
  std::array<double, panels + 1> below_{};
};

// The problem with x and y exchanged, where y is the periodic axis: x is in here.
Traction exchanged(Traction t) {
  return t == stress::normal ? t : t == stress::shear_x ? stress::shear_y : stress::shear_x;
}

// Kernels of all components in real space, summed over the images along their first axis.
class ImageSum {
 public:
  // Lags along the periodic axis and across.
  ImageSum(Index period, Index across, double along_step, double across_step, std::vector<double> taper,
           double poisson)
      : period_(period),
        across_(across),
        unit_(along_step),
        height_(across_step / along_step),
        taper_(std::move(taper)),
        poisson_(poisson) {
    for (Index i = 0; i < image_periods * period_; ++i)
      weights_.push_back(image_weight(static_cast<double>(i) / static_cast<double>(period_)));
  }

  Index lags() const { return period_ / 2 + 1; }
  const Field& kernel(Traction t, Component c) const { return parts_[t][c].sum; }

  void compute(double z, const std::array<stress::Set, 3>& asked) {
    for (Traction t : stress::tractions)
      for (Component c : stress::components) {
        parts_[t][c].tile.resize(asked[t][c] ? size(block_columns * across_) : 0);
        parts_[t][c].sum = asked[t][c] ? Field(Field::Zero(lags(), across_)) : Field();
      }
    for (Index first = 0; first < image_periods * period_; first += block_columns) {
      evaluate(static_cast<double>(first) + 0.5, z);
      each([&](Part& part, Traction t, Component c) {
        for (Index l = 0; l < std::min(block_columns, image_periods * period_ - first); ++l)
          add(part, first + l, row_of(part, l, odd_in_y(c, t)), odd_in_x(c, t));
      });
    }
    evaluate(endless, z);
    each([&](Part& part, Traction t, Component c) {
      if (!odd_in_x(c, t)) set_mean(part.sum, 2 * row_of(part, 0, odd_in_y(c, t)));
    });
  }

 private:
  using Row = Eigen::Array<double, 1, Eigen::Dynamic>;
  struct Part {
    AlignedVector<double> tile;  // corner functions of eight rows, [j][8]
    Row before;                  // the row before, half a cell away
    Field sum;
  };

  template <class Visit>
  void each(Visit visit) {
    for (Traction t : stress::tractions)
      for (Component c : stress::components)
        if (!parts_[t][c].tile.empty()) visit(parts_[t][c], t, c);
  }

  void evaluate(double first, double z) {
    double* out[3][6];
    for (Traction t : stress::tractions)
      for (Component c : stress::components)
        out[t][c] = parts_[t][c].tile.empty() ? nullptr : parts_[t][c].tile.data();
    corner_tile(first, height_, across_, z / unit_, poisson_, out);
  }

  // Row l of a tile, as differences across: f(-½) is -f(½) of an even kernel, f(½) of an odd one.
  Row row_of(const Part& part, Index l, bool odd) const {
    Row out(across_);
    double before = (odd ? 1 : -1) * part.tile[size(l)];
    for (Index j = 0; j < across_; ++j) {
      const double f = part.tile[size(j * block_columns + l)];
      out(j) = taper_[size(j)] * (f - before) / (2 * pi);
      before = f;
    }
    return out;
  }

  // The kernel at lag i, the difference along, to its places within half a period.
  void add(Part& part, Index i, const Row& f, bool odd) const {
    if (i == 0) part.before = (odd ? 1 : -1) * f;
    const Row kernel = weights_[size(i)] * (f - part.before);
    part.before = f;
    const Index ahead = i % period_, back = (period_ - ahead) % period_;
    if (ahead < lags()) part.sum.row(ahead) += kernel;
    if (i > 0 && back < lags()) part.sum.row(back) += (odd ? -1 : 1) * kernel;
  }

  // (2) of an even kernel.
  void set_mean(Field& sum, const Row& strip) const {
    Row total = sum.row(0);
    for (Index i = 1; i < lags(); ++i) total += (2 * i == period_ ? 1 : 2) * sum.row(i);
    const Row missing = (strip - total) / static_cast<double>(period_);
    sum.rowwise() += missing;
  }

  Index period_, across_;
  double unit_, height_;
  std::vector<double> taper_, weights_;
  double poisson_;
  std::array<std::array<Part, 6>, 3> parts_;
};

class ImageInfluence final : public LayerInfluence {
 public:
  ImageInfluence(const Resolution& r, double poisson, stress::Tractions acting, int threads)
      : in_x_(r.cells.periodic.x),
        lags_(r.cells.shape),
        acting_(acting),
        sum_(in_x_ ? ImageSum(r.transform.torus().nx, lags_.ny, r.cells.dx, r.cells.dy, r.taper[1], poisson)
                   : ImageSum(r.transform.torus().ny, lags_.nx, r.cells.dy, r.cells.dx, r.taper[0], poisson)),
        transforms_(r, acting, threads),
        columns_(r.transform.blocks(), acting, r.transform.slabs().ranks()) {}

  void set_depth(double z, stress::Set asked, Index) override {
    std::array<stress::Set, 3> wanted{};
    for (Traction t : stress::tractions)
      for (Component c : stress::components)
        if (acting_[t] && asked[c]) wanted[in_x_ ? t : exchanged(t)].set(in_x_ ? c : stress::exchanged(c));
    sum_.compute(z, wanted);
  }

  void set_component(Component c, KernelRoom room) override {
    c_ = c;
    columns_.settle(lags_.nx, room);
    const Extent own = columns_.own_lags();
    for (Traction t : stress::tractions)
      if (acting_[t])
        parallel_ranges((own.count + block_columns - 1) / block_columns, transforms_.threads(),
                        [&](Index begin, Index end, int worker) {
                          for (Index k = begin; k < end; ++k)
                            put_rows(t, own.first + k * block_columns, worker);
                        });
    columns_.complete(transforms_.threads());
  }

  TransferFunction transfer_function(Traction t, Index b, int worker) override {
    return transforms_.of_columns(c_, t, columns_.block(t, b), worker);
  }

  std::span<const double> by_lags(Traction t, Index b, int) override {
    return {columns_.block(t, b), size(lags_.nx * block_columns)};
  }

 private:
  // Eight of them.
  void put_rows(Traction t, Index first, int worker) {
    const Field& kernel = in_x_ ? sum_.kernel(t, c_) : sum_.kernel(exchanged(t), stress::exchanged(c_));
    const Index count = std::min(block_columns, lags_.nx - first);
    double* rows = transforms_.room(worker);
    for (Index j = 0; j < lags_.ny; ++j)
      for (Index l = 0; l < block_columns; ++l)
        rows[j * block_columns + l] = l >= count ? 0 : in_x_ ? kernel(first + l, j) : kernel(j, first + l);
    transforms_.put_rows(c_, t, rows, 1, transforms_.period().ny / 2 + 1, first, count, columns_, worker);
  }

  bool in_x_;
  Shape lags_;
  stress::Tractions acting_;
  Component c_ = stress::xx;
  ImageSum sum_;
  KernelTransforms transforms_;
  KernelColumns columns_;
};

}  // namespace

double image_weight(double periods) {
  static const Slope slope;
  const double distance = std::abs(periods);
  if (distance <= flat) return 1;
  return distance < image_periods ? 1 - slope.share(2 * (distance - flat) / fall - 1) : 0;
}

std::unique_ptr<LayerInfluence> make_image_influence(const Resolution& resolution, double poisson,
                                                     stress::Tractions acting, int threads) {
  return std::make_unique<ImageInfluence>(resolution, poisson, acting, threads);
}

}  // namespace asperity
