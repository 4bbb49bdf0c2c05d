#pragma once

#include "felt/rt/thread_roles.h"

#ifdef FELT_RTSAN
extern "C" {
void __rtsan_realtime_enter();
void __rtsan_realtime_exit();
}
#endif

namespace felt {

/// The number of RealtimeScopes that this thread is in. The interposer of tests/devices/rt reads
/// it. The TLS model is initial-exec so that reading it does not call a function, even if the
/// library is part of a plug-in.
#if defined(__GNUC__)
__attribute__((tls_model("initial-exec")))
#endif
inline constinit thread_local int realtime_depth = 0;

/// Marks a scope, one tick of the haptic loop, in which no call may block. The scope costs two
/// additions. An interposer in tests/devices/rt checks that no call blocks; with FELT_RTSAN,
/// RealtimeSanitizer checks this, too.
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
