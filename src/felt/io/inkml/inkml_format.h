#pragma once

/// What the numbers of an InkML trace mean. Private to this layer.

#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace felt::inkml {

/// Channels of a point beyond this are an error: no pen has as many.
inline constexpr std::size_t kMaxChannels = 64;

/// Channels that become ink; others are read over.
enum class ChannelName {
  kX,
  kY,
  kForce,
  kTime,
  kWidth,
  kTip,
  kEraser,
  kTiltX,      ///< OTx
  kTiltY,      ///< OTy
  kElevation,  ///< OE: between the pen and the sheet
  kOther
};

/// One channel of a format.
struct Channel {
  ChannelName name = ChannelName::kOther;
  std::string text;  ///< its name in the file
  std::string units;
  bool is_integer = false;
  bool is_reversed = false;  ///< orientation "-ve"
  std::optional<double> least, most;
};

/// The channels of a point in their order, regular ones first.
struct Format {
  std::vector<Channel> channels;
};

/// How a device counts a channel: value per units ("1000" "1/cm").
struct Resolution {
  std::string channel;
  double value = 0.0;
  std::string units;
};

/// A number as files of others write it: without limit, in any locale. None for anything else.
std::optional<double> number_of(std::string_view text) noexcept;

/// Length of a unit in mm ("cm", "himetric", ...), duration in ms ("s", ...), angle in degrees.
std::optional<double> mm_of_unit(std::string_view unit) noexcept;
std::optional<double> ms_of_unit(std::string_view unit) noexcept;
std::optional<double> deg_of_unit(std::string_view unit) noexcept;

/// A traceFormat element; more than kMaxChannels: the first problem in `problem`.
Format read_format(const pugi::xml_node& node, std::string& problem);
/// X and Y, which is what a trace has where nothing is said.
Format default_format();

/// How much one unit of a channel is, in mm, ms or degrees: by its resolution, else by its units.
/// None where the file does not say it.
std::optional<double> scale_of(const Channel& channel, const std::vector<Resolution>& resolutions);

}  // namespace felt::inkml
