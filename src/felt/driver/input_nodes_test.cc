#include "felt/driver/input_nodes.h"

#include <gtest/gtest.h>

#include "felt/driver/testing/fake_system.h"

namespace felt::input_nodes_test {
namespace {

TEST(SysfsBits, HighestWordComesFirst) {
  const auto bits = sysfs_bits("3 0 8000000000000001\n", 192);
  EXPECT_TRUE(bits[0] && bits[63] && bits[128] && bits[129]);
  EXPECT_EQ(std::count(bits.begin(), bits.end(), true), 4);
  EXPECT_EQ(sysfs_bits("", 8), std::vector<bool>(8, false));
  EXPECT_EQ(sysfs_bits("3 x1", 8), std::vector<bool>(8, false));
  EXPECT_EQ(sysfs_bits("1ffffffffffffffff", 8), std::vector<bool>(8, false));
  EXPECT_EQ(sysfs_bits("ffff ffff ffff ffff", 4), std::vector<bool>(4, true));
}

TEST(InputNodes, AreReadFromSysfsInOrderOfNumbers) {
  FakeSystem system;
  const std::string input = "/sys/devices/pci/usb1/0003:044F:B10A.0002/input/input7";
  system.add_link("/sys/class/input/event10", input + "/event10")
      .add_file("/sys/class/input/event2/device/name", "Power Button\n")
      .add_link("/sys/class/input/mice", "/sys/devices/virtual/mice")
      .add_link(input + "/event10/device", input)
      .add_link(input + "/device", "/sys/devices/pci/usb1/0003:044F:B10A.0002")
      .add_file(input + "/name", "Thrust\tmaster\n")
      .add_file(input + "/uniq", "\n")
      .add_file(input + "/id/vendor", "044f\n")
      .add_file(input + "/id/product", "b10a\n")
      .add_file(input + "/capabilities/abs", "3\n")
      .add_file(input + "/capabilities/ff", "300018000 0\n");
  const std::vector<InputNode> nodes = input_nodes(system);
  ASSERT_EQ(nodes.size(), 2u);
  EXPECT_EQ(nodes[0].path, "/dev/input/event2");
  const InputNode& stick = nodes[1];
  EXPECT_EQ(stick.path, "/dev/input/event10");
  EXPECT_EQ(stick.name, "Thrust master");
  EXPECT_EQ(stick.unique, "");
  EXPECT_EQ(vendor_and_product(stick.vendor, stick.product), "044f:b10a");
  EXPECT_TRUE(stick.axes[evdev::kAbsX] && stick.axes[evdev::kAbsY]);
  EXPECT_EQ(stick.axes.count(), 2u);
  EXPECT_TRUE(stick.effects[evdev::kFfGain]);
  EXPECT_EQ(stick.hid, "/sys/devices/pci/usb1/0003:044F:B10A.0002");
}

TEST(HidrawNodes, AreReadFromSysfs) {
  FakeSystem system;
  const std::string hid = "/sys/devices/i2c/0018:045E:0C1B.0003";
  system.add_link("/sys/class/hidraw/hidraw1", hid + "/hidraw/hidraw1")
      .add_link(hid + "/hidraw/hidraw1/device", hid)
      .add_file(hid + "/uevent",
                "DRIVER=hid-multitouch\nHID_ID=0018:0000045E:00000C1B\nHID_NAME=A pen\nHID_UNIQ=\n")
      .add_file(hid + "/report_descriptor", std::string("\x05\x0E\x00", 3))
      .add_file("/sys/class/hidraw/hidraw0/device/uevent", "HID_ID=nonsense\n");
  const std::vector<HidrawNode> nodes = hidraw_nodes(system);
  ASSERT_EQ(nodes.size(), 2u);
  EXPECT_EQ(nodes[0].vendor, 0);
  EXPECT_EQ(nodes[1].path, "/dev/hidraw1");
  EXPECT_EQ(nodes[1].name, "A pen");
  EXPECT_EQ(nodes[1].vendor, 0x045E);
  EXPECT_EQ(nodes[1].product, 0x0C1B);
  EXPECT_EQ(nodes[1].descriptor.size(), 3u);
  EXPECT_EQ(nodes[1].hid, hid);
  EXPECT_EQ(nodes[1].kernel, "0018:045E:0C1B.0003");
}

TEST(ShownName, IsPrintableAndBounded) {
  EXPECT_EQ(shown_name("\"A\npen\" \n"), "A pen");
  EXPECT_EQ(shown_name(std::string(1000, 'x')).size(), 80u);
}

}  // namespace
}  // namespace felt::input_nodes_test
