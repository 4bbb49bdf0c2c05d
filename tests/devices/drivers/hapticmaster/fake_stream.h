#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "felt/driver/byte_stream.h"
#include "tests/devices/drivers/hapticmaster/fake_controller.h"

namespace felt::hapticmaster {

/// The driver's end of a connection to the fake controller, and its guard.
class FakeStream final : public ByteStream {
 public:
  explicit FakeStream(FakeController& controller)
      : controller_(controller), port_(std::make_unique<FakeController::Port>(controller)) {}
  ~FakeStream() override {
    if (port_->is_guard_alive_) port_->act_as_guard();
  }

  tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                       std::int64_t) noexcept override {
    if (!port_->is_open()) return tl::unexpected(StreamFault::kClosed);
    if (controller_.refusals_ > 0) {
      --controller_.refusals_;
      return tl::unexpected(StreamFault::kTimedOut);
    }
    if (!port_->take(bytes)) return tl::unexpected(StreamFault::kClosed);
    return {};
  }
  tl::expected<std::size_t, StreamFault> receive(std::span<std::byte> room,
                                                 std::int64_t within_ns) noexcept override {
    std::string& out = port_->out();
    if (out.empty() && port_->is_open() && within_ns > 0) controller_.pass_time(within_ns);
    if (out.empty()) {
      return tl::unexpected(port_->is_open() ? StreamFault::kTimedOut : StreamFault::kClosed);
    }
    std::size_t count = std::min(room.size(), out.size());
    if (controller_.options_.piece > 0) count = std::min(count, controller_.options_.piece);
    const auto bytes = std::as_bytes(std::span(out)).first(count);
    std::copy(bytes.begin(), bytes.end(), room.begin());
    out.erase(0, count);
    return count;
  }
  bool keep_guard(std::span<const std::byte> last_words, std::int64_t patience_ns) override {
    if (controller_.options_.refuses_guard) return false;
    port_->last_words_.assign(reinterpret_cast<const char*>(last_words.data()), last_words.size());
    port_->patience_ns_ = patience_ns;
    port_->is_guard_alive_ = true;
    return true;
  }
  void beat() noexcept override {
    port_->has_beaten_ = true;
    port_->beat_ns_ = controller_.now_ns_ + controller_.idle_ns_;
  }
  void let_guard_speak() noexcept override {
    if (port_->is_guard_alive_) port_->act_as_guard();
  }
  void let_guard_rest() noexcept override { port_->has_beaten_ = false; }
  [[nodiscard]] bool is_guarded() const noexcept override {
    return port_->is_guard_alive_ && port_->is_open();
  }

 private:
  FakeController& controller_;
  std::unique_ptr<FakeController::Port> port_;
};

}  // namespace felt::hapticmaster
