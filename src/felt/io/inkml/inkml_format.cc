#include "felt/io/inkml/inkml_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "felt/io/xml/xml_input.h"

namespace felt::inkml {
namespace {

struct Unit {
  std::string_view name;
  double size;
};
constexpr std::array kLengths = {
    Unit{"mm", 1.0},        Unit{"cm", 10.0},        Unit{"m", 1000.0},
    Unit{"in", 25.4},       Unit{"inch", 25.4},      Unit{"pt", 25.4 / 72.0},
    Unit{"pc", 25.4 / 6.0}, Unit{"px", 25.4 / 96.0}, Unit{"himetric", 0.01},
    Unit{"him", 0.01},      Unit{"um", 0.001}};
constexpr std::array kAngles = {Unit{"deg", 1.0}, Unit{"degree", 1.0},
                                Unit{"rad", 57.295779513082320877}};
constexpr std::array kTimes = {Unit{"ms", 1.0}, Unit{"s", 1000.0}, Unit{"us", 0.001}};

template <std::size_t n>
std::optional<double> size_of(const std::array<Unit, n>& units, std::string_view name) noexcept {
  const auto found =
      std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.name == name; });
  return found == units.end() ? std::nullopt : std::optional(found->size);
}

ChannelName name_of(std::string_view text) {
  if (text == "X") return ChannelName::kX;
  if (text == "Y") return ChannelName::kY;
  if (text == "F") return ChannelName::kForce;
  if (text == "T") return ChannelName::kTime;
  if (text == "W") return ChannelName::kWidth;
  if (text == "S") return ChannelName::kTip;
  if (text == "OTx") return ChannelName::kTiltX;
  if (text == "OTy") return ChannelName::kTiltY;
  if (text == "OE") return ChannelName::kElevation;
  return text == "E" ? ChannelName::kEraser : ChannelName::kOther;
}

Channel read_channel(const pugi::xml_node& node) {
  Channel channel;
  channel.text = node.attribute("name").value();
  channel.name = name_of(channel.text);
  channel.units = node.attribute("units").value();
  channel.is_integer = std::string_view(node.attribute("type").value()) == "integer";
  const std::string_view orientation = node.attribute("orientation").value();
  channel.is_reversed = orientation == "-ve" || orientation == "-";
  channel.smallest = number_of(node.attribute("min").value());
  channel.largest = number_of(node.attribute("max").value());
  return channel;
}

}  // namespace

std::optional<double> number_of(std::string_view text) noexcept {
  while (!text.empty() && (text.front() == ' ' || text.front() == '+')) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

std::optional<double> mm_of_unit(std::string_view unit) noexcept {
  return size_of(kLengths, unit);
}

std::optional<double> ms_of_unit(std::string_view unit) noexcept {
  return size_of(kTimes, unit);
}

std::optional<double> deg_of_unit(std::string_view unit) noexcept {
  return size_of(kAngles, unit);
}

Format read_format(const pugi::xml_node& node, std::string& problem) {
  Format format;
  const auto add = [&](const pugi::xml_node& channel) {
    if (format.channels.size() == kMaxChannels) {
      problem = "has more than " + std::to_string(kMaxChannels) + " channels";
      return;
    }
    format.channels.push_back(read_channel(channel));
  };
  for (const pugi::xml_node& child : node.children()) {
    if (xml_local_name(child.name()) == "channel") add(child);
  }
  for (const pugi::xml_node& child : node.children()) {
    if (xml_local_name(child.name()) != "intermittentChannels") continue;
    for (const pugi::xml_node& channel : child.children()) {
      if (xml_local_name(channel.name()) == "channel") add(channel);
    }
  }
  return format;
}

Format default_format() {
  Format format;
  format.channels.resize(2);
  format.channels[0].name = ChannelName::kX;
  format.channels[0].text = "X";
  format.channels[1].name = ChannelName::kY;
  format.channels[1].text = "Y";
  return format;
}

std::optional<double> scale_of(const Channel& channel, const std::vector<Resolution>& resolutions) {
  const bool is_time = channel.name == ChannelName::kTime;
  const bool is_angle = channel.name == ChannelName::kTiltX ||
                        channel.name == ChannelName::kTiltY ||
                        channel.name == ChannelName::kElevation;
  const auto unit = [&](std::string_view name) {
    if (is_angle) return deg_of_unit(name);
    return is_time ? ms_of_unit(name) : mm_of_unit(name);
  };
  for (const Resolution& r : resolutions) {
    if (r.channel != channel.text || !(r.value > 0.0) || r.units.substr(0, 2) != "1/") continue;
    if (const auto size = unit(std::string_view(r.units).substr(2))) return *size / r.value;
  }
  return unit(channel.units);
}

}  // namespace felt::inkml
