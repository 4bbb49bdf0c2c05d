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
  std::optional<DeviceFault> last_fault;  ///< the newest fault, even if it is over
  ShortText vendor_words;                 ///< the maker's own text for the newest fault, verbatim
  std::int64_t vendor_code = 0;           ///< the maker's number of the newest fault
  ShortText notice;  ///< newest message that is not a fault, for example about a flat battery or a
                     ///< filter of the device that changes our forces
  std::uint64_t faults = 0;                 ///< number of faults since it was opened
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
  /// The id has the form "driver:what": "haply:049D", "openhaptics:default". It is unique on this
  /// machine and the same each time the device is plugged in. The settings and the option
  /// `--device` use this id.
  std::string id;
  std::string driver;  ///< "openhaptics"
  DeviceKind kind = DeviceKind::kForce;
  std::string label;    ///< for the user: "3D Systems Touch"
  std::string model;    ///< id of device_models(); empty if unknown
  std::string serial;   ///< empty if unknown
  std::string version;  ///< reported version of library, service or firmware; empty if unknown
  /// True if the device is known to be connected; false if the maker's software cannot check that
  /// without opening it.
  bool is_connected = true;
  /// True if the device has its own frame, so that the user must calibrate the drawing plane.
  bool has_own_frame = true;
  Capabilities capabilities;  ///< as far as they are known while the device is closed
};

/// How a device finds its reference position.
enum class Homing : std::uint8_t {
  kNone,      ///< homing is not needed
  kByItself,  ///< the arm moves by itself; the user must agree first, and must not touch it
  kRestPose,  ///< the user moves the arm to its rest pose
  kInkwell,   ///< the user puts the stylus into its inkwell
};

struct OpenOptions {
  /// For a device that moves only in the plane and cannot sense contact: if true, the pen is down
  /// from the start. If false, it is up at the start; the program calls
  /// DriverDevice::set_pen_down(true) when the user presses a key, and set_pen_down(false) when the
  /// user releases it.
  bool pen_begins_down = true;
};

/// A device that a driver has opened. The destructor sets the force to zero and closes the device.
///
/// Values are in the device's own frame, in mm and N, with the maker's axes; `OpenDevice` maps them
/// to the page. If a device accepts no force at the moment (its button, a guard, warm motors),
/// write() returns kForcesOff or kOverheated, but read() still works and drawing goes on. Once
/// read() has returned kDisconnected, it returns kDisconnected in every later call. The owner must
/// then close the device and open one that Driver::find() returns. Every driver limits the forces
/// once more (ForceGate) after the safety chain, so that no force exceeds the limits in
/// device_models(). read(), write() and stop() are used on the thread that Device requires, all
/// other functions on the edit thread.
class DriverDevice : public Device {
 public:
  [[nodiscard]] virtual const DeviceDescriptor& descriptor() const noexcept = 0;
  [[nodiscard]] bool is_arm() const noexcept override { return true; }
  /// Returns the newest status. This is cheap.
  [[nodiscard]] virtual DeviceStatus status() noexcept = 0;
  /// Returns the maker's servo loop if only that loop may run this device, or null if any thread
  /// may.
  [[nodiscard]] virtual LoopHost* loop_host() noexcept { return nullptr; }
  /// Sets whether the pen touches the surface, for a device that cannot sense contact (sensed_axes
  /// is 2, no pressure). In the device's frame, samples then have z = -0.25 mm while the pen
  /// touches, and 0.25 mm otherwise. (The safety chain would treat a larger step in one tick as a
  /// jump.) Returns false, and does nothing, if the device senses contact itself. Safe to call from
  /// any thread.
  virtual bool set_pen_down(bool is_down) noexcept {
    static_cast<void>(is_down);
    return false;
  }
  /// Returns how the device must be homed. Until it is homed, read() returns kNotCalibrated.
  /// Requires that no loop runs.
  [[nodiscard]] virtual Homing homing() noexcept { return Homing::kNone; }
  /// Returns one or two sentences for the user: how to home the device, or how the device will move
  /// during homing. Returns an empty string for kNone.
  [[nodiscard]] virtual std::string homing_words() { return {}; }
  /// Homes the device. For kByItself, call find_home() after the user has agreed; otherwise, call
  /// it while the user holds the device as homing_words() asks. Blocks for some seconds at most.
  /// Requires that no loop runs. Fails with the maker's message and a suggestion for the user.
  virtual Result<void> find_home() { return {}; }
};

/// The interface to one maker's devices. Constructing a driver is cheap, because libraries are
/// loaded and ports are opened only when they are needed. Used on the edit thread.
class Driver {
 public:
  Driver() = default;
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;
  virtual ~Driver() = default;

  /// Returns "openhaptics", "forcedimension", "haply", "pantograph", "hapticmaster", "evdev" or
  /// "cue".
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;
  /// Returns the name for the user: "3D Systems (OpenHaptics)".
  [[nodiscard]] virtual std::string_view label() const noexcept = 0;
  /// Returns the devices that are present, or an empty list if the maker's library or service is
  /// missing (see diagnose()). It is called once a second while the user sees a list of devices.
  /// Therefore it must return within a few milliseconds and must not disturb open devices.
  virtual std::vector<DeviceDescriptor> find() = 0;
  /// Opens a force device that find() returned. Fails with the reason, the maker's message and the
  /// next step for the user. If it fails, the device has not moved and is closed.
  virtual Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                                     const OpenOptions& options) = 0;
  /// Opens a cue device that find() returned. Fails like open().
  virtual Result<std::unique_ptr<CueDevice>> open_cue(const DeviceDescriptor& device);
  /// Returns the drawing plane that is used until the user has calibrated a plane. It assumes the
  /// usual position of the device on a desk. Its (0, 0) is the centre of the reachable part of the
  /// plane. The base class assumes a right-handed frame with x to the right, y up and z towards the
  /// user, and returns an upright page in front of the device, like an easel.
  [[nodiscard]] virtual PlaneCalibration default_plane(const DeviceDescriptor& device,
                                                       const OpenOptions& options) const {
    static_cast<void>(device), static_cast<void>(options);
    return *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}, {});
  }
  /// Returns findings about parts (device, software, permissions) that are present or missing, each
  /// with the exact next step for a user who knows nothing about drivers. They are in the order in
  /// which problems should be solved. Uses the system only through `system`.
  virtual std::vector<Finding> diagnose(const SystemView& system) = 0;
};

}  // namespace felt
