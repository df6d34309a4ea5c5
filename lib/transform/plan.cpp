#include "transform/plan.hpp"

#include <array>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>
#include <tuple>

#include <fftw3.h>

#include "core/memory.hpp"
#include "core/module.hpp"
#include "transform/single_columns.hpp"

namespace asperity {
namespace {

auto raw(double* p) { return reinterpret_cast<fftw_complex*>(p); }
auto raw(Complex* p) { return reinterpret_cast<fftw_complex*>(p); }
template <class Real>
Real* reals(std::complex<Real>* p) {
  return reinterpret_cast<Real*>(p);
}
auto get(const Plan& p) { return static_cast<fftw_plan>(p.get()); }

// Transforms of columns in each precision; single precision is loaded when it is needed.
template <class Real>
struct Columns;
template <>
struct Columns<double> {
  static auto plan(const ColumnPlan& of, double* in, double* out) {
    return fftw_plan_many_dft(1, &of.points, of.columns, raw(in), nullptr, 1, of.apart, raw(out), nullptr, 1,
                              of.apart, of.sign, FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  }
  static void execute(const Plan& plan, double* in, double* out) {
    fftw_execute_dft(get(plan), raw(in), raw(out));
  }
};
template <>
struct Columns<float> {
  static void* plan(const ColumnPlan& of, float* in, float* out) {
    return ASPERITY_FROM_MODULE("asperity_single", asperity_plan_columns)(of, in, out);
  }
  static void execute(const Plan& plan, float* in, float* out) {
    static const auto execute = ASPERITY_FROM_MODULE("asperity_single", asperity_execute_columns);
    execute(plan.get(), in, out);
  }
};

void destroy(fftw_plan plan) { fftw_destroy_plan(plan); }
void destroy(void* single) { ASPERITY_FROM_MODULE("asperity_single", asperity_destroy_columns)(single); }

// The next multiple of sixteen numbers, so that a second array after the first is aligned too.
std::size_t aligned(Index n) { return (size(n) + 15) / 16 * 16; }

// FFTW's planner keeps global state; executing a plan does not.
std::mutex planner;

enum Kind { columns_forward, columns_inverse, plane_forward, plane_inverse };

// What distinguishes a plan: the kind, its two lengths, and the bytes of a number.
using Key = std::tuple<Kind, Index, Index, std::size_t>;

// The plans of late, shared by all transforms of the same size.
std::map<Key, Plan> recent;
constexpr std::size_t most_recent = 64;

// FFTW counts by int: a longer side would become another one.
int counted(Index n) {
  if (n > std::numeric_limits<int>::max())
    throw std::length_error("a transform of " + std::to_string(n) +
                            " points along a side is too long for FFTW");
  return static_cast<int>(n);
}

// FFTW aborts where it finds no memory: to make a plan, for its solvers, the first time, and twiddle factors;
// to execute one, for buffers of a few rows.
void require_memory_for(Index nx, Index ny) { require_memory((std::size_t{1} << 20) + 128 * size(nx + ny)); }

// Executions that check memory first: those of 100 µs and more, which the check makes a few per cent longer.
constexpr Index worth_a_look = 1 << 14;

void require_buffers(Shape shape) {
  if (shape.cells() >= worth_a_look) require_memory_for(shape.nx, shape.ny);
}

// FFTW wants arrays to plan on; an estimated plan neither reads nor writes them, so that they take no memory,
// and an aligned one may be executed on any other aligned array.
template <class Real = double, class Make>
Plan plan(Kind kind, Index nx, Index ny, std::size_t reals, Make make) {
  const Key key{kind, nx, ny, sizeof(Real)};
  std::map<Key, Plan> forgotten;  // destroyed after the lock is released
  const std::lock_guard lock(planner);
  if (const auto known = recent.find(key); known != recent.end()) return known->second;
  AlignedVector<Real> scratch;
  scratch.reserve(reals);
  require_memory_for(nx, ny);
  const auto made = make(scratch.data());
  if (made == nullptr) throw std::runtime_error("FFTW could not make a plan");
  if (recent.size() == most_recent) recent.swap(forgotten);
  return recent[key] = Plan(made, [](auto p) {
           const std::lock_guard alone(planner);
           destroy(p);
         });
}

}  // namespace

Index fast_length(Index n, Index multiple) {
  auto fast = [](Index length) {
    Index k = length;
    std::array<int, 6> exponent{};
    for (Index p : {2, 3, 5})
      for (; k % p == 0; k /= p) ++exponent[size(p)];
    return k == 1 && exponent[5] <= 2 && exponent[3] <= (length < 768 ? 0 : 1);
  };
  Index k = std::max<Index>(n, 1);
  k += (multiple - k % multiple) % multiple;
  while (!fast(k)) k += multiple;
  return k;
}

std::string transform_version() {
  const std::string version = fftw_version;  // "fftw-3.3.10-sse2-avx"
  const auto begin = version.find('-') + 1;
  return "FFTW " + version.substr(begin, version.find('-', begin) - begin);
}

template <class Real>
BasicColumnTransform<Real>::BasicColumnTransform(Index n, Index width, Ways ways) : n_(n), width_(width) {
  const ColumnPlan columns{counted(n), counted(width), counted(stride()), 0};
  auto one_way = [&](Kind kind, int sign) {
    const std::size_t reals = aligned(2 * size());
    return plan<Real>(kind, n, width, 2 * reals, [&](Real* a) {
      ColumnPlan of = columns;
      of.sign = sign;
      return Columns<Real>::plan(of, a, a + reals);
    });
  };
  forward_ = one_way(columns_forward, FFTW_FORWARD);
  if (ways == Ways::both) inverse_ = one_way(columns_inverse, FFTW_BACKWARD);
}

template <class Real>
void BasicColumnTransform<Real>::forward(const Number* in, Number* out) const {
  Columns<Real>::execute(forward_, reals(const_cast<Number*>(in)), reals(out));
}
template <class Real>
void BasicColumnTransform<Real>::inverse(const Number* in, Number* out) const {
  Columns<Real>::execute(inverse_, reals(const_cast<Number*>(in)), reals(out));
}

template class BasicColumnTransform<double>;
template class BasicColumnTransform<float>;

RealTransform2D::RealTransform2D(Shape shape) : shape_(shape) {
  const std::array sides{counted(shape.nx), counted(shape.ny)};
  const int rank = shape.nx == 1 ? 1 : 2, *n = sides.data() + 2 - rank;
  const std::size_t offset = aligned(shape.cells()), doubles = offset + 2 * size(spectrum_size());
  forward_ = plan(plane_forward, shape.nx, shape.ny, doubles, [&](double* a) {
    return fftw_plan_dft_r2c(rank, n, a, raw(a + offset), FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  });
  inverse_ = plan(plane_inverse, shape.nx, shape.ny, doubles,
                  [&](double* a) { return fftw_plan_dft_c2r(rank, n, raw(a + offset), a, FFTW_ESTIMATE); });
}

void RealTransform2D::forward(const double* in, Complex* out) const {
  require_buffers(shape_);
  fftw_execute_dft_r2c(get(forward_), const_cast<double*>(in), raw(out));
}

void RealTransform2D::inverse(Complex* in, double* out) const {
  require_buffers(shape_);
  fftw_execute_dft_c2r(get(inverse_), raw(in), out);
}

}  // namespace asperity
