#pragma once

#include "felt/base/result.h"

namespace felt {

/// A device whose maker runs the servo loop: the vendor's scheduler calls us, once a tick, on a
/// thread of its own (OpenHaptics). `RealtimeThread` uses it in the place of a thread of its own
/// when it is given one.
class LoopHost {
 public:
  using Tick = void (*)(void* context) noexcept;

  LoopHost() = default;
  LoopHost(const LoopHost&) = delete;
  LoopHost& operator=(const LoopHost&) = delete;
  virtual ~LoopHost() = default;

  /// From now on the host calls `tick(context)` about once a period of the device's capabilities,
  /// always from one thread at a time, until stop_loop() has returned. Edit thread.
  ///
  /// Error: the vendor refuses; the message has its words. Nothing is called then.
  virtual Result<void> start_loop(Tick tick, void* context) = 0;
  /// Returns when no call is under way and none will come. Edit thread; nothing when none runs.
  virtual void stop_loop() noexcept = 0;
};

}  // namespace felt
