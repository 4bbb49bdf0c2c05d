#include "felt/tools/pencil/rest_watch.h"

#include "felt/tools/gesture_tool.h"

namespace felt {

void RestWatch::begin(Point pen, std::int64_t time_ns) noexcept {
  at_ = pen;
  last_ns_ = time_ns;
  still_s_ = 0.0;
}

void RestWatch::update(Point pen, std::int64_t time_ns) noexcept {
  if (distance(pen, at_) > kRestMm) return begin(pen, time_ns);
  // A gap between samples says nothing about where the pen was, so it counts as a short step.
  constexpr double kMaxRestStepS = 0.1;
  still_s_ += seconds_between(last_ns_, time_ns, kMaxRestStepS);
  last_ns_ = time_ns;
}

}  // namespace felt
