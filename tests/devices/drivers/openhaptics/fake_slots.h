#pragma once

#include <string>

#include "tests/devices/drivers/openhaptics/fake_libhd.h"

namespace felt {

/// A fake libHD for one user. The state of a libHD belongs to its file, so that whoever wants one
/// beside another takes another copy of the file; there are kFakeLibraries of them.
class FakeSlot {
 public:
  /// Takes a free one and resets it. Ends the program when all are taken.
  FakeSlot();
  ~FakeSlot();
  FakeSlot(const FakeSlot&) = delete;
  FakeSlot& operator=(const FakeSlot&) = delete;

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  const FakeHdControl* operator->() const noexcept { return control_; }

 private:
  std::size_t index_;
  std::string path_;
  const FakeHdControl* control_ = nullptr;
};

}  // namespace felt
