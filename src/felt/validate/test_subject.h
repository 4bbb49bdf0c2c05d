#pragma once

#include <cstdint>
#include <string>

#include "felt/driver/open_device.h"

namespace felt {

/// A device under test. Edit thread.
class TestSubject {
 public:
  TestSubject() = default;
  TestSubject(const TestSubject&) = delete;
  TestSubject& operator=(const TestSubject&) = delete;
  virtual ~TestSubject() = default;

  /// Returns the device as it was last found.
  [[nodiscard]] virtual const DeviceDescriptor& descriptor() const noexcept = 0;
  /// Opens the device without homing it. Fails if the device cannot be opened.
  virtual Result<void> open() = 0;
  virtual void close() noexcept = 0;
  /// Returns the open device; null while it is closed.
  [[nodiscard]] virtual OpenDevice* device() noexcept = 0;
  /// Searches again, and returns true if the device is connected.
  virtual bool is_connected() = 0;
};

/// What the person at the device is asked to do.
enum class PersonTask : std::uint8_t {
  kAgreeToForces,  ///< agree to forces of up to 0.3 N
  kFindHome,       ///< home the device as it requires
  kLeaveAlone,     ///< take the hands off it
  kHoldStill,      ///< hold the pen in the air, as for writing, without moving
  kDrawCircles,    ///< small circles in the air, about one a second
  kDraw,           ///< draw on the surface as usual
  kUnplug,         ///< pull the cable when the test asks for it
  kReplug,         ///< plug it in again
};

/// The person at the device, or a simulation.
class TestPerson {
 public:
  TestPerson() = default;
  TestPerson(const TestPerson&) = delete;
  TestPerson& operator=(const TestPerson&) = delete;
  virtual ~TestPerson() = default;

  /// Asks for a task; `words` is a sentence or two. Returns true if the person does it from now on.
  /// Returns false if the person declines or nobody is there; checks that need it are then not
  /// possible.
  virtual bool does(PersonTask task, const std::string& words) = 0;
};

}  // namespace felt
