#include "felt/driver/input_nodes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <climits>

namespace felt {
namespace {

constexpr std::size_t kWordBits = sizeof(unsigned long) * CHAR_BIT;
constexpr std::size_t kMaxName = 80;
constexpr std::size_t kMaxNodes = 256;

std::string_view unquoted(std::string_view text) {
  const auto is_end = [](char c) { return c == '\n' || c == ' ' || c == '\0' || c == '"'; };
  while (!text.empty() && is_end(text.back())) text.remove_suffix(1);
  while (!text.empty() && is_end(text.front())) text.remove_prefix(1);
  return text;
}

std::string word(const SystemView& system, const std::string& path) {
  return std::string(unquoted(system.read(path).value_or("")));
}

std::uint16_t hex16(std::string_view text) {
  unsigned long value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  return end.ec == std::errc() && value <= 0xFFFF ? static_cast<std::uint16_t>(value)
                                                  : std::uint16_t{0};
}

template <std::size_t kBits>
std::bitset<kBits> bits_of(const SystemView& system, const std::string& path) {
  std::bitset<kBits> bits;
  const std::vector<bool> all = sysfs_bits(system.read(path).value_or(""), kBits);
  for (std::size_t i = 0; i < all.size(); ++i) bits[i] = all[i];
  return bits;
}

/// Returns the names of the form `word` + number, ordered by number.
std::vector<std::string> numbered(const SystemView& system, const std::string& folder,
                                  std::string_view word) {
  std::vector<std::pair<unsigned, std::string>> found;
  for (const std::string& name : system.list(folder)) {
    if (!name.starts_with(word)) continue;
    unsigned number = 0;
    const char* end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + word.size(), end, number);
    if (read.ec != std::errc() || read.ptr != end) continue;
    found.emplace_back(number, name);
  }
  std::sort(found.begin(), found.end());
  if (found.size() > kMaxNodes) found.resize(kMaxNodes);
  std::vector<std::string> names;
  for (auto& [number, name] : found) names.push_back(std::move(name));
  return names;
}

/// Returns the value of `key` in a text with lines KEY=value.
std::string_view value_of(std::string_view lines, std::string_view key) {
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string_view line = lines.substr(0, end);
    if (line.starts_with(key) && line.size() > key.size() && line[key.size()] == '=')
      return unquoted(line.substr(key.size() + 1));
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return {};
}

}  // namespace

std::vector<bool> sysfs_bits(std::string_view text, std::size_t bit_count) {
  std::vector<bool> bits(bit_count, false);
  text = unquoted(text);
  for (std::size_t base = 0; !text.empty() && base < bit_count; base += kWordBits) {
    const std::size_t space = text.rfind(' ');
    const std::string_view last = space == std::string_view::npos ? text : text.substr(space + 1);
    unsigned long value = 0;
    const auto read = std::from_chars(last.data(), last.data() + last.size(), value, 16);
    if (read.ec != std::errc() || read.ptr != last.data() + last.size())
      return std::vector<bool>(bit_count, false);
    for (std::size_t i = 0; i < kWordBits && base + i < bit_count; ++i)
      bits[base + i] = (value >> i & 1) != 0;
    text = space == std::string_view::npos ? std::string_view() : unquoted(text.substr(0, space));
  }
  return bits;
}

std::string vendor_and_product(std::uint16_t vendor, std::uint16_t product) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint16_t number : {vendor, product}) {
    if (!text.empty()) text += ':';
    for (int shift = 12; shift >= 0; shift -= 4)
      text += kDigits[static_cast<std::size_t>(number >> shift & 0xF)];
  }
  return text;
}

std::string shown_name(std::string_view name) {
  std::string shown;
  for (const char c : unquoted(name)) {
    if (shown.size() == kMaxName) break;
    const auto byte = static_cast<unsigned char>(c);
    shown += byte < 0x20 || byte == 0x7F ? ' ' : c;
  }
  return shown;
}

std::vector<InputNode> input_nodes(const SystemView& system) {
  std::vector<InputNode> nodes;
  for (const std::string& event : numbered(system, "/sys/class/input", "event")) {
    const std::string device = "/sys/class/input/" + event + "/device";
    InputNode node;
    node.path = "/dev/input/" + event;
    node.name = shown_name(word(system, device + "/name"));
    node.unique = shown_name(word(system, device + "/uniq"));
    node.vendor = hex16(word(system, device + "/id/vendor"));
    node.product = hex16(word(system, device + "/id/product"));
    node.axes = bits_of<evdev::kAxisCount>(system, device + "/capabilities/abs");
    node.keys = bits_of<evdev::kKeyCount>(system, device + "/capabilities/key");
    node.effects = bits_of<evdev::kFfCount>(system, device + "/capabilities/ff");
    node.hid = system.resolve(device + "/device");
    nodes.push_back(std::move(node));
  }
  return nodes;
}

std::vector<HidrawNode> hidraw_nodes(const SystemView& system) {
  std::vector<HidrawNode> nodes;
  for (const std::string& name : numbered(system, "/sys/class/hidraw", "hidraw")) {
    const std::string device = "/sys/class/hidraw/" + name + "/device";
    const std::string about = system.read(device + "/uevent").value_or("");
    HidrawNode node;
    node.path = "/dev/" + name;
    node.name = shown_name(value_of(about, "HID_NAME"));
    node.unique = shown_name(value_of(about, "HID_UNIQ"));
    // Example: HID_ID=0003:0000046D:0000C548
    const std::string_view id = value_of(about, "HID_ID");
    if (id.size() == 22 && id[4] == ':' && id[13] == ':') {
      node.vendor = hex16(id.substr(9, 4));
      node.product = hex16(id.substr(18, 4));
    }
    node.descriptor = system.read(device + "/report_descriptor").value_or("");
    node.hid = system.resolve(device);
    node.kernel = node.hid.substr(node.hid.rfind('/') + 1);
    nodes.push_back(std::move(node));
  }
  return nodes;
}

}  // namespace felt
