#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/driver/diagnosis.h"
#include "felt/driver/evdev_codes.h"

namespace felt {

/// The description of an input device in sysfs. Reading it does not open the device.
struct InputNode {
  std::string path;                       ///< "/dev/input/event5"
  std::string name;                       ///< as the device reports it; printable
  std::string unique;                     ///< serial number; usually empty
  std::uint16_t vendor = 0, product = 0;  ///< USB or Bluetooth ids
  std::bitset<evdev::kAxisCount> axes;
  std::bitset<evdev::kKeyCount> keys;
  std::bitset<evdev::kFfCount> effects;  ///< kinds of force feedback; may be empty
  std::string hid;                       ///< sysfs folder of its HID device
};

/// The description of a /dev/hidrawN node, through which a program accesses a HID device directly.
/// Reading it does not open the device.
struct HidrawNode {
  std::string path;  ///< "/dev/hidraw3"
  std::string name, unique;
  std::uint16_t vendor = 0, product = 0;
  std::string descriptor;  ///< report descriptor, raw bytes
  std::string hid;         ///< sysfs folder of the HID device
  std::string kernel;      ///< value for KERNELS in udev rules: "0018:045E:0C1B.0003"
};

/// Return at most 256 devices, in the order of the numbers of their nodes. In the result, a value
/// that could not be read is empty or 0.
std::vector<InputNode> input_nodes(const SystemView& system);
std::vector<HidrawNode> hidraw_nodes(const SystemView& system);

/// Returns the first `bit_count` bits of a sysfs file whose content is `text`; all bits are false
/// if the text is invalid. Such a file consists of hexadecimal words, each as large as a C `long`;
/// the most significant word comes first.
std::vector<bool> sysfs_bits(std::string_view text, std::size_t bit_count);
/// Returns vendor and product in the form "046d:c52b", for ids and rules.
std::string vendor_and_product(std::uint16_t vendor, std::uint16_t product);
/// Returns at most 80 bytes of a device's name, in which each control character, such as a line
/// break, is replaced by a space.
std::string shown_name(std::string_view name);

}  // namespace felt
