#include "math/kinsol.hpp"

#include <cmath>

#include <Eigen/Core>

#include "core/field.hpp"
#include "core/memory.hpp"

namespace asperity {

namespace {

constexpr std::align_val_t alignment{64};  // of the values
constexpr std::size_t small_parts =
    1 << 20;                           // bytes that SUNDIALS takes in addition to the vectors, and some more
constexpr std::size_t page = 1 << 12;  // by which the allocator rounds

// SUNDIALS' vector and its description, in one block with the values where it owns them.
struct Array {
  _generic_N_Vector vector{};
  Index size = 0;
  double* values = nullptr;
};
constexpr std::size_t description_size = (sizeof(Array) + 63) / 64 * 64;

using Map = Eigen::Map<Eigen::ArrayXd>;
Array& content(N_Vector v) { return *static_cast<Array*>(v->content); }
Map array(N_Vector v) { return {content(v).values, content(v).size}; }

N_Vector placed(void* block, const Array& description) {
  auto* made = new (block) Array(description);
  made->vector.content = made;
  return &made->vector;
}

N_Vector clone(N_Vector v) {
  Array made = content(v);
  const std::size_t bytes = description_size + size(made.size) * sizeof(double);
  void* const block = ::operator new(bytes, alignment, std::nothrow);
  if (!block) return nullptr;
  made.values = reinterpret_cast<double*>(static_cast<std::byte*>(block) + description_size);
  return placed(block, made);
}

void destroy(N_Vector v) { ::operator delete(v->content, alignment); }

// The operations that KINSOL and its GMRES ask for.
_generic_N_Vector_Ops operations() {
  _generic_N_Vector_Ops does{};
  does.nvclone = clone;
  does.nvdestroy = destroy;
  does.nvgetlength = [](N_Vector v) { return static_cast<sunindextype>(content(v).size); };
  does.nvgetarraypointer = [](N_Vector v) { return content(v).values; };
  does.nvdotprod = [](N_Vector x, N_Vector y) { return (array(x) * array(y)).sum(); };
  does.nvprod = [](N_Vector x, N_Vector y, N_Vector z) { array(z) = array(x) * array(y); };
  does.nvdiv = [](N_Vector x, N_Vector y, N_Vector z) { array(z) = array(x) / array(y); };
  does.nvabs = [](N_Vector x, N_Vector z) { array(z) = array(x).abs(); };
  does.nvinv = [](N_Vector x, N_Vector z) { array(z) = array(x).inverse(); };
  does.nvconst = [](sunrealtype c, N_Vector z) { array(z) = c; };
  does.nvscale = [](sunrealtype c, N_Vector x, N_Vector z) { array(z) = c * array(x); };
  does.nvlinearsum = [](sunrealtype a, N_Vector x, sunrealtype b, N_Vector y, N_Vector z) {
    array(z) = a * array(x) + b * array(y);
  };
  does.nvwl2norm = [](N_Vector x, N_Vector w) { return std::sqrt((array(x) * array(w)).square().sum()); };
  does.nvmaxnorm = [](N_Vector x) { return array(x).abs().maxCoeff<Eigen::PropagateNaN>(); };
  does.nvmin = [](N_Vector x) { return array(x).minCoeff<Eigen::PropagateNaN>(); };
  return does;
}

}  // namespace

void kinsol::require_vectors(std::size_t size, std::size_t count) {
  require_memory(count * (description_size + size * sizeof(double) + page) + small_parts);
}

kinsol::Vector kinsol::vector_of(std::span<double> values, sundials::Context& context) {
  static _generic_N_Vector_Ops shared = operations();
  Array array;
  array.vector.ops = &shared;
  array.vector.sunctx = context;
  array.size = static_cast<Index>(values.size());
  array.values = values.data();
  return Vector(placed(::operator new(sizeof(Array), alignment), array));
}

}  // namespace asperity
