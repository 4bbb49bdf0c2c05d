// docs/devices/doctor.md shows the program's output on the imaginary machines in this test. The
// test generates the page again and compares. With FELT_WRITE_DOCS=1 it replaces the page.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "doctor_report.h"
#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "felt/devices/drivers.h"
#include "felt/driver/machine_checks.h"
#include "felt/driver/testing/fake_system.h"

namespace felt::cli::doctor_page_test {
namespace {

constexpr const char* kPage = "docs/devices/doctor.md";

struct Case {
  const char* title;
  const char* driver;  ///< empty: all
  std::function<void(FakeSystem&)> make;
};

void plug_in(FakeSystem& system, const std::string& place, const char* vendor,
             const char* product) {
  const std::string usb = "/sys/devices/pci0000:00/0000:00:14.0/usb1/" + place;
  system.add_file(usb + "/idVendor", std::string(vendor) + "\n")
      .add_file(usb + "/idProduct", std::string(product) + "\n")
      .add_file(usb + "/busnum", "1\n")
      .add_file(usb + "/devnum", "4\n")
      .add_link("/sys/bus/usb/devices/" + place, usb);
}

void plug_in_touch(FakeSystem& system) {
  plug_in(system, "1-4", "2988", "0302");
  const std::string hid =
      "/sys/devices/pci0000:00/0000:00:14.0/usb1/1-4/1-4:1.0/0003:2988:0302.0001/hidraw/hidraw0";
  system.add_folder(hid).add_link("/sys/class/hidraw/hidraw0", hid).add_file("/dev/hidraw0");
}

void refuse_openhaptics(FakeSystem& system, const std::string& words) {
  for (const char* name : {"libHD.so", "libHD.so.3.4", "libHD.so.3.0", "libHD.so.3"}) {
    system.refuse_library(name, words);
  }
}

void plug_in_omega(FakeSystem& system) {
  plug_in(system, "1-2", "1451", "0402");
  system.add_file("/sys/bus/usb/devices/1-2/product", "omega.3\n").add_file("/dev/bus/usb/001/004");
}

std::vector<Case> cases() {
  return {
      {"Nothing is installed, nothing is connected", "", [](FakeSystem&) {}},
      {"Forces may not run in real time", "",
       [](FakeSystem& system) {
         system.add_file("/proc/self/limits",
                         "Max locked memory         8388608              8388608        bytes\n"
                         "Max realtime priority     0                    0              \n");
       }},
      {"A Touch is connected, and the maker's software is not installed", "openhaptics",
       plug_in_touch},
      {"The maker's library needs another one that is missing", "openhaptics",
       [](FakeSystem& system) {
         plug_in_touch(system);
         refuse_openhaptics(system,
                            "libncurses.so.5: cannot open shared object file: No such file or "
                            "directory");
       }},
      {"The library is for another kind of computer", "openhaptics",
       [](FakeSystem& system) {
         plug_in_touch(system);
         refuse_openhaptics(system, "libHD.so: wrong ELF class: ELFCLASS32");
       }},
      {"You may not use the device", "openhaptics",
       [](FakeSystem& system) {
         plug_in_touch(system);
         system.add_library("libHD.so")
             .add_file("/usr/lib/libPhantomIOLib42.so")
             .add_file("/usr/share/3DSystems/config/Default Device.config")
             .forbid("/dev/hidraw0");
       }},
      {"An omega is connected, and the maker's library is not installed", "forcedimension",
       plug_in_omega},
      {"An omega is connected, and you may not use it", "forcedimension",
       [](FakeSystem& system) {
         plug_in_omega(system);
         system.add_library("libdrd.so").forbid("/dev/bus/usb/001/004");
       }},
      {"Haply's service is installed and does not run", "haply",
       [](FakeSystem& system) {
         system.add_file("/lib/systemd/system/haply-inverse-service.service");
       }},
      {"Nothing of Haply is here", "haply", [](FakeSystem&) {}},
      {"The board of a 2DIY is connected, and you may not use it", "pantograph",
       [](FakeSystem& system) {
         system.set_environment("FELT_PANTOGRAPH_PORT", "/dev/ttyACM0")
             .add_file("/dev/ttyACM0")
             .forbid("/dev/ttyACM0")
             .add_file("/usr/sbin/ModemManager");
       }},
      {"A wheel is connected that cannot push", "evdev",
       [](FakeSystem& system) {
         system.add_file("/sys/class/input/event3/device/name", "Old wheel")
             .add_file("/sys/class/input/event3/device/capabilities/abs", "1")
             .add_file("/sys/class/input/event3/device/capabilities/key", "100000000 0 0 0 0");
       }},
  };
}

FakeSystem ordinary() {
  FakeSystem system;
  system.set_user("ada", {"ada"})
      .set_environment("HOME", "/home/ada")
      .set_environment("WAYLAND_DISPLAY", "wayland-0")
      .add_folder("/home/ada")
      .add_file("/proc/self/limits",
                "Max locked memory         unlimited            unlimited            bytes\n"
                "Max realtime priority     95                   95                   \n")
      .add_file("/proc/self/status", "CapEff:\t0000000000000000\n")
      .add_file("/proc/sys/kernel/osrelease", "6.1.0-13-amd64\n")
      .add_file("/run/udev/control");
  return system;
}

std::string output_of(const Case& which) {
  FakeSystem system = ordinary();
  which.make(system);
  DoctorReport report;
  const std::string name = which.driver;
  report.is_named = !name.empty();
  for (const auto& driver : make_drivers()) {
    if (!name.empty() && driver->name() != name) continue;
    report.drivers.push_back(
        {std::string(driver->name()), std::string(driver->label()), {}, driver->diagnose(system)});
  }
  if (name.empty()) report.machine = diagnose_machine(system);
  return "$ feltline doctor" + (name.empty() ? "" : " " + name) + "\n" + doctor_text(report, {});
}

std::string page() {
  std::string text =
      "# What the doctor says\n\n"
      "`feltline doctor` looks at this computer and says what a haptic device needs, what is "
      "missing, and the exact\nnext step. It changes nothing; `feltline doctor --fix` writes the "
      "permissions that it names, after asking.\nBelow is its output in each of the usual "
      "cases. The marks: **fine**, as it should be; **none**, not here,\nwhich is fine unless you "
      "own it; **better**, it works and could work better; **MEND**, a problem to fix.\n\n"
      "(A test writes this page from the output of the program on fake machines.)\n";
  for (const Case& which : cases()) {
    text += std::string("\n## ") + which.title + "\n```text\n" + output_of(which) + "```\n";
  }
  return text;
}

TEST(DoctorPageTest, IsWhatTheProgramSays) {
  const std::string now = page();
  if (std::getenv("FELT_WRITE_DOCS") != nullptr) {
    ASSERT_TRUE(write_file(kPage, now));
  }
  const Result<std::string> page = read_file(kPage, 1 << 20);
  ASSERT_TRUE(page) << page.error().message;
  EXPECT_EQ(*page, now) << "FELT_WRITE_DOCS=1 ctest -R DoctorPage writes it anew";
}

TEST(DoctorPageTest, EveryProblemHasAStep) {
  for (const Case& which : cases()) {
    FakeSystem system = ordinary();
    which.make(system);
    for (const auto& driver : make_drivers()) {
      for (const Finding& finding : driver->diagnose(system)) {
        if (finding.level != FindingLevel::kProblem) continue;
        EXPECT_FALSE(finding.steps.empty()) << which.title << ": " << finding.what;
      }
    }
  }
}

TEST(DoctorPageTest, NothingInstalledIsNoProblem) {
  for (const auto& driver : make_drivers()) {
    for (const Finding& finding : driver->diagnose(ordinary())) {
      EXPECT_NE(finding.level, FindingLevel::kProblem) << driver->name() << ": " << finding.what;
    }
  }
}

}  // namespace
}  // namespace felt::cli::doctor_page_test
