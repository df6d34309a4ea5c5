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

fftw_complex* raw(Complex* p) { return reinterpret_cast<fftw_complex*>(p); }
fftw_complex* raw(double* p) { return reinterpret_cast<fftw_complex*>(p); }
fftw_plan get(const Plan& p) { return static_cast<fftw_plan>(p.get()); }

// The next multiple of eight doubles, so that a second array behind the first is aligned too.
std::size_t aligned(Index n) { return (size(n) + 7) / 8 * 8; }

// FFTW's planner keeps global state; executing a plan does not.
std::mutex planner;

enum Kind { columns_forward, columns_inverse, plane_forward, plane_inverse };

// What distinguishes a plan: the kind and its two lengths.
using Key = std::tuple<Kind, Index, Index>;

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
template <class Make>
Plan plan(const Key& key, std::size_t doubles, Make make) {
  std::map<Key, Plan> forgotten;  // destroyed after the lock is released
  const std::lock_guard lock(planner);
  if (const auto known = recent.find(key); known != recent.end()) return known->second;
  const std::unique_ptr<double, decltype(&fftw_free)> scratch(fftw_alloc_real(doubles), &fftw_free);
  if (!scratch) throw std::bad_alloc();
  require_room_for(std::get<1>(key), std::get<2>(key));
  const fftw_plan made = make(scratch.get());
  if (made == nullptr) throw std::runtime_error("FFTW could not make a plan");
  if (recent.size() == most_recent) recent.swap(forgotten);
  return recent[key] = Plan(made, [](fftw_plan p) {
           const std::lock_guard alone(planner);
           fftw_destroy_plan(p);
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

ColumnTransform::ColumnTransform(Index n, Index width, Ways ways) : n_(n), width_(width) {
  const int points = counted(n), columns = counted(width), apart = counted(stride());
  auto one_way = [&](Kind kind, int sign) {
    const std::size_t doubles = aligned(2 * size());
    return plan({kind, n, width}, 2 * doubles, [&](double* a) {
      return fftw_plan_many_dft(1, &points, columns, raw(a), nullptr, 1, apart, raw(a + doubles), nullptr, 1,
                                apart, sign, FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
    });
  };
  forward_ = one_way(columns_forward, FFTW_FORWARD);
  if (ways == Ways::both) inverse_ = one_way(columns_inverse, FFTW_BACKWARD);
}

void ColumnTransform::forward(const Complex* in, Complex* out) const {
  fftw_execute_dft(get(forward_), raw(const_cast<Complex*>(in)), raw(out));
}
void ColumnTransform::inverse(const Complex* in, Complex* out) const {
  fftw_execute_dft(get(inverse_), raw(const_cast<Complex*>(in)), raw(out));
}

RealTransform2D::RealTransform2D(Shape shape) : shape_(shape) {
  const std::array sides{counted(shape.nx), counted(shape.ny)};
  const int rank = shape.nx == 1 ? 1 : 2, *n = sides.data() + 2 - rank;
  const std::size_t offset = aligned(shape.cells()), doubles = offset + 2 * size(spectrum_size());
  forward_ = plan({plane_forward, shape.nx, shape.ny}, doubles, [&](double* a) {
    return fftw_plan_dft_r2c(rank, n, a, raw(a + offset), FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  });
  inverse_ = plan({plane_inverse, shape.nx, shape.ny}, doubles,
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
