#pragma once

#include <cstdint>

#include "felt/haptics/pen_sample.h"

namespace felt {

/// Decides whether a modifier of the pen is meant for the line being drawn. A press that is too
/// short to be meant must not change the line, because what was drawn up to then would be lost.
///
/// Use: update() for each sample, in the air too; begin() before the first sample of a line.
class ModifierHold {
 public:
  /// A modifier that is held for so long is meant. A contact that bounces or is loose closes for
  /// some ms, at most a tenth of a second, and a key that is hit by accident is down for 0.1 to
  /// 0.15 s.
  static constexpr double kMeantS = 0.3;

  void begin() noexcept;
  void update(const PenSample& sample) noexcept;
  /// Forgets a press that began in the air. Call it if samples are left out.
  void reset() noexcept { is_held_ = false; }

  /// Returns true if a modifier was held for kMeantS without a break during the line, even if it
  /// was pressed before the touch or has been released since; or if it has been held at each sample
  /// of the line, so that a quick line needs no wait.
  [[nodiscard]] bool is_meant() const noexcept { return was_long_ || is_since_touch_; }
  /// Returns true if the second modifier was down when a modifier was held last.
  [[nodiscard]] bool has_second() const noexcept { return has_second_; }

 private:
  bool is_held_ = false;
  std::int64_t since_ns_ = 0;  // the first sample of this press
  bool was_long_ = false;
  bool is_since_touch_ = false;
  bool has_second_ = false;
};

}  // namespace felt
