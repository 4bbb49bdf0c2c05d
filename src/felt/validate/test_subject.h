#pragma once

#include <cstdint>
#include <string>

#include "felt/driver/open_device.h"

namespace felt {

/// A device under test. Edit thread only.
class TestSubject {
 public:
  TestSubject() = default;
  TestSubject(const TestSubject&) = delete;
  TestSubject& operator=(const TestSubject&) = delete;
  virtual ~TestSubject() = default;

  /// Returns the descriptor of the device as of the last search.
  [[nodiscard]] virtual const DeviceDescriptor& descriptor() const noexcept = 0;
  /// Opens the device without homing it. Fails if the device cannot be opened.
  virtual Result<void> open() = 0;
  virtual void close() noexcept = 0;
  /// Returns the open device, or null while it is closed.
  [[nodiscard]] virtual OpenDevice* device() noexcept = 0;
  /// Searches for the device again. Returns true if it is connected.
  virtual bool is_connected() = 0;
};

/// A task for the person at the device.
enum class PersonTask : std::uint8_t {
  kAgreeToForces,  ///< agree to forces of up to 0.3 N
  kFindHome,       ///< home the device as it requires
  kLeaveAlone,     ///< take the hands off the device
  kHoldStill,      ///< hold the pen in the air, as for writing, without moving
  kDrawCircles,    ///< draw small circles in the air, about one a second
  kDraw,           ///< draw on the surface as usual
  kUnplug,         ///< disconnect the cable when the test asks for it
  kReplug,         ///< connect the cable again
};

/// The person at the device, or a simulation.
class TestPerson {
 public:
  TestPerson() = default;
  TestPerson(const TestPerson&) = delete;
  TestPerson& operator=(const TestPerson&) = delete;
  virtual ~TestPerson() = default;

  /// Asks the person to do a task. `words` is one or two sentences for the person. Returns true if
  /// the person does it from now on. Returns false if the person declines or nobody is there;
  /// checks that need the task are then not possible.
  virtual bool does(PersonTask task, const std::string& words) = 0;
};

}  // namespace felt
