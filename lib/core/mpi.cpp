#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "core/launch.hpp"

#define OMPI_SKIP_MPICXX 1  // C++ bindings of old
#include <mpi.h>

namespace asperity {
namespace {

constexpr auto patience = std::chrono::seconds(2);  // with ranks that may wait for one that has failed

// Open MPI loads parts of itself, which look for its symbols among those of all libraries.
void show_symbols() {
  Dl_info of{};
  if (::dladdr(reinterpret_cast<void*>(&MPI_Init), &of) != 0)
    ::dlopen(of.dli_fname, RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD);
}

class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    show_symbols();
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    stderr_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
    if (rank_ == 0) return;
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    for (const int closed : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, closed);
    ::close(nowhere);
  }

  int rank() const override { return rank_; }
  int count() const override { return count_; }

  void exchange(const Pieces& to, const Room& from) const override {
    std::vector<MPI_Request> requests;
    for (int r = 0; r < count_; ++r)
      if (r != rank_)
        each_message(from[static_cast<std::size_t>(r)], [&](std::byte* at, int bytes) {
          MPI_Irecv(at, bytes, MPI_BYTE, r, 0, MPI_COMM_WORLD, &requests.emplace_back());
        });
    // Every rank begins with the next one, so that not all send to one.
    for (int k = 1; k < count_; ++k) {
      const int r = (rank_ + k) % count_;
      each_message(to[static_cast<std::size_t>(r)], [&](const std::byte* at, int bytes) {
        MPI_Isend(at, bytes, MPI_BYTE, r, 0, MPI_COMM_WORLD, &requests.emplace_back());
      });
    }
    const auto self = static_cast<std::size_t>(rank_);
    if (!to[self].empty()) std::memmove(from[self].data(), to[self].data(), to[self].size());
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  }

  void end(int code, const std::string& last_words) const override {
    MPI_Request all_here = MPI_REQUEST_NULL;
    MPI_Ibarrier(MPI_COMM_WORLD, &all_here);
    const auto until = std::chrono::steady_clock::now() + patience;
    for (int here = 0; here == 0;) {
      MPI_Test(&all_here, &here, MPI_STATUS_IGNORE);
      if (here != 0) break;
      if (!last_words.empty() && std::chrono::steady_clock::now() > until) abort(code, last_words);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    MPI_Finalize();
  }

 private:
  [[noreturn]] void abort(int code, const std::string& last_words) const {
    const std::string line = last_words + "\n";
    if (rank_ > 0 && ::write(stderr_, line.data(), line.size()) < 0) code = code == 0 ? 1 : code;
    MPI_Abort(MPI_COMM_WORLD, code);
    std::_Exit(code);
  }

  // In messages whose length MPI can count.
  template <class Bytes, class Post>
  static void each_message(Bytes all, Post post) {
    constexpr std::size_t most = std::size_t{1} << 30;
    for (std::size_t at = 0; at < all.size(); at += most)
      post(all.data() + at, static_cast<int>(std::min(most, all.size() - at)));
  }

  int rank_ = 0, count_ = 1, stderr_ = -1;
};

}  // namespace
}  // namespace asperity

const asperity::Ranks* asperity_start_mpi() {
  static const asperity::MpiRanks ranks;
  return &ranks;
}
