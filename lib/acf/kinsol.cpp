#include "acf/kinsol.hpp"

#include <cmath>
#include <memory>
#include <new>

#include <Eigen/Core>
#include <sundials/sundials_version.h>

#include "acf/iteration.hpp"
#include "core/field.hpp"
#include "core/room.hpp"

namespace asperity {

using kinsol::VectorStore;

namespace {

constexpr std::size_t alignment = 64;         // of the values
constexpr std::size_t small_parts = 1 << 20;  // bytes that SUNDIALS takes beside the vectors, and some more

constexpr std::size_t aligned(std::size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }

// SUNDIALS' vector, with what it stands for behind it: in one piece with its values where they are its own.
struct Array {
  _generic_N_Vector vector{};
  Index size = 0;
  double* values = nullptr;
  VectorStore* store = nullptr;
  bool stored = false;  // in a block of the store
};

using Map = Eigen::Map<Eigen::ArrayXd>;
Array& content(N_Vector v) { return *static_cast<Array*>(v->content); }
Map array(N_Vector v) { return {content(v).values, content(v).size}; }

// A description, and behind it its values.
std::size_t block_size(std::size_t values) {
  return aligned(sizeof(Array)) + aligned(values * sizeof(double));
}

N_Vector placed(void* block, const Array& description) {
  auto* made = new (block) Array(description);
  made->vector.content = made;
  return &made->vector;
}

// From the store, and should it hold too few for this SUNDIALS, from the heap.
N_Vector clone(N_Vector v) {
  Array made = content(v);
  void* block = made.store->take();
  made.stored = block != nullptr;
  if (!block)
    block = ::operator new (block_size(static_cast<std::size_t>(made.size)), std::align_val_t{alignment},
                            std::nothrow);
  if (!block) return nullptr;
  made.values = reinterpret_cast<double*>(static_cast<std::byte*>(block) + aligned(sizeof(Array)));
  return placed(block, made);
}

void destroy(N_Vector v) {
  const Array gone = content(v);
  if (gone.stored) return gone.store->give_back(v->content);
  ::operator delete (v->content, std::align_val_t{alignment});
}

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

kinsol::VectorStore::VectorStore(std::size_t size, std::size_t count)
    : memory_(new (std::align_val_t{alignment}) std::byte[count * block_size(size)]) {
  free_.reserve(count);
  for (std::size_t i = count; i-- > 0;) free_.push_back(memory_.get() + i * block_size(size));
  require_room(small_parts);
}

void* kinsol::VectorStore::take() noexcept {
  if (free_.empty()) return nullptr;
  void* const block = free_.back();
  free_.pop_back();
  return block;
}

void kinsol::VectorStore::give_back(void* block) noexcept { free_.push_back(block); }

kinsol::Vector kinsol::vector_of(std::span<double> values, sundials::Context& context, VectorStore& store) {
  static _generic_N_Vector_Ops shared = operations();
  Array array;
  array.vector.ops = &shared;
  array.vector.sunctx = context;
  array.size = static_cast<Index>(values.size());
  array.values = values.data();
  array.store = &store;
  return Vector(placed(::operator new (sizeof(Array), std::align_val_t{alignment}), array));
}

std::string sundials_version() { return std::string("SUNDIALS ") + SUNDIALS_VERSION; }

}  // namespace asperity
