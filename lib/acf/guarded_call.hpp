/// Exceptions carried through a library that is written in C.
#pragma once

#include <exception>

namespace asperity {

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

}  // namespace asperity
