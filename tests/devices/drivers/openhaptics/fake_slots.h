#pragma once

#include <string>

#include "tests/devices/drivers/openhaptics/fake_libhd.h"

namespace felt {

/// A fake libHD for one user. The state of a libHD belongs to its file, so a second libHD at the
/// same time needs another copy of the file. There are kFakeLibraries copies.
class FakeSlot {
 public:
  /// Takes a free copy and resets it. Ends the program if all are in use.
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
