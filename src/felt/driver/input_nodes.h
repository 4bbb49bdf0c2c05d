#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/driver/diagnosis.h"
#include "felt/driver/evdev_codes.h"

namespace felt {

/// An input device as sysfs describes it, without opening it.
struct InputNode {
  std::string path;                       ///< "/dev/input/event5"
  std::string name;                       ///< as it calls itself; printable
  std::string unique;                     ///< serial number; empty as a rule
  std::uint16_t vendor = 0, product = 0;  ///< of USB or Bluetooth
  std::bitset<evdev::kAxisCount> axes;
  std::bitset<evdev::kKeyCount> keys;
  std::bitset<evdev::kFfCount> effects;  ///< kinds of force feedback; none: it has none
  std::string hid;                       ///< folder of the HID device that it is part of
};

/// A HID device that can be talked to past its driver, likewise.
struct HidrawNode {
  std::string path;  ///< "/dev/hidraw3"
  std::string name, unique;
  std::uint16_t vendor = 0, product = 0;
  std::string descriptor;  ///< report descriptor, bytes as they are
  std::string hid;         ///< its folder
  std::string kernel;      ///< what udev calls it, KERNELS: "0018:045E:0C1B.0003"
};

/// All of them, by number. What cannot be read is left out, or empty.
std::vector<InputNode> input_nodes(const SystemView& system);
std::vector<HidrawNode> hidraw_nodes(const SystemView& system);

/// The bits of a file of sysfs: hexadecimal words of a long each, the highest first.
std::vector<bool> sysfs_bits(std::string_view text, std::size_t most);
/// "046d:c52b", for ids and rules.
std::string vendor_and_product(std::uint16_t vendor, std::uint16_t product);
/// Printable ASCII and UTF-8 of what a device calls itself, 80 bytes at most, without ends of
/// lines.
std::string shown_name(std::string_view name);

}  // namespace felt
