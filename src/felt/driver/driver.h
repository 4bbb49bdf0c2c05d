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

/// A short text that is copied as bytes, so that the haptic thread can hand a vendor's own words
/// over. What does not fit is cut at the end, never inside a UTF-8 character.
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

/// How an open device is. Trivially copyable: made on the haptic thread, read on the edit side
/// through a LatestValue.
struct DeviceStatus {
  std::optional<DeviceFault> fault;         ///< that holds at present; none: it reads and writes
  std::optional<DeviceFault> last_fault;    ///< the newest one, though it be over
  ShortText vendor_words;                   ///< the maker's own text for the newest fault, verbatim
  std::int64_t vendor_code = 0;             ///< and its number
  ShortText notice;                         ///< its newest word that is no fault: a flat battery,
                                            ///< a filter of its own that acts on our forces
  std::uint64_t faults = 0;                 ///< since it was opened
  std::uint64_t reads = 0;                  ///< that succeeded, since it was opened
  std::optional<double> motor_temperature;  ///< 0 cold .. 1 too warm, the warmest motor
  double rate_hz = 0.0;  ///< that the device itself says it is served at; 0 = says nothing
};

/// What kind of output a device has (architecture section 5).
enum class DeviceKind : std::uint8_t {
  kForce,  ///< reads a pose and takes newtons: opened by Driver::open
  kCue,    ///< plays waveforms: opened by Driver::open_cue
};

/// A device that a driver knows of, open or not.
struct DeviceDescriptor {
  /// "driver:what", unique on this machine and the same each time it is plugged in; what settings
  /// keep and `--device` takes: "haply:049D", "openhaptics:default".
  std::string id;
  std::string driver;  ///< "openhaptics"
  DeviceKind kind = DeviceKind::kForce;
  std::string label;    ///< for people: "3D Systems Touch"
  std::string model;    ///< row of device_models(); empty: unknown
  std::string serial;   ///< empty: unknown
  std::string version;  ///< of library, service or firmware, as it says; empty: unknown
  /// It is known to be connected. False: the vendor has no way to look, only opening tells.
  bool is_connected = true;
  /// It says where it is in a frame of its own: the drawing plane must be shown to it.
  bool has_own_frame = true;
  Capabilities capabilities;  ///< as far as they are known while it is closed
};

/// What a device needs before it knows where it is.
enum class Homing : std::uint8_t {
  kNone,      ///< it knows
  kByItself,  ///< its arm moves: hands off, and only when a person agrees
  kRestPose,  ///< a person brings the arm to its rest pose
  kInkwell,   ///< a person puts the stylus into its inkwell
};

struct OpenOptions {
  /// A device that moves in the plane only cannot tell whether its pen touches: it does from the
  /// beginning, or not before DriverDevice::set_pen_down() says so (a key that is held).
  bool pen_begins_down = true;
};

/// A device that a driver has opened; closed by its destructor, without force.
///
/// Its frame is the device's own, in mm and N, with its axes as the maker has them: a
/// `OpenDevice` maps it to the sheet. A device that takes no force at present (its button, a
/// guard, warm motors) is still read: write() says kForcesOff or kOverheated then, read() goes on,
/// and so does the drawing. Threads: read(), write(), stop() as in Device; the rest
/// on the edit thread. Once read() has said kDisconnected it says so for ever: whoever owns it
/// closes it, and opens what Driver::find() sees again. A force bound of its own (ForceGate) stands
/// behind the safety chain: nothing makes it ask for more than its model's row allows.
class DriverDevice : public Device {
 public:
  [[nodiscard]] virtual const DeviceDescriptor& descriptor() const noexcept = 0;
  [[nodiscard]] bool is_arm() const noexcept override { return true; }
  /// The newest; cheap.
  [[nodiscard]] virtual DeviceStatus status() noexcept = 0;
  /// The maker's own servo loop, which must run this device; null: any thread may.
  [[nodiscard]] virtual LoopHost* loop_host() noexcept { return nullptr; }
  /// Does its pen touch? For a device that cannot tell by itself (sensed_axes is 2, no pressure):
  /// whoever has a key for it says so; its samples are then just below or above the plane, z =
  /// -0.25 or 0.25 mm of its own frame (more in a tick would be a jump). False: this one knows by
  /// itself, and nothing was done. Any thread.
  virtual bool set_pen_down(bool is_down) noexcept {
    static_cast<void>(is_down);
    return false;
  }
  /// What it needs before read() says anything but kNotCalibrated. While no loop runs.
  [[nodiscard]] virtual Homing homing() noexcept { return Homing::kNone; }
  /// What a person should do for it, or see happen; one or two sentences. Empty for kNone.
  [[nodiscard]] virtual std::string homing_words() { return {}; }
  /// Finds home: after a person said yes to kByItself, or while they hold it as asked. Blocks, some
  /// seconds at most. While no loop runs. Error: the maker's words, and what to try.
  virtual Result<void> find_home() { return {}; }
};

/// All that is known of one maker's way to talk to devices. Edit thread. Making one costs nothing
/// and touches nothing: libraries are loaded and ports opened when asked.
class Driver {
 public:
  Driver() = default;
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;
  virtual ~Driver() = default;

  /// "openhaptics", "forcedimension", "haply", "pantograph", "evdev", "cue".
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;
  /// For people: "3D Systems (OpenHaptics)".
  [[nodiscard]] virtual std::string_view label() const noexcept = 0;
  /// What is there now. Some ms at most, asked once a second while a list is shown; must not
  /// disturb what is open. Nothing where its library or service is missing: diagnose() says why.
  virtual std::vector<DeviceDescriptor> find() = 0;
  /// Opens a force device that find() gave. Error: what is wrong and the next step, with the
  /// maker's words; nothing moves, and nothing stays open.
  virtual Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                                     const OpenOptions& options) = 0;
  /// Likewise a cue device.
  virtual Result<std::unique_ptr<CueDevice>> open_cue(const DeviceDescriptor& device);
  /// How it usually stands on a desk: where the drawing plane lies until a person has shown it. The
  /// middle of what the device reaches there is the sheet's (0, 0). Here: a right-handed frame with
  /// x to the right, y up and z to the person, and the sheet upright before it, like an easel.
  [[nodiscard]] virtual PlaneCalibration default_plane(const DeviceDescriptor& device,
                                                       const OpenOptions& options) const {
    static_cast<void>(device), static_cast<void>(options);
    return *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}, {});
  }
  /// What is there, what is missing, and the exact next step, for a person who never heard of any
  /// of it; in the order in which one mends things. Looks at the system through `system` only.
  virtual std::vector<Finding> diagnose(const SystemView& system) = 0;
};

}  // namespace felt
