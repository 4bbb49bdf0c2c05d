#pragma once

/// Who may call what, checked by clang at compile time (-Wthread-safety, on in our clang builds).
///
/// A role is a capability that nobody locks. RealtimeScope takes the haptic role for its block, and
/// a function that needs it says FELT_HAPTIC. A function of the edit side says FELT_NOT_HAPTIC, and
/// calling it while the haptic role is held is a warning: the edit side's own code needs no mark.
/// Direct calls only; the interposer of tests/devices/rt sees the rest.
#if defined(__clang__)
#define FELT_ROLE_ATTRIBUTE(x) __attribute__((x))
#else
#define FELT_ROLE_ATTRIBUTE(x)
#endif

/// Runs on the haptic thread, inside a RealtimeScope.
#define FELT_HAPTIC FELT_ROLE_ATTRIBUTE(requires_capability(::felt::kHapticRole))
/// Must not be called from within the tick.
#define FELT_NOT_HAPTIC FELT_ROLE_ATTRIBUTE(locks_excluded(::felt::kHapticRole))
/// Runs on the edit thread, inside an EditScope, where a block wants to say so.
#define FELT_EDIT FELT_ROLE_ATTRIBUTE(requires_capability(::felt::kEditRole))
/// Must not be called from a block that is marked as the edit side's.
#define FELT_NOT_EDIT FELT_ROLE_ATTRIBUTE(locks_excluded(::felt::kEditRole))

/// On functions that never block: clang 20 and later check it (-Wfunction-effects); after noexcept.
#if defined(__clang__) && defined(__has_cpp_attribute)
#if __has_cpp_attribute(clang::nonblocking)
#define FELT_NONBLOCKING [[clang::nonblocking]]
#endif
#endif
#ifndef FELT_NONBLOCKING
#define FELT_NONBLOCKING
#endif

namespace felt {

/// A thread's part, as something that clang's analysis can hold. Empty: nothing happens at run
/// time.
class FELT_ROLE_ATTRIBUTE(capability("role")) ThreadRole {};

inline constexpr ThreadRole kHapticRole{};
inline constexpr ThreadRole kEditRole{};

/// Says that a block is the edit side's: it then may call FELT_EDIT, and no FELT_NOT_EDIT.
class FELT_ROLE_ATTRIBUTE(scoped_lockable) EditScope {
 public:
  // Written out, for the analysis does not see the calls of trivial ones.
  EditScope() noexcept FELT_ROLE_ATTRIBUTE(  // NOLINT(modernize-use-equals-default)
      exclusive_lock_function(kEditRole)) {}
  ~EditScope() noexcept FELT_ROLE_ATTRIBUTE(  // NOLINT(modernize-use-equals-default)
      unlock_function()) {}
  EditScope(const EditScope&) = delete;
  EditScope& operator=(const EditScope&) = delete;
};

}  // namespace felt
