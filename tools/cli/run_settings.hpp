/// What a run may use: threads, memory, ranks; the seed of its random numbers; whether it shows progress.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/ranks.hpp"
#include "dataset/memory_bound.hpp"

namespace asperity::cli {

class Messages;
class Options;

class RunSettings {
 public:
  RunSettings(Options& options, const Messages& messages);

  // What a tool has.
  void threads() { threaded_ = true; }  ///< --threads N
  /// --memory SIZE; `text` says what it bounds besides an input. A tool that reads has the option anyway.
  void memory(const std::string& text);
  void seed() { seeded_ = true; }  ///< --seed N and --stream K
  /// Of a tool that several ranks may run together (core/launch.hpp); no other starts under a launcher.
  void shares_ranks() { shares_ranks_ = true; }

  // The options themselves, where the tool has them.
  void declare_seed();
  void declare_threads();
  void declare_progress();

  void join_ranks();  ///< before the options are known
  /// Throws CommandLineError where a launcher started copies of a tool that shares no ranks.
  void refuse_copies() const;

  int thread_count() const;                                   ///< resolved: at least 1
  const Ranks& ranks() const { return *ranks_; }              ///< that run it
  bool is_first_rank() const { return ranks_->rank() == 0; }  ///< it prints and writes for all of them
  std::size_t memory() const { return memory_; }              ///< that the run may take [byte]
  /// The part of it for reading; `held` is in use.
  MemoryBound memory_bound(std::size_t held = 0) const;
  /// Throws UsageError(option, …) where `what`, "a contact of 64x64 cells", needs more than --memory allows.
  void require_memory(double bytes, const std::string& option, const std::string& what,
                      const std::string& instead = "") const;
  std::uint64_t seed_value();  ///< from --seed, else from entropy, the same at each call
  std::uint64_t stream_value() const { return static_cast<std::uint64_t>(stream_); }
  bool shows_progress() const;  ///< a line of progress on standard error is wanted

 private:
  Options& options_;
  const Messages& messages_;
  std::size_t memory_;
  int threads_ = 0, stream_ = 0;
  std::optional<std::uint64_t> seed_;
  std::string progress_ = "auto";
  const Ranks* ranks_ = &alone();
  bool threaded_ = false, seeded_ = false, shares_ranks_ = false;
};

}  // namespace asperity::cli
