#include "transform/plan.hpp"

#include <array>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>
#include <tuple>

#include <fftw3.h>

#include "core/room.hpp"

namespace asperity {
namespace {

// What FFTW calls by other names in each precision.
template <class Real>
struct Fftw;
template <>
struct Fftw<double> {
  using Number = fftw_complex;
  using Plan = fftw_plan;
  static constexpr auto plan_columns = fftw_plan_many_dft;
  static constexpr auto execute_columns = fftw_execute_dft;
  static constexpr auto destroy = fftw_destroy_plan;
};
template <>
struct Fftw<float> {
  using Number = fftwf_complex;
  using Plan = fftwf_plan;
  static constexpr auto plan_columns = fftwf_plan_many_dft;
  static constexpr auto execute_columns = fftwf_execute_dft;
  static constexpr auto destroy = fftwf_destroy_plan;
};

template <class Real>
auto raw(std::complex<Real>* p) {
  return reinterpret_cast<typename Fftw<Real>::Number*>(p);
}
template <class Real>
auto raw(Real* p) {
  return reinterpret_cast<typename Fftw<Real>::Number*>(p);
}
template <class Real = double>
auto get(const Plan& p) {
  return static_cast<typename Fftw<Real>::Plan>(p.get());
}

// The next multiple of sixteen numbers, so that a second array behind the first is aligned too.
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
void require_room_for(Index nx, Index ny) { require_room((std::size_t{1} << 20) + 128 * size(nx + ny)); }

// Executions that look first: those that take 100 µs and more, of which the look is a few per cent.
constexpr Index worth_a_look = 1 << 14;

void require_buffers(Shape shape) {
  if (shape.cells() >= worth_a_look) require_room_for(shape.nx, shape.ny);
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
  require_room_for(nx, ny);
  const auto made = make(scratch.data());
  if (made == nullptr) throw std::runtime_error("FFTW could not make a plan");
  if (recent.size() == most_recent) recent.swap(forgotten);
  return recent[key] = Plan(made, [](auto p) {
           const std::lock_guard alone(planner);
           Fftw<Real>::destroy(p);
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
  const int points = counted(n), columns = counted(width), apart = counted(stride());
  auto one_way = [&](Kind kind, int sign) {
    const std::size_t reals = aligned(2 * size());
    return plan<Real>(kind, n, width, 2 * reals, [&](Real* a) {
      return Fftw<Real>::plan_columns(1, &points, columns, raw(a), nullptr, 1, apart, raw(a + reals), nullptr,
                                      1, apart, sign, FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
    });
  };
  forward_ = one_way(columns_forward, FFTW_FORWARD);
  if (ways == Ways::both) inverse_ = one_way(columns_inverse, FFTW_BACKWARD);
}

template <class Real>
void BasicColumnTransform<Real>::forward(const Number* in, Number* out) const {
  Fftw<Real>::execute_columns(get<Real>(forward_), raw(const_cast<Number*>(in)), raw(out));
}
template <class Real>
void BasicColumnTransform<Real>::inverse(const Number* in, Number* out) const {
  Fftw<Real>::execute_columns(get<Real>(inverse_), raw(const_cast<Number*>(in)), raw(out));
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
