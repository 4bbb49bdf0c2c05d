#include "felt/devices/openhaptics/openhaptics_doctor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/devices/openhaptics/openhaptics_driver.h"
#include "felt/driver/testing/fake_system.h"

namespace felt::openhaptics_doctor_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kUsb = "/sys/devices/pci0000:00/usb1/1-4";

// Adds the files that sysfs shows for a Touch HID.
void plug_in_touch(FakeSystem& system) {
  const std::string usb = kUsb;
  system.add_file(usb + "/idVendor", "2988\n")
      .add_file(usb + "/idProduct", "0302\n")
      .add_file(usb + "/busnum", "1\n")
      .add_file(usb + "/devnum", "4\n")
      .add_link("/sys/bus/usb/devices/1-4", usb)
      .add_folder(usb + "/1-4:1.0/0003:2988:0302.0001/hidraw/hidraw0")
      .add_link("/sys/class/hidraw/hidraw0", usb + "/1-4:1.0/0003:2988:0302.0001/hidraw/hidraw0")
      .add_file("/dev/hidraw0")
      .add_file("/dev/hidraw1");
}

void set_up(FakeSystem& system) {
  system.add_library("libHD.so")
      .set_environment("GTDD_HOME", "/usr/share/3DSystems")
      .add_file("/usr/share/3DSystems/config/Default Device.config");
}

std::vector<Finding> look(const FakeSystem& system) {
  return make_openhaptics_driver()->diagnose(system);
}

const Finding* worst(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    if (finding.level == FindingLevel::kProblem) return &finding;
  }
  return nullptr;
}

std::string all_steps(const Finding& finding) {
  std::string all;
  for (const std::string& step : finding.steps) all += step + "\n";
  return all;
}

TEST(OpenHapticsDiagnosis, OnAMachineWithNothingNothingIsWrong) {
  const auto findings = look(FakeSystem{});
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].level, FindingLevel::kAbsent);
  for (const char* name : {"libHD.so:", "libHD.so.3.4:", "libHD.so.3.0:"}) {
    EXPECT_THAT(findings[0].details, HasSubstr(name));
  }
  EXPECT_THAT(all_steps(findings[0]), HasSubstr("support.3dsystems.com"));
}

TEST(OpenHapticsDiagnosis, ADeviceWithoutItsLibraryIsAProblem) {
  FakeSystem system;
  plug_in_touch(system);
  const auto findings = look(system);
  ASSERT_NE(worst(findings), nullptr);
  EXPECT_THAT(worst(findings)->what, HasSubstr("but its library"));
  EXPECT_EQ(findings.back().level, FindingLevel::kOk);
}

TEST(OpenHapticsDiagnosis, AllWell) {
  FakeSystem system;
  set_up(system);
  plug_in_touch(system);
  system.add_link("/usr/lib/libHD.so", "/usr/lib/libHD.so.3.4.0");
  const auto findings = look(system);
  ASSERT_EQ(findings.size(), 3U);
  for (const Finding& finding : findings) {
    EXPECT_EQ(finding.level, FindingLevel::kOk) << finding.what;
    EXPECT_THAT(finding.steps, IsEmpty());
  }
  EXPECT_THAT(findings[0].details, HasSubstr("libHD.so.3.4.0"));
  EXPECT_THAT(findings[1].what, HasSubstr("Default Device"));
}

TEST(OpenHapticsDiagnosis, EachMissingPartHasItsStep) {
  const auto steps_without = [](const std::string& part) {
    FakeSystem system;
    for (const std::string& name : openhaptics_library_names()) {
      system.refuse_library(name, part + ": cannot open shared object file: No such file");
    }
    const auto findings = look(system);
    const Finding* problem = worst(findings);
    EXPECT_NE(problem, nullptr) << part;
    EXPECT_THAT(problem->details, HasSubstr(part + ": cannot open")) << "verbatim";
    return problem->what + all_steps(*problem);
  };
  EXPECT_THAT(steps_without("libncurses.so.5"), HasSubstr("sudo apt install libncurses5"));
  EXPECT_THAT(steps_without("libPhantomIOLib42.so"), HasSubstr("Touch device driver"));
  EXPECT_THAT(steps_without("libPHANToMIO.so.4"), HasSubstr("PHANToM device driver"));
  EXPECT_THAT(steps_without("libsomething.so.1"), HasSubstr("apt-file search"));
}

TEST(OpenHapticsDiagnosis, ALibraryForOtherProcessors) {
  FakeSystem system;
  system.refuse_library("libHD.so", "libHD.so: wrong ELF class: ELFCLASS32");
  const auto findings = look(system);
  ASSERT_NE(worst(findings), nullptr);
  EXPECT_THAT(worst(findings)->what, HasSubstr("32-bit"));
}

TEST(OpenHapticsDiagnosis, TheLibraryThatTheEnvironmentNamesIsTheOnlyOne) {
  FakeSystem system;
  system.set_environment("FELT_OPENHAPTICS_LIBRARY", "/opt/hd/libHD.so").add_library("libHD.so");
  EXPECT_THAT(look(system)[0].details, HasSubstr("/opt/hd/libHD.so: cannot open"));
  system.add_library("/opt/hd/libHD.so");
  EXPECT_THAT(look(system)[0].what, HasSubstr("installed (/opt/hd/libHD.so)"));
}

// With this_system(), the driver really loads the library. So it reports missing functions, and not
// only that the file exists.
TEST(OpenHapticsDiagnosis, ALibraryThatIsAnotherOneIsNotFine) {
  const auto driver = make_openhaptics_driver({.library = "libm.so.6", .device = {}});
  const auto findings = driver->diagnose(this_system());
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].level, FindingLevel::kProblem);
  EXPECT_THAT(findings[0].what,
              HasSubstr("libm.so.6 was loaded, but is not the OpenHaptics library"));
  EXPECT_THAT(findings[0].details, HasSubstr("it lacks hdInitDevice"));
}

TEST(OpenHapticsDiagnosis, TheMakersSetUp) {
  FakeSystem system;
  system.add_library("libHD.so").add_file("/usr/lib/libPhantomIOLib42.so");
  plug_in_touch(system);
  auto findings = look(system);
  ASSERT_NE(worst(findings), nullptr);
  EXPECT_THAT(all_steps(*worst(findings)), HasSubstr("/etc/environment"));
  EXPECT_THAT(all_steps(*worst(findings)), HasSubstr("Touch_Setup"));

  system.set_environment("GTDD_HOME", "/home/ada/.3dsystems");
  findings = look(system);
  ASSERT_NE(worst(findings), nullptr);
  EXPECT_THAT(worst(findings)->details, HasSubstr("/home/ada/.3dsystems/config"));
  EXPECT_THAT(all_steps(*worst(findings)), HasSubstr("Touch_Setup"));

  system.add_file("/home/ada/.3dsystems/config/Left.config");
  EXPECT_EQ(worst(look(system)), nullptr);
  EXPECT_THAT(configured_devices(system), ElementsAre("Left"));
}

TEST(OpenHapticsDiagnosis, ADeviceThatMayNotBeUsed) {
  FakeSystem system;
  set_up(system);
  plug_in_touch(system);
  system.forbid("/dev/hidraw0");
  const auto findings = look(system);
  const Finding* problem = worst(findings);
  ASSERT_NE(problem, nullptr);
  EXPECT_EQ(problem->details, "/dev/hidraw0: Permission denied");
  ASSERT_TRUE(problem->fix.has_value());
  EXPECT_EQ(problem->fix->path, "/etc/udev/rules.d/70-feltline-3dsystems.rules");
  EXPECT_THAT(problem->fix->content, HasSubstr("ATTRS{idVendor}==\"2988\""));
  EXPECT_THAT(problem->fix->content, HasSubstr("SUBSYSTEM==\"hidraw\""));
  EXPECT_THAT(all_steps(*problem), HasSubstr("feltline doctor --fix"));
  EXPECT_THAT(all_steps(*problem), HasSubstr("usermod -aG plugdev ada"));
  system.set_user("ada", {"plugdev"});
  EXPECT_THAT(all_steps(*worst(look(system))), ::testing::Not(HasSubstr("usermod")));
  system.forbid("/dev/hidraw1").allow("/dev/hidraw0");
  EXPECT_EQ(worst(look(system)), nullptr) << "that is another device";
}

// The older Touch uses a serial port.
TEST(OpenHapticsDiagnosis, ATouchThatIsASerialPort) {
  FakeSystem system;
  set_up(system);
  plug_in_touch(system);
  system.remove("/sys/class/hidraw/hidraw0")
      .add_folder(std::string(kUsb) + "/1-4:1.0/tty/ttyACM0")
      .add_link("/sys/class/tty/ttyACM0", std::string(kUsb) + "/1-4:1.0/tty/ttyACM0")
      .add_file("/dev/ttyACM0")
      .forbid("/dev/ttyACM0");
  const auto findings = look(system);
  ASSERT_NE(worst(findings), nullptr);
  EXPECT_THAT(worst(findings)->details, HasSubstr("/dev/ttyACM0"));
  EXPECT_THAT(all_steps(*worst(findings)), HasSubstr("usermod -aG dialout ada"));
}

TEST(OpenHapticsDiagnosis, NothingIsPluggedInOrItIsSwitchedOff) {
  FakeSystem system;
  set_up(system);
  const auto findings = look(system);
  EXPECT_EQ(findings.back().level, FindingLevel::kWarning);
  EXPECT_THAT(all_steps(findings.back()), HasSubstr("power supply"));
}

}  // namespace
}  // namespace felt::openhaptics_doctor_test
