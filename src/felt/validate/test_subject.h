#pragma once

#include <cstdint>
#include <string>

#include "felt/driver/open_device.h"

namespace felt {

/// A device under test, as the test handles it. Edit thread.
class TestSubject {
 public:
  TestSubject() = default;
  TestSubject(const TestSubject&) = delete;
  TestSubject& operator=(const TestSubject&) = delete;
  virtual ~TestSubject() = default;

  /// As it was found last.
  [[nodiscard]] virtual const DeviceDescriptor& descriptor() const noexcept = 0;
  /// Opens it, without finding its home. Error: why not.
  virtual Result<void> open() = 0;
  virtual void close() noexcept = 0;
  /// Null while it is closed.
  [[nodiscard]] virtual OpenDevice* device() noexcept = 0;
  /// Returns true if it is connected now. Looks again.
  virtual bool is_connected() = 0;
};

/// What the person at the device is asked to do.
enum class PersonTask : std::uint8_t {
  kAgreeToForces,  ///< to forces of up to 0.3 N
  kFindHome,       ///< as the device wants it
  kLeaveAlone,     ///< nobody touches it
  kHoldStill,      ///< hold the pen in the air, as for writing, without moving
  kDrawCircles,    ///< small circles in the air, about one a second
  kDraw,           ///< draw on the sheet as one does
  kUnplug,         ///< pull the cable once the test says so
  kReplug,         ///< and put it back
};

/// The person, or what stands for one.
class TestPerson {
 public:
  TestPerson() = default;
  TestPerson(const TestPerson&) = delete;
  TestPerson& operator=(const TestPerson&) = delete;
  virtual ~TestPerson() = default;

  /// Asks; `words` is a sentence or two. True when they do it from now on. False: they would
  /// rather not, or nobody is there: what needs it is not possible.
  virtual bool does(PersonTask task, const std::string& words) = 0;
};

}  // namespace felt
