#include "felt/tools/pencil/modifier_hold.h"

#include "felt/tools/gesture_tool.h"

namespace felt {

void ModifierHold::begin() noexcept {
  was_long_ = has_second_ = false;
  is_since_touch_ = true;
}

void ModifierHold::update(const PenSample& sample) noexcept {
  const bool was_held = is_held_;
  is_held_ = (sample.buttons & (kFirstModifier | kSecondModifier)) != 0;
  if (!is_held_) {
    is_since_touch_ = false;
    return;
  }
  if (!was_held) since_ns_ = sample.time_ns;
  was_long_ = was_long_ || seconds_between(since_ns_, sample.time_ns, kMeantS) >= kMeantS;
  has_second_ = (sample.buttons & kSecondModifier) != 0;
}

}  // namespace felt
