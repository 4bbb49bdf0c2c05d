#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "felt/base/result.h"
#include "felt/devices/openhaptics/hd_abi.h"
#include "felt/driver/dynamic_library.h"

namespace felt {

/// The functions of libHD that we call, under our own names.
struct HdFunctions {
  hd::Handle (*init_device)(const char* name);
  void (*disable_device)(hd::Handle);
  void (*begin_frame)(hd::Handle);
  void (*end_frame)(hd::Handle);
  hd::ErrorInfo (*get_error)();
  const char* (*error_words)(hd::Enum);
  void (*enable)(hd::Enum);
  void (*disable)(hd::Enum);
  unsigned char (*is_enabled)(hd::Enum);
  void (*get_booleans)(hd::Enum, unsigned char*);
  void (*get_integers)(hd::Enum, int*);
  void (*get_doubles)(hd::Enum, double*);
  void (*set_doubles)(hd::Enum, const double*);
  const char* (*get_string)(hd::Enum);
  hd::Enum (*check_calibration)();
  void (*update_calibration)(hd::Enum style);
  void (*start_scheduler)();
  void (*stop_scheduler)();
  void (*set_scheduler_rate)(unsigned long hz);
  hd::CallbackHandle (*schedule)(hd::Callback, void*, unsigned short priority);
  void (*unschedule)(hd::CallbackHandle);
};

/// The loaded libHD. The library has one scheduler and one current device per process. Therefore
/// loading the same file again returns the same object, and only one of its devices can be open at
/// a time. The library is never unloaded, because its threads may still run after our last call.
///
/// Used on the edit thread, except call().
class HdLibrary {
 public:
  /// Loads the first of `names` that can be loaded and has all functions.
  static Result<std::shared_ptr<HdLibrary>> load(std::span<const std::string> names);

  HdLibrary(const HdLibrary&) = delete;
  HdLibrary& operator=(const HdLibrary&) = delete;

  [[nodiscard]] const HdFunctions& call() const noexcept { return functions_; }
  [[nodiscard]] std::string path() const { return library_.path(); }

  /// Reserves the library for the one device that may be open, until give_back(). Returns false if
  /// the library is already reserved.
  bool take() noexcept;
  void give_back() noexcept { is_taken_ = false; }
  [[nodiscard]] bool is_taken() const noexcept { return is_taken_; }

 private:
  explicit HdLibrary(DynamicLibrary library) noexcept : library_(std::move(library)) {}
  Result<void> find_functions();

  DynamicLibrary library_;
  HdFunctions functions_{};
  bool is_taken_ = false;
};

/// Removes up to `max_count` errors from the library's stack, newest first. Calls `each(info)` for
/// each removed error and returns their number. May be called on every thread that may call the
/// library.
template <class Each>
std::size_t drain_errors(const HdFunctions& call, std::size_t max_count, Each&& each) {
  std::size_t count = 0;
  for (; count < max_count; ++count) {
    const hd::ErrorInfo info = call.get_error();
    if (info.code == hd::error::kNone) break;
    each(info);
  }
  return count;
}

/// Removes all of the library's errors and returns them, oldest first, with the library's text:
/// "communication error (0x302, internal 7)". Returns an empty string if there were no errors.
std::string drained_words(const HdFunctions& call);

/// Sets the "C" locale for numbers on this thread while the object exists. The library reads its
/// configuration files with the decimal separator of the calling thread's locale; if that is a
/// comma, the joint angles are wrong.
class PlainNumbers {
 public:
  PlainNumbers() noexcept;
  ~PlainNumbers() noexcept;
  PlainNumbers(const PlainNumbers&) = delete;
  PlainNumbers& operator=(const PlainNumbers&) = delete;
  /// Sets the "C" locale permanently on the calling thread, which must be a thread of the library.
  /// Real-time safe.
  static void keep() noexcept;
  /// Allocates the memory for keep() and for objects of this class. Call it first, on the edit
  /// thread.
  static void prepare() noexcept;

 private:
  void* before_;
};

}  // namespace felt
