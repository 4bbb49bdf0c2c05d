#pragma once

#include <memory>
#include <string>
#include <utility>

#include "felt/devices/cue/cue_driver.h"
#include "felt/driver/cue_device.h"
#include "tests/devices/drivers/cue/fake_haptics.h"

namespace felt {

inline constexpr const char* kPenKernel = "0018:045E:0C1B.0003";
inline constexpr const char* kMouseKernel = "0005:046D:B042.0004";
inline constexpr const char* kReceiverKernel = "0003:046D:C548.0005";
inline constexpr const char* kPadKernel = "0018:2808:0222.0006";
inline constexpr const char* kControllerKernel = "0003:045E:02EA.0007";

/// The fixture: a machine with a fake of each haptic device, and the driver.
struct CueFixture {
  FakeSystem system;
  FakePen pen;
  FakeMouse mouse;
  FakePad pad, controller;
  std::unique_ptr<Driver> driver;

  CueFixture() {
    add_hidraw(system, 0, kPenKernel, "Slim pen", "", pen_descriptor(65));
    add_hidraw(system, 1, kMouseKernel, "MX Master 4", "aa:bb", hidpp_descriptor());
    add_hidraw(system, 2, kReceiverKernel, "Logitech USB Receiver", "", hidpp_descriptor());
    add_hidraw(system, 3, "0003:046D:C548.0015", "Logitech USB Receiver", "", {0x05, 0x01});
    add_hidraw(system, 4, kPadKernel, "Pad", "", pen_descriptor(9, true));
    add_input(system, 4, kPadKernel, "Pad", "2808", "0222", "8000 0");
    add_input(system, 5, kControllerKernel, "X-Box One pad", "045e", "02ea", "107030000 0");
    add_input(system, 6, "0003:046D:C24F.0008", "G29", "046d", "c24f", "300040000 0");
    controller.is_haptic = false;
    CueOptions options;
    options.system = &system;
    options.open_hidraw = [this](const std::string& path) -> Result<std::unique_ptr<HidrawPort>> {
      if (const auto may = system.may_use(path); !may) return tl::unexpected(may.error());
      mouse.is_direct = path == "/dev/hidraw1";
      return path == "/dev/hidraw0" ? pen.open() : mouse.open();
    };
    options.open_evdev = [this](const std::string& path) -> Result<std::unique_ptr<EvdevPort>> {
      if (const auto may = system.may_use(path); !may) return tl::unexpected(may.error());
      return path == "/dev/input/event4" ? pad.open() : controller.open();
    };
    driver = make_cue_driver(std::move(options));
  }

  Result<std::unique_ptr<CueDevice>> open(const std::string& id) {
    for (const DeviceDescriptor& found : driver->find()) {
      if (found.id == id) return driver->open_cue(found);
    }
    return fail(ErrorCode::kNotFound, "not found: " + id);
  }
};

inline constexpr const char* kPenId = "cue:hid-045e:0c1b";
inline constexpr const char* kMouseId = "cue:hidpp-046d:b042-aa:bb";
inline constexpr const char* kReceiverId = "cue:hidpp-046d:c548";
inline constexpr const char* kPadId = "cue:pad-2808:0222";
inline constexpr const char* kControllerId = "cue:rumble-045e:02ea";

}  // namespace felt
