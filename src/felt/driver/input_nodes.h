#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/driver/diagnosis.h"
#include "felt/driver/evdev_codes.h"

namespace felt {

/// An input device as sysfs describes it; it is not opened.
struct InputNode {
  std::string path;                       ///< "/dev/input/event5"
  std::string name;                       ///< as the device reports it; printable
  std::string unique;                     ///< serial number; usually empty
  std::uint16_t vendor = 0, product = 0;  ///< of USB or Bluetooth
  std::bitset<evdev::kAxisCount> axes;
  std::bitset<evdev::kKeyCount> keys;
  std::bitset<evdev::kFfCount> effects;  ///< kinds of force feedback; may be empty
  std::string hid;                       ///< folder of the HID device that it belongs to
};

/// A HID device that can be accessed without its kernel driver; it is not opened.
struct HidrawNode {
  std::string path;  ///< "/dev/hidraw3"
  std::string name, unique;
  std::uint16_t vendor = 0, product = 0;
  std::string descriptor;  ///< report descriptor, raw bytes
  std::string hid;         ///< its folder
  std::string kernel;      ///< name in udev's KERNELS: "0018:045E:0C1B.0003"
};

/// Returns all devices, ordered by number. Values that cannot be read are left out, or empty.
std::vector<InputNode> input_nodes(const SystemView& system);
std::vector<HidrawNode> hidraw_nodes(const SystemView& system);

/// Parses the bits of a sysfs file. It consists of hexadecimal words of one long each; the highest
/// comes first.
std::vector<bool> sysfs_bits(std::string_view text, std::size_t most);
/// Returns vendor and product in the form "046d:c52b", for ids and rules.
std::string vendor_and_product(std::uint16_t vendor, std::uint16_t product);
/// Returns the printable ASCII and UTF-8 characters of a device's name without line breaks, at most
/// 80 bytes.
std::string shown_name(std::string_view name);

}  // namespace felt
