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

/// Plays cues on a cue device, in a separate thread. A transfer to a sleeping mouse or to a pen on
/// a slow bus may take long, and a window must not wait for it. At most kMaxWaiting cues wait; if
/// there are more, the oldest are dropped.
///
/// Call all functions on one thread. If the device is disconnected, `on_fault` is called once, on
/// the playing thread, and nothing is played afterwards. Other faults are ignored.
class CueThread {
 public:
  static constexpr std::size_t kMaxWaiting = 3;

  /// If `with_thread` is false, play() plays in the calling thread; for tests and pictures.
  CueThread(std::unique_ptr<CueDevice> device, bool with_thread,
            std::function<void(DeviceFault)> on_fault);
  CueThread(const CueThread&) = delete;
  CueThread& operator=(const CueThread&) = delete;
  /// Waits for the cue that is being played, then silences the device.
  ~CueThread();

  void play(const Cue& cue, std::int64_t now_ns);
  /// Silences the device and drops the waiting cues.
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
  bool has_failed_ = false;  // used by the playing thread
  std::mutex mutex_;
  std::condition_variable posted_;
  std::deque<Order> orders_;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace felt::desktop
