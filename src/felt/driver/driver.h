#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/driver/diagnosis.h"
#include "felt/driver/plane_calibration.h"
#include "felt/haptics/capabilities.h"
#include "felt/rt/device.h"

namespace felt {

class CueDevice;

/// A short text without allocation, so that the haptic thread can pass on a vendor's message.
/// Longer text is cut at the end, never inside a UTF-8 character.
class ShortText {
 public:
  static constexpr std::size_t kBytes = 191;

  constexpr ShortText() noexcept = default;
  explicit constexpr ShortText(std::string_view text) noexcept {
    std::size_t size = std::min(text.size(), kBytes);
    while (size > 0 && size < text.size() &&
           (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80)
      --size;
    std::copy_n(text.begin(), size, bytes_.begin());
    size_ = static_cast<std::uint8_t>(size);
  }
  [[nodiscard]] constexpr std::string_view view() const noexcept { return {bytes_.data(), size_}; }
  [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
  friend constexpr bool operator==(const ShortText& a, const ShortText& b) noexcept {
    return a.view() == b.view();
  }

 private:
  std::array<char, kBytes> bytes_{};
  std::uint8_t size_ = 0;
};

/// The state of an open device. It is trivially copyable, because the haptic thread writes it and
/// the edit thread reads it through a LatestValue.
struct DeviceStatus {
  std::optional<DeviceFault> fault;       ///< the current fault; nullopt if the device works
  std::optional<DeviceFault> last_fault;  ///< the newest, even if it is over
  ShortText vendor_words;                 ///< the maker's own text for the newest fault, verbatim
  std::int64_t vendor_code = 0;           ///< the maker's number for it
  ShortText notice;  ///< newest message that is not a fault: a flat battery, a filter of the device
                     ///< that changes our forces
  std::uint64_t faults = 0;                 ///< since it was opened
  std::uint64_t reads = 0;                  ///< successful reads since it was opened
  std::optional<double> motor_temperature;  ///< 0 cold .. 1 too warm, the warmest motor
  double rate_hz = 0.0;                     ///< rate that the device reports; 0: unknown
};

/// The kind of output of a device (docs/design/devices.md#kinds-of-devices).
enum class DeviceKind : std::uint8_t {
  kForce,  ///< reports a pose and accepts forces: opened by Driver::open
  kCue,    ///< plays waveforms: opened by Driver::open_cue
};

/// A device that a driver has found, open or not.
struct DeviceDescriptor {
  /// "driver:what", unique on this machine and the same each time the device is plugged in. Used in
  /// settings and by `--device`: "haply:049D", "openhaptics:default".
  std::string id;
  std::string driver;  ///< "openhaptics"
  DeviceKind kind = DeviceKind::kForce;
  std::string label;    ///< for the user: "3D Systems Touch"
  std::string model;    ///< id of device_models(); empty: unknown
  std::string serial;   ///< empty: unknown
  std::string version;  ///< of library, service or firmware, as reported; empty: unknown
  /// True if it is known to be connected; false if the maker's software cannot check without
  /// opening it.
  bool is_connected = true;
  /// True if it reports positions in its own frame: the user must calibrate the drawing plane.
  bool has_own_frame = true;
  Capabilities capabilities;  ///< as far as known while it is closed
};

/// What a device needs to find its reference position.
enum class Homing : std::uint8_t {
  kNone,      ///< nothing
  kByItself,  ///< its arm moves by itself: hands off, and only if the user agrees
  kRestPose,  ///< the user moves the arm to its rest pose
  kInkwell,   ///< the user puts the stylus into its inkwell
};

struct OpenOptions {
  /// For a device that moves in the plane only and cannot sense contact: the pen starts down, or
  /// else stays up until DriverDevice::set_pen_down() is called (a key is held).
  bool pen_begins_down = true;
};

/// A device that a driver has opened. The destructor closes it, without force.
///
/// Values are in the device's own frame, in mm and N, with the maker's axes; `OpenDevice` maps them
/// to the page. If a device accepts no force at the moment (its button, a guard, warm motors),
/// write() returns kForcesOff or kOverheated, but read() still works and drawing goes on. After
/// read() has returned kDisconnected it does so permanently: the owner closes the device and opens
/// what Driver::find() returns. Every driver limits forces again behind the safety chain
/// (ForceGate), so that it never asks for more than its row of device_models() allows. Threads:
/// read(), write(), stop() as in Device; the rest on the edit thread.
class DriverDevice : public Device {
 public:
  [[nodiscard]] virtual const DeviceDescriptor& descriptor() const noexcept = 0;
  [[nodiscard]] bool is_arm() const noexcept override { return true; }
  /// Returns the newest status; cheap.
  [[nodiscard]] virtual DeviceStatus status() noexcept = 0;
  /// Returns the maker's own servo loop, which must run this device; null: any thread may.
  [[nodiscard]] virtual LoopHost* loop_host() noexcept { return nullptr; }
  /// Sets whether the pen touches, for a device that cannot sense it (sensed_axes is 2, no
  /// pressure). Samples are then just below or above the plane, z = -0.25 or 0.25 mm in the
  /// device's frame (a larger step in one tick would count as a jump). Returns false, and does
  /// nothing, if the device senses contact itself. Safe to call from any thread.
  virtual bool set_pen_down(bool is_down) noexcept {
    static_cast<void>(is_down);
    return false;
  }
  /// Returns what the device needs before read() returns anything but kNotCalibrated. Only while no
  /// loop runs.
  [[nodiscard]] virtual Homing homing() noexcept { return Homing::kNone; }
  /// Returns what the user should do for it, or will see happen, in one or two sentences. Empty for
  /// kNone.
  [[nodiscard]] virtual std::string homing_words() { return {}; }
  /// Homes the device: call it after the user agreed to kByItself, or while the user holds it as
  /// asked. Blocks for some seconds at most. Requires that no loop runs. Fails with the maker's
  /// message and what to try.
  virtual Result<void> find_home() { return {}; }
};

/// The interface to one maker's devices. Constructing one costs and touches nothing: libraries are
/// loaded and ports opened on demand. Used on the edit thread.
class Driver {
 public:
  Driver() = default;
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;
  virtual ~Driver() = default;

  /// "openhaptics", "forcedimension", "haply", "pantograph", "evdev", "cue".
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;
  /// For the user: "3D Systems (OpenHaptics)".
  [[nodiscard]] virtual std::string_view label() const noexcept = 0;
  /// Returns the devices that are present. Takes some ms at most and is called once a second while
  /// a list is shown; must not disturb open devices. Empty if the maker's library or service is
  /// missing: diagnose() says why.
  virtual std::vector<DeviceDescriptor> find() = 0;
  /// Opens a force device that find() returned. Fails with what is wrong, the maker's message and
  /// the next step; then nothing moves and nothing stays open.
  virtual Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                                     const OpenOptions& options) = 0;
  /// Opens a cue device; otherwise the same as open().
  virtual Result<std::unique_ptr<CueDevice>> open_cue(const DeviceDescriptor& device);
  /// Returns the drawing plane for the usual place of the device on a desk, until the user has
  /// calibrated one. The centre of the reachable part of the plane is the page's (0, 0). By
  /// default: a right-handed frame with x to the right, y up and z towards the user, and the page
  /// upright in front of the device, like an easel.
  [[nodiscard]] virtual PlaneCalibration default_plane(const DeviceDescriptor& device,
                                                       const OpenOptions& options) const {
    static_cast<void>(device), static_cast<void>(options);
    return *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}, {});
  }
  /// Returns what is present, what is missing, and the exact next step, for a user who knows
  /// nothing about drivers; in the order in which to fix things. Uses the system only through
  /// `system`.
  virtual std::vector<Finding> diagnose(const SystemView& system) = 0;
};

}  // namespace felt
