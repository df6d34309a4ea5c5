/// KINSOL's objects with owners, and its vectors. The only door to SUNDIALS.
///
/// SUNDIALS does not survive running out of memory: N_VClone writes into a vector that it failed to allocate,
/// and KINInit frees what its caller then frees again. An iteration therefore checks beforehand that
/// there is memory for all its vectors.
#pragma once

#include <exception>
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

/// What C calls back must not throw: the exception is kept, and thrown where the library has returned.
class GuardedCall {
 public:
  /// What work() returns, or `failed`.
  template <class Work>
  int operator()(int failed, Work work) noexcept {
    try {
      return work();
    } catch (...) {
      failure_ = std::current_exception();
      return failed;
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::exception_ptr failure_;
};

/// Prints nothing on stderr: the result of an iteration says how it ended.
inline void silence([[maybe_unused]] void* kinsol, [[maybe_unused]] sundials::Context& context) {
#if SUNDIALS_VERSION_MAJOR < 7
  check(KINSetErrFile(kinsol, nullptr), "KINSetErrFile");
#else
  check(SUNContext_ClearErrHandlers(context), "SUNContext_ClearErrHandlers");
#endif
}

/// The pointer, or std::bad_alloc: here SUNDIALS can fail only for lack of memory.
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
/// Throws std::bad_alloc if there is no memory for this many vectors plus SUNDIALS' own.
void require_vectors(std::size_t size, std::size_t count);

}  // namespace asperity::kinsol
