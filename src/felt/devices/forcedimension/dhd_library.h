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

/// Names that the library may have on this system, in the order in which they are tried: what the
/// person named, the SDK's folders ($FDSDK, $FORCEDIM_SDK, its lib/release/lin-MACHINE-COMPILER),
/// ~/.local/lib, /usr/local/lib, and what the system finds by name. libdrd before libdhd, since it
/// can find home by itself. `named` is the driver's option or $FELT_FORCEDIMENSION_LIBRARY; nothing
/// else is tried then.
std::vector<std::string> library_names(const SystemView& system, const std::string& named);

/// The functions. Those marked "or null" are absent from libdhd or from older libraries.
struct Api {
  GetDeviceCount* get_device_count = nullptr;
  OpenId* open_id = nullptr;  ///< drdOpenID where there is one
  Close* close = nullptr;     ///< likewise
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
  // All of DRD or none of it.
  IsTrue* drd_is_supported = nullptr;    ///< or null
  IsTrue* drd_is_initialized = nullptr;  ///< or null
  Simple* drd_auto_init = nullptr;       ///< or null
  DrdStop* drd_stop = nullptr;           ///< or null
  [[nodiscard]] bool has_drd() const noexcept { return drd_auto_init != nullptr; }
};

/// What a device says about itself.
struct Identity {
  int type = 0;
  std::string name;                      ///< as the library calls it; may be empty
  std::optional<unsigned short> serial;  ///< older devices have none
};

/// The library, loaded, and who has which device open. There is one of these for a file in a
/// program, whoever asks: the library itself hands the same device out twice, and closing it once
/// would close it for both. Edit thread, or any with a lock of its own inside.
class Library {
 public:
  /// Loads it, or gives the one that is loaded. Error: kNotFound with the loader's words for each
  /// name, kUnsupported where functions are missing.
  static Result<std::shared_ptr<Library>> load(const std::vector<std::string>& names);

  [[nodiscard]] const Api& api() const noexcept { return api_; }
  /// The file, and "3.17.5" or nothing.
  [[nodiscard]] std::string path() const { return library_.path(); }
  [[nodiscard]] std::string version() const;
  /// The calling thread's last error in the library's own words: "device already in use (error
  /// 20)".
  [[nodiscard]] std::string last_words() const;

  /// How many are connected, those of other programs too; negative is none.
  [[nodiscard]] int count() const;
  /// What the device at this place of the list is. Opens it for a moment when nobody here has it
  /// open; nothing moves. Error: it cannot be opened; the library's words.
  Result<Identity> identify(int index);
  /// Opens for good. Error: the library's words; kInvalidArgument: it is open in this program.
  Result<Id> open(int index);
  void close(Id id) noexcept;
  /// How often one was closed: another one may be in its place since.
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
