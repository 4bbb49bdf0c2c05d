#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "felt/driver/cue_device.h"

namespace felt::desktop {

/// Plays on a cue device from a thread of its own, since the transfer to a mouse that sleeps or a
/// pen on a slow bus may take long, and a window must not wait. What waits too long is left out:
/// of cues that wait, the last kMostWaiting are played.
///
/// All functions from one thread; `on_fault` is called on the other one, once, and nothing is
/// played any more.
class CueThread {
 public:
  static constexpr std::size_t kMostWaiting = 3;

  /// `with_thread` false: play() plays at once. For tests and pictures.
  CueThread(std::unique_ptr<CueDevice> device, bool with_thread,
            std::function<void(DeviceFault)> on_fault);
  CueThread(const CueThread&) = delete;
  CueThread& operator=(const CueThread&) = delete;
  /// Silence; waits for what is being played.
  ~CueThread();

  void play(const Cue& cue, std::int64_t now_ns);
  /// Silence; what waits is not played.
  void stop();
  [[nodiscard]] const CueDevice& device() const noexcept { return *device_; }

 private:
  struct Order {
    Cue cue;
    std::int64_t now_ns = 0;
    bool is_stop = false;
  };

  void post(const Order& order);
  void serve();
  void carry_out(const Order& order);

  std::unique_ptr<CueDevice> device_;
  std::function<void(DeviceFault)> on_fault_;
  bool has_failed_ = false;  // of the thread that plays
  std::mutex mutex_;
  std::condition_variable posted_;
  std::deque<Order> orders_;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace felt::desktop
