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

/// How time passes in a device test. Edit thread; one servo at a time.
class TestLoop {
 public:
  TestLoop() = default;
  TestLoop(const TestLoop&) = delete;
  TestLoop& operator=(const TestLoop&) = delete;
  virtual ~TestLoop() = default;

  /// From now on the servo ticks while time passes. `host` as in RealtimeThread.
  virtual Result<void> start(Servo& servo, LoopHost* host) = 0;
  /// Zero force; no tick any more. Nothing where none runs.
  virtual void stop() noexcept = 0;
  /// Lets so much time pass with heartbeats; `turn` every few ms, and once at the end. Also while
  /// no servo runs.
  virtual void pass(std::int64_t ns, const std::function<void()>& turn) = 0;
  /// Nobody speaks to the device for so long: then the next tick.
  virtual void stall(ProbeDevice& probe, std::int64_t ns) = 0;
  /// Grows while time passes, from start to start, too.
  [[nodiscard]] virtual std::int64_t now_ns() const noexcept = 0;
  /// Of the present servo.
  [[nodiscard]] virtual LoopStats stats() noexcept = 0;
  /// For the report: how time passes.
  [[nodiscard]] virtual std::string words() = 0;
};

/// As fast as the processor can, the same each time: for simulated devices.
class VirtualTestLoop final : public TestLoop {
 public:
  /// `before_tick` moves the simulated hand. With `lateness_ns`, tick k happens so much late (k mod
  /// its length); it must outlive this.
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

/// Real time, on a thread of its own or the device's: for real devices.
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
