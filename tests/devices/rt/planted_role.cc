// Clang compiles this file with and without FELT_PLANT. With FELT_PLANT, tick() makes a call that
// the thread roles forbid.
#include "felt/rt/realtime_scope.h"
#include "felt/rt/servo.h"

namespace felt {

void tick(Servo& servo, const ForceModel& model) noexcept {
  const RealtimeScope scope;
#ifdef FELT_PLANT
  servo.publish(model);
#else
  static_cast<void>(servo.options());
  static_cast<void>(model);
#endif
}

void edit(Servo& servo, const ForceModel& model) noexcept {
  servo.publish(model);
  servo.heartbeat(0);
}

}  // namespace felt
