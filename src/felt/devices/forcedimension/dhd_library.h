#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/forcedimension/dhd_abi.h"
#include "felt/driver/diagnosis.h"
#include "felt/driver/dynamic_library.h"

namespace felt::dhd {

/// Returns possible names of the library on this system, in the order in which they are tried: in
/// the SDK's folders ($FDSDK, $FORCEDIM_SDK, and lib/release/lin-MACHINE-COMPILER in them), in
/// ~/.local/lib and in /usr/local/lib, and last plain names, for which the system's loader
/// searches. libdrd comes before libdhd, because only libdrd can home a device by moving it.
/// `named` is the driver's option or $FELT_FORCEDIMENSION_LIBRARY; if it is set, only that name is
/// returned.
std::vector<std::string> library_names(const SystemView& system, const std::string& named);

/// The library's functions. A pointer marked "or null" is null if the function is absent, as in
/// libdhd or in older libraries.
struct Api {
  GetDeviceCount* get_device_count = nullptr;
  OpenId* open_id = nullptr;  ///< drdOpenID if it exists
  Close* close = nullptr;     ///< drdClose if it exists
  GetSystemType* get_system_type = nullptr;
  GetStatus* get_status = nullptr;
  Get3* get_position = nullptr;
  SetForce* set_force = nullptr;
  EnableForce* enable_force = nullptr;
  ErrorGetLast* error_get_last = nullptr;
  ErrorGetLastStr* error_get_last_str = nullptr;
  Simple* stop = nullptr;
  ExpertMode* enable_expert_mode = nullptr;
  ExpertMode* disable_expert_mode = nullptr;

  GetSystemName* get_system_name = nullptr;                              ///< or null
  GetSerialNumber* get_serial_number = nullptr;                          ///< or null
  GetSdkVersion* get_sdk_version = nullptr;                              ///< or null
  SetForceAndGripperForce* set_force_and_gripper = nullptr;              ///< or null
  SetForceAndTorqueAndGripperForce* set_force_torque_gripper = nullptr;  ///< or null
  GetButton* get_button = nullptr;                                       ///< or null
  GetButtonMask* get_button_mask = nullptr;                              ///< or null
  SetInt* set_gravity_compensation = nullptr;                            ///< or null
  SetDouble* set_effector_mass = nullptr;                                ///< or null
  SetWatchdog* set_watchdog = nullptr;                                   ///< or null
  GetWatchdog* get_watchdog = nullptr;                                   ///< or null
  GetComFreq* get_com_freq = nullptr;                                    ///< or null
  Simple* reset = nullptr;                                               ///< or null
  WaitForReset* wait_for_reset = nullptr;                                ///< or null
  // Either all functions of DRD are present, or all are null.
  IsTrue* drd_is_supported = nullptr;    ///< or null
  IsTrue* drd_is_initialized = nullptr;  ///< or null
  Simple* drd_auto_init = nullptr;       ///< or null
  DrdStop* drd_stop = nullptr;           ///< or null
  [[nodiscard]] bool has_drd() const noexcept { return drd_auto_init != nullptr; }
};

/// How a device identifies itself.
struct Identity {
  int type = 0;
  std::string name;                      ///< given by the library; may be empty
  std::optional<unsigned short> serial;  ///< nullopt for older devices
};

/// The loaded library with its open devices. A program has only one object per library file. This
/// is needed because the library lets two parts of a program open the same device; when one part
/// closes the device, it is closed for the other part, too. Safe to call from any thread, because
/// the object has its own lock.
class Library {
 public:
  /// Loads the library, or returns the existing object. Fails with kNotFound and the loader's text
  /// for each name if no library can be loaded, or with kUnsupported if functions are missing.
  static Result<std::shared_ptr<Library>> load(const std::vector<std::string>& names);

  [[nodiscard]] const Api& api() const noexcept { return api_; }
  /// path() returns the library's file. version() returns its version, for example "3.17.5", or an
  /// empty string if the version is unknown.
  [[nodiscard]] std::string path() const { return library_.path(); }
  [[nodiscard]] std::string version() const;
  /// Returns the calling thread's last error with the library's text: "device already in use (error
  /// 20)".
  [[nodiscard]] std::string last_words() const;

  /// Returns the number of connected devices, including those that other programs use. A negative
  /// number means that the library failed; treat it as 0.
  [[nodiscard]] int count() const;
  /// Identifies the device at this index of the library's list of devices. Opens it briefly if it
  /// is not open in this program; the arm does not move. Fails with the library's text if the
  /// device cannot be opened.
  Result<Identity> identify(int index);
  /// Opens a device. Fails with the library's text, or with kInvalidArgument if the device is
  /// already open in this program.
  Result<Id> open(int index);
  void close(Id id) noexcept;
  /// Returns how often a device was closed. Each time, the indices of devices in the list may
  /// change.
  [[nodiscard]] std::uint64_t closings() const noexcept { return closings_.load(); }

 private:
  struct Opened {
    Id id;
    Identity identity;
  };

  Library(DynamicLibrary library, const Api& api) : library_(std::move(library)), api_(api) {}
  [[nodiscard]] Identity ask_identity(Id id) const;
  [[nodiscard]] const Opened* find_open(Id id) const noexcept;

  DynamicLibrary library_;
  Api api_;
  mutable std::mutex lock_;
  std::vector<Opened> open_;
  std::atomic<std::uint64_t> closings_{0};
};

}  // namespace felt::dhd
