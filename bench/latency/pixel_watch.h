#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

namespace felt::bench {

/// Watches a place of the screen on a thread and a connection of its own, as another program would
/// see it: by the X server's shared memory, every 50 us or so. A place is five pixels, one above
/// the other, so that grain in the ink does not hide it.
///
///   if (watch.arm(x, y)) ...    // there is paper
///   ... paint ...
///   watch.seen_ns()             // when there was ink; 0: not yet
class PixelWatch {
 public:
  PixelWatch();
  ~PixelWatch();
  /// False: there is no X server, or none with shared memory.
  [[nodiscard]] bool works() const noexcept { return works_; }

  /// Returns when the place has been looked at. False: it is no paper (dark), and is not watched.
  bool arm(int x, int y);
  /// Steady clock: the end of the first look that found ink.
  [[nodiscard]] std::int64_t seen_ns() const noexcept { return seen_ns_; }
  /// How long a look takes, on average, ns.
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
