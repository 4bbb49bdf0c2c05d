#pragma once

#include <atomic>
#include <cstdint>
#include <string>

namespace felt::faults {

/// What happens to the chosen call.
enum class Mode : std::uint32_t {
  kNone,      ///< nothing; calls are only counted
  kEio,       ///< fails with EIO: the disk is failing
  kEnospc,    ///< fails with ENOSPC: the disk is full
  kEdquot,    ///< fails with EDQUOT: the user's disk quota is exhausted
  kEintr,     ///< fails with EINTR: a signal interrupted the call
  kShort,     ///< writes or reads half of the bytes, and returns that number
  kHalfKill,  ///< writes half of the bytes, then the process dies by SIGKILL
  kKill,      ///< the process dies by SIGKILL before the call
};
inline constexpr std::uint32_t kModeCount = 8;
const char* mode_name(Mode mode) noexcept;

/// Kinds of system calls that can fail.
enum class Call : std::uint32_t {
  kOpen,    ///< open without O_CREAT or O_TMPFILE
  kCreate,  ///< open that may create a file
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

/// State that the watched process reports. It stays readable after the process died.
enum class Outcome : std::uint32_t { kRunning, kOk, kError, kOutOfMemory, kTerminated };

/// One run: the settings of the interposer and its results. Lies in memory that the driver and the
/// watched process share.
struct FaultState {
  // Settings, written by the driver.
  char folder[256] = {};  ///< only files below this folder are watched
  Mode mode = Mode::kNone;
  std::uint32_t at = 0;     ///< number of the call that fails, counted from 1; 0: no call fails
  bool persistent = false;  ///< all later calls fail too
  bool memory = false;      ///< count and fail allocations instead of calls on files
  bool no_unnamed = false;  ///< the file system does not support O_TMPFILE
  bool read_only = false;   ///< nothing can be created or removed in the folder

  // Results of the interposer.
  std::atomic<bool> armed{false};
  std::atomic<std::uint32_t> seen{0};  ///< calls on watched files so far
  std::atomic<std::uint32_t> hits{0};  ///< number of these calls that were made to fail
  char hit_name[320] = {};             ///< the first failed call, like "fsync /tmp/x/a.felt"

  // Results of the scenario.
  std::atomic<std::uint32_t> started{0};       ///< last generation that it began to save
  std::atomic<std::uint32_t> acknowledged{0};  ///< last generation that it reported as saved
  Outcome outcome = Outcome::kRunning;
  char message[1024] = {};  ///< the first error

  void say_error(const std::string& text) noexcept;
};

/// State that controls the interposer. If null, the interposer only passes calls on.
extern FaultState* state;

/// Counts a call on a watched file. Returns true and sets errno if the call must fail. Kills the
/// process if the mode is kKill and this is the chosen call.
bool fails(Call call, const char* name, const char* path) noexcept;
/// Counts an allocation. Returns true and sets errno if the allocation must fail.
bool allocation_fails() noexcept;

}  // namespace felt::faults
