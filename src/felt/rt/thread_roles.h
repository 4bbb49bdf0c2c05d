#pragma once

/// Macros and types that say which thread may call a function. Clang checks them at compile time
/// (-Wthread-safety, enabled in our clang builds).
///
/// A role is a capability without a lock. RealtimeScope acquires the haptic role for its scope, and
/// a function that requires this role is marked FELT_HAPTIC. A function of the edit thread is
/// marked FELT_NOT_HAPTIC, and clang warns if it is called while the haptic role is held. So most
/// code of the edit thread needs no EditScope. Clang checks direct calls only. The interposer of
/// tests/devices/rt also finds blocking calls that a tick makes indirectly.
#if defined(__clang__)
#define FELT_ROLE_ATTRIBUTE(x) __attribute__((x))
#else
#define FELT_ROLE_ATTRIBUTE(x)
#endif

/// Marks a function that runs on the haptic thread, inside a RealtimeScope.
#define FELT_HAPTIC FELT_ROLE_ATTRIBUTE(requires_capability(::felt::kHapticRole))
/// Marks a function that must not be called from within the tick.
#define FELT_NOT_HAPTIC FELT_ROLE_ATTRIBUTE(locks_excluded(::felt::kHapticRole))
/// Marks a function that runs on the edit thread, inside an EditScope.
#define FELT_EDIT FELT_ROLE_ATTRIBUTE(requires_capability(::felt::kEditRole))
/// Marks a function that must not be called inside an EditScope.
#define FELT_NOT_EDIT FELT_ROLE_ATTRIBUTE(locks_excluded(::felt::kEditRole))

/// Marks a function that never blocks; write it after noexcept. Clang 20 and later check it
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

/// The role of a thread, as a capability that clang's analysis can track. The class is empty and
/// has no effect at run time.
class FELT_ROLE_ATTRIBUTE(capability("role")) ThreadRole {};

inline constexpr ThreadRole kHapticRole{};
inline constexpr ThreadRole kEditRole{};

/// Declares that the enclosing scope runs on the edit thread: it may call FELT_EDIT functions, but
/// not FELT_NOT_EDIT functions.
class FELT_ROLE_ATTRIBUTE(scoped_lockable) EditScope {
 public:
  // Not defaulted, because the analysis ignores calls of trivial constructors and destructors.
  EditScope() noexcept FELT_ROLE_ATTRIBUTE(  // NOLINT(modernize-use-equals-default)
      exclusive_lock_function(kEditRole)) {}
  ~EditScope() noexcept FELT_ROLE_ATTRIBUTE(  // NOLINT(modernize-use-equals-default)
      unlock_function()) {}
  EditScope(const EditScope&) = delete;
  EditScope& operator=(const EditScope&) = delete;
};

}  // namespace felt
