#include "felt/validate/test_loop.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace felt {
namespace {

constexpr std::int64_t kTurnNs = 4'000'000;

std::int64_t clock_ns() noexcept {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

VirtualTestLoop::VirtualTestLoop(std::function<void(std::int64_t)> before_tick,
                                 std::span<const std::int64_t> lateness_ns)
    : before_tick_(std::move(before_tick)), lateness_ns_(lateness_ns) {}

Result<void> VirtualTestLoop::start(Servo& servo, LoopHost*) {
  servo_ = &servo;
  stats_ = {};
  due_ns_ = now_ns_ + servo.options().period_ns;
  return {};
}

void VirtualTestLoop::stop() noexcept {
  if (servo_ != nullptr) servo_->stop();
  servo_ = nullptr;
}

void VirtualTestLoop::tick() {
  const std::int64_t period_ns = servo_->options().period_ns;
  const std::int64_t late_ns =
      lateness_ns_.empty() ? 0 : std::max<std::int64_t>(0, lateness_ns_[at_]);
  if (!lateness_ns_.empty()) at_ = (at_ + 1) % lateness_ns_.size();
  now_ns_ = due_ns_ + late_ns;
  due_ns_ += period_ns * (1 + late_ns / period_ns);
  before_tick_(now_ns_);
  servo_->heartbeat(now_ns_);
  servo_->step(now_ns_);
  stats_.tick(now_ns_, late_ns, period_ns);
}

void VirtualTestLoop::pass(std::int64_t ns, const std::function<void()>& turn) {
  const std::int64_t end_ns = now_ns_ + ns;
  if (servo_ == nullptr) {
    before_tick_(now_ns_ = end_ns);
    return turn();
  }
  for (std::int64_t turn_ns = now_ns_ + kTurnNs; due_ns_ <= end_ns;) {
    tick();
    if (now_ns_ < turn_ns) continue;
    turn();
    turn_ns = now_ns_ + kTurnNs;
  }
  turn();
}

void VirtualTestLoop::stall(ProbeDevice& probe, std::int64_t ns) {
  if (servo_ == nullptr) return;
  probe.note_stall();
  due_ns_ += ns;
  tick();
}

ThreadTestLoop::ThreadTestLoop(const RealtimeOptions& options) : options_(options) {}

ThreadTestLoop::~ThreadTestLoop() {
  stop();
}

Result<void> ThreadTestLoop::start(Servo& servo, LoopHost* host) {
  stop();
  thread_ = std::make_unique<RealtimeThread>(servo, options_, host);
  servo_ = &servo;
  servo.heartbeat(thread_->now_ns());
  Result<void> started = thread_->start();
  if (started) {
    words_ = describe(thread_->status());
  } else {
    thread_.reset();
  }
  return started;
}

void ThreadTestLoop::stop() noexcept {
  thread_.reset();  // the destructor stops the loop
  servo_ = nullptr;
}

void ThreadTestLoop::pass(std::int64_t ns, const std::function<void()>& turn) {
  const std::int64_t end_ns = clock_ns() + ns;
  do {
    const std::int64_t left_ns = std::clamp<std::int64_t>(end_ns - clock_ns(), 0, kTurnNs);
    std::this_thread::sleep_for(std::chrono::nanoseconds(left_ns));
    if (thread_) servo_->heartbeat(thread_->now_ns());
    turn();
  } while (clock_ns() < end_ns);
}

void ThreadTestLoop::stall(ProbeDevice& probe, std::int64_t ns) {
  probe.stall(ns);
}

std::int64_t ThreadTestLoop::now_ns() const noexcept {
  return clock_ns();
}

LoopStats ThreadTestLoop::stats() noexcept {
  return thread_ ? thread_->stats() : LoopStats();
}

}  // namespace felt
