#include "acf/kinsol.hpp"

#include <cmath>
#include <memory>
#include <new>

#include <Eigen/Core>
#include <sundials/sundials_version.h>

#include "acf/nonlinear_system.hpp"
#include "grid/field.hpp"

namespace asperity {
namespace {

// SUNDIALS' vector, with what it stands for behind it: in one piece with its values where they are its own.
struct Array {
  _generic_N_Vector vector{};
  Index size = 0;
  double* values = nullptr;
};

using Map = Eigen::Map<Eigen::ArrayXd>;
Array& content(N_Vector v) { return *static_cast<Array*>(v->content); }
Map array(N_Vector v) { return {content(v).values, content(v).size}; }

// A copy of the description, with room behind it for so many bytes.
Array* described_as(const Array& like, std::size_t room) {
  void* memory = ::operator new(sizeof(Array) + room, std::nothrow);
  if (!memory) return nullptr;
  auto* made = new (memory) Array(like);
  made->vector.content = made;
  return made;
}

N_Vector clone(N_Vector v) {
  constexpr std::size_t alignment = 64;  // of the values; by far cheaper here than by the allocator
  const std::size_t bytes = static_cast<std::size_t>(content(v).size) * sizeof(double);
  std::size_t room = bytes + alignment - 1;
  Array* made = described_as(content(v), room);
  if (!made) return nullptr;
  void* values = made + 1;
  made->values = static_cast<double*>(std::align(alignment, bytes, values, room));
  return &made->vector;
}

// The operations that KINSOL and its GMRES ask for.
_generic_N_Vector_Ops operations() {
  _generic_N_Vector_Ops does{};
  does.nvclone = clone;
  does.nvdestroy = [](N_Vector v) { ::operator delete(v->content); };
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

kinsol::Vector kinsol::vector_of(std::span<double> values, sundials::Context& context) {
  static _generic_N_Vector_Ops shared = operations();
  Array array;
  array.vector.ops = &shared;
  array.vector.sunctx = context;
  array.size = static_cast<Index>(values.size());
  array.values = values.data();
  return Vector(&made(described_as(array, 0), "operator new")->vector);
}

std::string sundials_version() { return std::string("SUNDIALS ") + SUNDIALS_VERSION; }

}  // namespace asperity
