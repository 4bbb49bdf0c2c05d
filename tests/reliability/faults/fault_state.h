#pragma once

#include <atomic>
#include <cstdint>
#include <string>

namespace felt::faults {

/// What befalls the chosen call.
enum class Mode : std::uint32_t {
  kNone,      ///< calls are counted only
  kEio,       ///< fails by EIO: the disk is failing
  kEnospc,    ///< fails by ENOSPC: the disk is full
  kEdquot,    ///< fails by EDQUOT: the person's share of it is full
  kEintr,     ///< fails by EINTR: a signal came
  kShort,     ///< writes or reads half of what was asked for, and says so
  kHalfKill,  ///< writes half, and the process dies by SIGKILL
  kKill,      ///< the process dies by SIGKILL before the call
};
inline constexpr std::uint32_t kModeCount = 8;
const char* mode_name(Mode mode) noexcept;

/// What can fail.
enum class Call : std::uint32_t {
  kOpen,    ///< of a file that is there
  kCreate,  ///< open that makes one
  kRead,
  kLook,  ///< stat, access, opendir
  kWrite,
  kSync,
  kRename,
  kLink,
  kUnlink,
  kTruncate,
  kAllocate,   ///< fallocate
  kFolder,     ///< mkdir
  kAttribute,  ///< mode, owner, extended attributes
  kClose,
};

/// What the watched process says of itself; survives its death.
enum class Outcome : std::uint32_t { kRunning, kOk, kError, kOutOfMemory, kTerminated };

/// One run: the order to the interposer, and what comes back. Lies in memory shared between the
/// driver and the watched process.
struct FaultState {
  // The order.
  char folder[256] = {};  ///< only files below it are watched
  Mode mode = Mode::kNone;
  std::uint32_t at = 0;     ///< number of the call that fails, from 1; 0: none
  bool persistent = false;  ///< all later ones fail too
  bool memory = false;      ///< allocations are what is counted and fails, not files
  bool no_unnamed = false;  ///< the file system has no O_TMPFILE
  bool read_only = false;   ///< nothing can be made or removed in the folder

  // What the interposer saw.
  std::atomic<bool> armed{false};
  std::atomic<std::uint32_t> seen{0};  ///< calls on watched files so far
  std::atomic<std::uint32_t> hits{0};  ///< of those, made to fail
  char hit_name[320] = {};             ///< the first that failed: "fsync /tmp/x/a.felt"

  // What the scenario says.
  std::atomic<std::uint32_t> started{0};       ///< last generation whose saving began
  std::atomic<std::uint32_t> acknowledged{0};  ///< last generation that was said to be saved
  Outcome outcome = Outcome::kRunning;
  char message[1024] = {};  ///< the first error

  void say_error(const std::string& text) noexcept;
};

/// What the interposer obeys; null: it does nothing but pass calls on.
extern FaultState* state;

/// Counts a call on a watched file and says whether it fails. Kills the process where asked to.
/// Sets errno when it says so.
bool fails(Call call, const char* name, const char* path) noexcept;
/// Likewise for an allocation.
bool allocation_fails() noexcept;

}  // namespace felt::faults
