#pragma once

/// The channels of an InkML trace and the meaning of their numbers. Private to this layer.

#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace felt::inkml {

/// Maximum number of channels in a point. No pen has that many, so a larger number is an error.
inline constexpr std::size_t kMaxChannels = 64;

/// The channels that affect the ink. All other channels are read and ignored.
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
  kElevation,  ///< OE: angle between the pen and the surface
  kOther
};

/// One channel of a format.
struct Channel {
  ChannelName name = ChannelName::kOther;
  std::string text;  ///< name in the file
  std::string units;
  bool is_integer = false;
  bool is_reversed = false;  ///< orientation "-ve"
  std::optional<double> smallest, largest;
};

/// The channels of a point in order: first the regular ones, then the intermittent ones, which a
/// point may omit.
struct Format {
  std::vector<Channel> channels;
};

/// The resolution of a channel, for example value 1000 and units "1/cm".
struct Resolution {
  std::string channel;
  double value = 0.0;
  std::string units;
};

/// Parses a number with a decimal point, in any locale, with optional spaces and a leading plus.
/// Returns nullopt for anything else, including infinity and NaN.
std::optional<double> number_of(std::string_view text) noexcept;

/// Return the length in mm, the duration in ms, or the angle in degrees of a unit such as "cm",
/// "himetric" or "s".
std::optional<double> mm_of_unit(std::string_view unit) noexcept;
std::optional<double> ms_of_unit(std::string_view unit) noexcept;
std::optional<double> deg_of_unit(std::string_view unit) noexcept;

/// Reads a traceFormat element. If the element has more than kMaxChannels channels or another
/// error, stores the first error in `problem`.
Format read_format(const pugi::xml_node& node, std::string& problem);
/// Returns the default format of a trace: X and Y.
Format default_format();

/// Returns the size of one unit of a channel in mm, ms or degrees, from its resolution or, if the
/// channel has no resolution, from its units. Returns nullopt if the file specifies neither.
std::optional<double> scale_of(const Channel& channel, const std::vector<Resolution>& resolutions);

}  // namespace felt::inkml
