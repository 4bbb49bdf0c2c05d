#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "felt/base/result.h"
#include "felt/rt/loop_stats.h"
#include "felt/rt/realtime_thread.h"
#include "felt/rt/servo.h"
#include "felt/validate/probe_device.h"

namespace felt {

/// Lets time pass in a device test, in virtual or real time. Edit thread only; one servo at a time.
class TestLoop {
 public:
  TestLoop() = default;
  TestLoop(const TestLoop&) = delete;
  TestLoop& operator=(const TestLoop&) = delete;
  virtual ~TestLoop() = default;

  /// Starts to call the ticks of the servo. `host` is the device's LoopHost or null, as for
  /// RealtimeThread.
  virtual Result<void> start(Servo& servo, LoopHost* host) = 0;
  /// Stops the ticks of the servo; the force is then zero. Has no effect if no servo runs.
  virtual void stop() noexcept = 0;
  /// Lets `ns` nanoseconds pass and sends heartbeats to the servo. Calls `turn` every few ms and
  /// once at the end. It also works while no servo runs.
  virtual void pass(std::int64_t ns, const std::function<void()>& turn) = 0;
  /// Lets `ns` nanoseconds pass without communication with the device, before the next tick.
  virtual void stall(ProbeDevice& probe, std::int64_t ns) = 0;
  /// Returns a time that increases while time passes. It does not restart with start().
  [[nodiscard]] virtual std::int64_t now_ns() const noexcept = 0;
  /// Returns the statistics of the current servo.
  [[nodiscard]] virtual LoopStats stats() noexcept = 0;
  /// Returns a text that says how time passes, for the report.
  [[nodiscard]] virtual std::string words() = 0;
};

/// Runs as fast as the processor can, and identically each time. It is for simulated devices.
class VirtualTestLoop final : public TestLoop {
 public:
  /// `before_tick` moves the simulated hand. If `lateness_ns` has n > 0 entries, tick k is late by
  /// entry k mod n. The entries must outlive this object.
  explicit VirtualTestLoop(std::function<void(std::int64_t now_ns)> before_tick,
                           std::span<const std::int64_t> lateness_ns = {});

  Result<void> start(Servo& servo, LoopHost* host) override;
  void stop() noexcept override;
  void pass(std::int64_t ns, const std::function<void()>& turn) override;
  void stall(ProbeDevice& probe, std::int64_t ns) override;
  [[nodiscard]] std::int64_t now_ns() const noexcept override { return now_ns_; }
  [[nodiscard]] LoopStats stats() noexcept override { return stats_; }
  [[nodiscard]] std::string words() override { return "virtual"; }

 private:
  void tick();

  std::function<void(std::int64_t)> before_tick_;
  std::span<const std::int64_t> lateness_ns_;
  std::size_t at_ = 0;
  Servo* servo_ = nullptr;
  std::int64_t due_ns_ = 0;
  std::int64_t now_ns_ = 0;
  LoopStats stats_;
};

/// Runs in real time, on its own thread or the device's. It is for real devices.
class ThreadTestLoop final : public TestLoop {
 public:
  explicit ThreadTestLoop(const RealtimeOptions& options = {});
  ~ThreadTestLoop() override;

  Result<void> start(Servo& servo, LoopHost* host) override;
  void stop() noexcept override;
  void pass(std::int64_t ns, const std::function<void()>& turn) override;
  void stall(ProbeDevice& probe, std::int64_t ns) override;
  [[nodiscard]] std::int64_t now_ns() const noexcept override;
  [[nodiscard]] LoopStats stats() noexcept override;
  [[nodiscard]] std::string words() override { return words_; }

 private:
  RealtimeOptions options_;
  Servo* servo_ = nullptr;
  std::unique_ptr<RealtimeThread> thread_;
  std::string words_ = "real";
};

}  // namespace felt
