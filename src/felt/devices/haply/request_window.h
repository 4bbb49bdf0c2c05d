#pragma once

#include <cstdint>

namespace felt::haply {

/// Counts the messages that the service has not answered and limits their number, so that they do
/// not pile up in the service's socket, however slow the service is.
///
/// A message may be sent when all earlier ones are answered, with one exception: while a message
/// with a force is unanswered, a message without force may follow it immediately, to release the
/// force. So no more than kMaxUnanswered messages are unanswered at any time, at most one of them
/// carries a force, and if two are unanswered, the newer message carries no force.
///
///   window.wait(time since the last tick)
///   if (window.is_clear()) ...            any message may be sent
///   else if (window.may_release()) ...     a message without force may be sent
///   if (window.is_overdue()) ...          a message without force should be sent, to ask again
///
/// TCP loses nothing, but a service may answer several messages with one state. So the window waits
/// for an answer only for a limited time, the patience (initially kPatienceNs). When the patience
/// is over, there are two cases: if an answer has arrived since the newest message was sent, it
/// counts as the answer to all messages; otherwise, if only one message is unanswered, a message
/// without force asks again. In both cases the patience doubles. So if a service is merely slower
/// than the patience, the count is wrong only a few times, and up to four messages can then wait at
/// the service. None of these carries a force, because forces are off by then (ServicePace::kHoldNs
/// is shorter than kPatienceNs).
///
/// Used on the haptic thread; real-time safe.
class RequestWindow {
 public:
  static constexpr int kMaxUnanswered = 2;
  static constexpr std::int64_t kPatienceNs = 20'000'000;
  static constexpr std::int64_t kMaxPatienceNs = 16 * kPatienceNs;
  /// After this many answers in a row that came within the patience, the patience is reset to
  /// kPatienceNs.
  static constexpr int kPromptAnswers = 1000;

  void sent(bool bears_force) noexcept;
  void answered() noexcept;
  /// Advances the time by `ns`, the time since the last call.
  void wait(std::int64_t ns) noexcept;

  [[nodiscard]] bool is_clear() const noexcept { return unanswered_ == 0; }
  [[nodiscard]] bool may_release() const noexcept {
    return unanswered_ < kMaxUnanswered && bears_force_;
  }
  /// Returns true if no answer came within the patience and another message may ask again.
  [[nodiscard]] bool is_overdue() const noexcept {
    return unanswered_ == 1 && waited_ns_ >= patience_ns_;
  }

 private:
  int unanswered_ = 0;
  bool bears_force_ = false;    // the newest message carries a force
  bool has_answered_ = false;   // since the newest message
  std::int64_t waited_ns_ = 0;  // since the newest message or answer, while some are unanswered
  std::int64_t patience_ns_ = kPatienceNs;
  int prompt_answers_ = 0;
};

}  // namespace felt::haply
