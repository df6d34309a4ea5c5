/// KINSOL's objects with owners, and its vectors. The only door to SUNDIALS.
///
/// SUNDIALS does not survive want of memory: N_VClone writes into the vector that it was not given, and
/// KINInit frees what its caller frees again. So an iteration asks for the room of all its vectors
/// beforehand.
#pragma once

#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <kinsol/kinsol.h>
#include <sundials/sundials_context.hpp>
#include <sundials/sundials_nvector.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_spgmr.h>

namespace asperity::kinsol {

template <auto release>
struct Release {
  void operator()(auto* owned) const { release(owned); }
};
inline void free_kinsol(void* memory) { KINFree(&memory); }
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, Release<N_VDestroy>>;
using LinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, Release<SUNLinSolFree>>;
using Kinsol = std::unique_ptr<void, Release<free_kinsol>>;

/// Throws std::runtime_error naming the call where its flag says that it failed.
inline void check(int flag, const char* call) {
  if (flag < 0) throw std::runtime_error(std::string(call) + " failed with " + std::to_string(flag));
}

/// Says nothing on stderr: how an iteration ended is told by its result.
inline void silence([[maybe_unused]] void* kinsol, [[maybe_unused]] sundials::Context& context) {
#if SUNDIALS_VERSION_MAJOR < 7
  check(KINSetErrFile(kinsol, nullptr), "KINSetErrFile");
#else
  check(SUNContext_ClearErrHandlers(context), "SUNContext_ClearErrHandlers");
#endif
}

/// The pointer, or std::bad_alloc: nothing but want of memory keeps SUNDIALS from making what is asked for
/// here.
template <class Pointer>
Pointer made(Pointer pointer) {
  if (!pointer) throw std::bad_alloc();
  return pointer;
}

inline std::span<double> values(N_Vector v) {
  return {N_VGetArrayPointer(v), static_cast<std::size_t>(N_VGetLength(v))};
}

/// SUNDIALS' vector over `values`. Its operations are by vector instructions; the library's serial vector, as
/// it is packaged, would take as long as the transforms.
Vector vector_of(std::span<double> values, sundials::Context& context);
/// Throws std::bad_alloc where there is no room for so many vectors, and what SUNDIALS takes beside them.
void require_vectors(std::size_t size, std::size_t count);

}  // namespace asperity::kinsol
