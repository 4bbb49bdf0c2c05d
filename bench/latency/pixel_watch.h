#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

namespace felt::bench {

/// Watches one position of the screen as another program would see it: on a thread and an X
/// connection of its own, through the X server's shared memory, about every 50 us. It reads a
/// column of five pixels, so that grain in the ink does not hide the ink.
///
///   if (watch.arm(x, y)) ...    // the position shows paper
///   ... paint ...
///   watch.seen_ns()             // the time at which ink was found, or 0
class PixelWatch {
 public:
  PixelWatch();
  ~PixelWatch();
  /// Returns false if no X server runs, or if it has no shared memory.
  [[nodiscard]] bool works() const noexcept { return works_; }

  /// Starts to watch a position, and returns after the first look at it. Returns false, without
  /// watching it, if the position is dark and so does not show paper.
  bool arm(int x, int y);
  /// Returns the end of the first look that found ink, on the steady clock, or 0 if none did yet.
  [[nodiscard]] std::int64_t seen_ns() const noexcept { return seen_ns_; }
  /// Returns the average duration of one look, in ns.
  [[nodiscard]] double look_ns() const noexcept;

 private:
  struct Screen;

  void run();

  std::unique_ptr<Screen> screen_;
  bool works_ = false;
  std::atomic<std::uint64_t> order_{0};  // counts arm()
  std::atomic<std::uint64_t> taken_{0};
  std::atomic<int> x_{0}, y_{0};
  std::atomic<bool> is_paper_{false};
  std::atomic<std::int64_t> seen_ns_{0};
  std::atomic<std::uint64_t> looks_{0};
  std::atomic<std::int64_t> looking_ns_{0};
  std::atomic<bool> stop_{false};
  std::jthread thread_;
};

}  // namespace felt::bench
