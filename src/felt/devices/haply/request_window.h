#pragma once

#include <cstdint>

namespace felt::haply {

/// Counts the messages that the service has not answered, so that none pile up before it, however
/// slow it is.
///
/// A message goes when all before it are answered. There is one exception: while a message with a
/// force is unanswered, one without may follow it at once, to let go. So at most one message with a
/// force is under way, at most kMaxUnanswered in all that count, and the newest of two never bears
/// a force.
///
///   window.wait(time since the last tick)
///   if (window.is_clear()) ...                     any message may go
///   else if (window.may_let_go()) ...              one without force may go
///   if (window.is_overdue()) ...                   one without force should go, to ask again
///
/// TCP loses nothing, but a service may answer several messages with one state. After kPatienceNs
/// without an answer one message without force asks again. If an answer has come since the newest
/// message, what is missing then counts as answered by it. The patience doubles each time, so that
/// a service that is merely slower than the patience is miscounted a few times: up to four messages
/// can then wait before it. None of them bears a force, because forces are off by then
/// (ServicePace::kHoldNs is shorter than the patience).
///
/// Haptic thread; real-time safe.
class RequestWindow {
 public:
  static constexpr int kMaxUnanswered = 2;
  static constexpr std::int64_t kPatienceNs = 20'000'000;
  static constexpr std::int64_t kMaxPatienceNs = 16 * kPatienceNs;
  /// Messages in a row that were answered before the patience ended, until it is short again.
  static constexpr int kPromptAnswers = 1000;

  void sent(bool bears_force) noexcept;
  void answered() noexcept;
  /// Time goes on.
  void wait(std::int64_t ns) noexcept;

  [[nodiscard]] bool is_clear() const noexcept { return unanswered_ == 0; }
  [[nodiscard]] bool may_let_go() const noexcept {
    return unanswered_ < kMaxUnanswered && bears_force_;
  }
  /// True if nothing came for the patience and another message may still ask.
  [[nodiscard]] bool is_overdue() const noexcept {
    return unanswered_ == 1 && waited_ns_ >= patience_ns_;
  }

 private:
  int unanswered_ = 0;
  bool bears_force_ = false;    // the newest message
  bool has_answered_ = false;   // since the newest message
  std::int64_t waited_ns_ = 0;  // since the newest message or answer, while some are unanswered
  std::int64_t patience_ns_ = kPatienceNs;
  int prompt_answers_ = 0;
};

}  // namespace felt::haply
