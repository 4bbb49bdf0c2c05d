#pragma once

/// Which thread may call what, checked by clang at compile time (-Wthread-safety, on in our clang
/// builds).
///
/// A role is a capability that is never locked. RealtimeScope acquires the haptic role for its
/// block, and a function that needs it is marked FELT_HAPTIC. A function of the edit thread is
/// marked FELT_NOT_HAPTIC, and calling it while the haptic role is held is a warning; so code of
/// the edit thread needs no scope of its own. Clang sees direct calls only; the interposer of
/// tests/devices/rt sees the rest.
#if defined(__clang__)
#define FELT_ROLE_ATTRIBUTE(x) __attribute__((x))
#else
#define FELT_ROLE_ATTRIBUTE(x)
#endif

/// Runs on the haptic thread, inside a RealtimeScope.
#define FELT_HAPTIC FELT_ROLE_ATTRIBUTE(requires_capability(::felt::kHapticRole))
/// Must not be called from within the tick.
#define FELT_NOT_HAPTIC FELT_ROLE_ATTRIBUTE(locks_excluded(::felt::kHapticRole))
/// Runs on the edit thread, inside an EditScope, if a block declares one.
#define FELT_EDIT FELT_ROLE_ATTRIBUTE(requires_capability(::felt::kEditRole))
/// Must not be called from a block that is marked as running on the edit thread.
#define FELT_NOT_EDIT FELT_ROLE_ATTRIBUTE(locks_excluded(::felt::kEditRole))

/// For functions that never block; write it after noexcept. Checked by clang 20 and later
/// (-Wfunction-effects).
#if defined(__clang__) && defined(__has_cpp_attribute)
#if __has_cpp_attribute(clang::nonblocking)
#define FELT_NONBLOCKING [[clang::nonblocking]]
#endif
#endif
#ifndef FELT_NONBLOCKING
#define FELT_NONBLOCKING
#endif

namespace felt {

/// The role of a thread, as a capability that clang's analysis can track. It is empty; nothing
/// happens at run time.
class FELT_ROLE_ATTRIBUTE(capability("role")) ThreadRole {};

inline constexpr ThreadRole kHapticRole{};
inline constexpr ThreadRole kEditRole{};

/// Declares that a block runs on the edit thread: it may call FELT_EDIT functions, but no
/// FELT_NOT_EDIT ones.
class FELT_ROLE_ATTRIBUTE(scoped_lockable) EditScope {
 public:
  // Not defaulted, because the analysis does not see calls of trivial ones.
  EditScope() noexcept FELT_ROLE_ATTRIBUTE(  // NOLINT(modernize-use-equals-default)
      exclusive_lock_function(kEditRole)) {}
  ~EditScope() noexcept FELT_ROLE_ATTRIBUTE(  // NOLINT(modernize-use-equals-default)
      unlock_function()) {}
  EditScope(const EditScope&) = delete;
  EditScope& operator=(const EditScope&) = delete;
};

}  // namespace felt
