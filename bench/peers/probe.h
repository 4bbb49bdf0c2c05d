#pragma once

#include <cstdint>
#include <vector>

#include "apps/cli/allocation_counter.h"
#include "bench/peers/cpu_clock.h"

namespace felt::bench {

/// Times the work of a peer. Reading the clock costs about as much as a cheap call, so the total
/// and the single calls are timed in different passes over the data.
class Probe {
 public:
  enum class Mode {
    kTotal,     ///< whole strokes: the mean, and the allocations
    kEachCall,  ///< every call: the tail of the distribution
  };

  explicit Probe(Mode mode) : mode_(mode) {}

  /// Runs and times the whole work of one stroke.
  template <class Work>
  void stroke(Work&& work) {
    const std::int64_t allocations = cli::thread_allocations();
    const std::int64_t start = thread_cpu_ns();
    work();
    total_ns_ += thread_cpu_ns() - start;
    allocations_ += cli::thread_allocations() - allocations;
  }

  /// Runs one call of the peer. Used inside the work of `stroke`.
  template <class Work>
  void call(Work&& work) {
    if (mode_ == Mode::kTotal) {
      work();
      return;
    }
    const std::int64_t start = thread_cpu_ns();
    work();
    calls_ns_.push_back(static_cast<float>(thread_cpu_ns() - start));
  }

  [[nodiscard]] std::int64_t total_ns() const { return total_ns_; }
  [[nodiscard]] std::int64_t allocations() const { return allocations_; }
  [[nodiscard]] const std::vector<float>& calls_ns() const { return calls_ns_; }

 private:
  Mode mode_;
  std::int64_t total_ns_ = 0;
  std::int64_t allocations_ = 0;
  std::vector<float> calls_ns_;
};

}  // namespace felt::bench
