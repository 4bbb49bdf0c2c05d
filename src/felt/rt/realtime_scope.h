#pragma once

#include "felt/rt/thread_roles.h"

#ifdef FELT_RTSAN
extern "C" {
void __rtsan_realtime_enter();
void __rtsan_realtime_exit();
}
#endif

namespace felt {

/// The number of RealtimeScopes that this thread is in, read by the interposer of tests/devices/rt.
/// The TLS model is initial-exec so that reading it calls no function, even if the library is part
/// of a plug-in.
#if defined(__GNUC__)
__attribute__((tls_model("initial-exec")))
#endif
inline constinit thread_local int realtime_depth = 0;

/// Marks a block in which nothing may block: one tick of the haptic loop. Costs two additions. The
/// block is checked by an interposer in tests/devices/rt and, with FELT_RTSAN, by
/// RealtimeSanitizer.
class FELT_ROLE_ATTRIBUTE(scoped_lockable) RealtimeScope {
 public:
  RealtimeScope() noexcept FELT_ROLE_ATTRIBUTE(exclusive_lock_function(kHapticRole)) {
    ++realtime_depth;
#ifdef FELT_RTSAN
    __rtsan_realtime_enter();
#endif
  }
  ~RealtimeScope() noexcept FELT_ROLE_ATTRIBUTE(unlock_function()) {
#ifdef FELT_RTSAN
    __rtsan_realtime_exit();
#endif
    --realtime_depth;
  }
  RealtimeScope(const RealtimeScope&) = delete;
  RealtimeScope& operator=(const RealtimeScope&) = delete;
};

}  // namespace felt
