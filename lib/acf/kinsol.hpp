/// KINSOL's objects with owners, and its vectors: what the iterations on it share. The only door to SUNDIALS.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <kinsol/kinsol.h>
#include <sundials/sundials_context.hpp>
#include <sundials/sundials_nvector.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_spgmr.h>

namespace asperity::kinsol {

struct FreeVector {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
struct FreeSolver {
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
};
struct FreeKinsol {
  void operator()(void* memory) const { KINFree(&memory); }
};
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeVector>;
using LinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, FreeSolver>;
using Kinsol = std::unique_ptr<void, FreeKinsol>;

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

/// The pointer, or std::runtime_error naming the call.
template <class Pointer>
Pointer made(Pointer pointer, const char* call) {
  if (!pointer) throw std::runtime_error(std::string(call) + " failed");
  return pointer;
}

inline std::span<double> values(N_Vector v) {
  return {N_VGetArrayPointer(v), static_cast<std::size_t>(N_VGetLength(v))};
}

/// SUNDIALS' vector over `values`. The operations are by vector instructions, and a clone is one piece of memory, where
/// the library's serial vector, as it is packaged, would take as long as the transforms.
Vector vector_of(std::span<double> values, sundials::Context& context);

/// For a vector that SUNDIALS only reads.
inline std::span<double> unchanged(const std::vector<double>& v) {
  return {const_cast<double*>(v.data()), v.size()};
}

}  // namespace asperity::kinsol
