#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace felt::hapticmaster {

/// The requests of a tick.
enum class Request : std::uint8_t {
  kVelocity,  ///< get modelvel
  kPosition,  ///< get measpos
  kState,     ///< get state
  kForce,     ///< sets a force
  kRelease,   ///< sets the force to zero
  kOff,       ///< set state off
};

/// The requests that the controller has not answered, in order, so that each answer can be matched
/// with its request. Limits their number, so that they do not pile up in the controller's socket,
/// however slow the controller is: at most one of each kind is unanswered, and a force is sent only
/// if no earlier force or release is unanswered. So a release never waits for an answer, and the
/// newest command in the socket is the one that counts. Real-time safe.
class RequestQueue {
 public:
  static constexpr std::size_t kMaxUnanswered = 6;

  struct Sent {
    Request request = Request::kPosition;
    std::int64_t time_ns = 0;  ///< on the clock of the loop
    std::int64_t sum_ns = 0;   ///< the sum of the times of all ticks (LoopTime)
  };

  [[nodiscard]] bool may_send(Request request) const noexcept {
    if (request == Request::kForce && has(Request::kRelease)) return false;
    return !has(request) && count_ < kMaxUnanswered;
  }
  /// Requires may_send(sent.request).
  void add(const Sent& sent) noexcept {
    if (count_ < kMaxUnanswered) sent_[count_++] = sent;
  }
  /// Removes and returns the oldest request, which the next answer belongs to; nullopt if the
  /// controller has answered everything.
  std::optional<Sent> answered() noexcept {
    if (count_ == 0) return std::nullopt;
    const Sent oldest = sent_[0];
    --count_;
    for (std::size_t i = 0; i < count_; ++i) sent_[i] = sent_[i + 1];
    return oldest;
  }
  [[nodiscard]] bool has(Request request) const noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      if (sent_[i].request == request) return true;
    }
    return false;
  }
  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }

 private:
  std::array<Sent, kMaxUnanswered> sent_{};
  std::size_t count_ = 0;
};

}  // namespace felt::hapticmaster
