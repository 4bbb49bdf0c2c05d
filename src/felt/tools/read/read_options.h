#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "felt/tools/tool_options.h"

namespace felt {

/// Which layers are read. The values are the indices of kReadLayerNames.
enum class ReadLayers : std::uint8_t { kVisible, kCurrent };

inline constexpr std::array<std::string_view, 2> kReadLayerNames = {"visible", "current"};

/// Indices of the rows of kReadOptions.
struct ReadOption {
  enum Row : std::size_t { kLayers, kSound, kStrength, kCount };
};

inline constexpr std::array<OptionSpec, ReadOption::kCount> kReadOptions = {{
    {.id = "layers",
     .label = "Layers",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kReadLayerNames,
     .help = "Reads all visible layers, or only the current one. Alt+Page up and Alt+Page down "
             "choose it."},
    {.id = "sound",
     .label = "Sound of the distance",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 1,
     .choices = {},
     .help = "A tone says how far the nearest line is: pulses that become faster and higher, and a "
             "steady tone on the line."},
    strength_option("Force level of the lines. Does not affect the hardness of the surface."),
}};

/// The values of the options in the form that the tool uses.
struct ReadSettings {
  ReadLayers layers = ReadLayers::kVisible;
  bool has_sound = true;
  double strength = 1.0;
};

/// Returns the settings. Requires values of kReadOptions.
inline ReadSettings read_settings(const OptionValues& values) {
  return {static_cast<ReadLayers>(values.choice(ReadOption::kLayers)),
          values.is_on(ReadOption::kSound), values.number(ReadOption::kStrength)};
}

}  // namespace felt
