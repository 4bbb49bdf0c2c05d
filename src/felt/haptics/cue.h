#pragma once

#include <cstdint>

namespace felt {

/// Waveforms that consumer haptics know: those of page 0x0E of the HID Usage Tables, which other
/// families are mapped to. The first group goes on while it lasts, the second plays once.
enum class CueWaveform : std::uint8_t {
  kNone,
  // Continuous: what the nib does on the sheet.
  kInk,
  kPencil,
  kMarker,
  kChiselMarker,
  kBrush,
  kEraser,
  kBuzz,  ///< anything else that rubs
  // Single: something happened.
  kClick,    ///< a tool took hold of something
  kPress,    ///< the nib touches
  kRelease,  ///< it lets go
  kHover,    ///< something can be taken here
  kSuccess,  ///< an end snapped, a curve closed
  kError,    ///< nothing to take here
};

/// How long a continuous waveform lasts that is not said again.
inline constexpr std::int64_t kCueHoldNs = 400'000'000;

constexpr bool is_continuous(CueWaveform waveform) noexcept {
  return waveform >= CueWaveform::kInk && waveform <= CueWaveform::kBuzz;
}

/// What a cue device is asked for: a waveform and how strong, 0..1. A continuous one holds until
/// the next cue, whatever that is, or until kCueHoldNs have passed: whoever wants it longer says it
/// again, so that nothing hums on beside a program that hangs. kNone is silence. Trivially
/// copyable.
struct Cue {
  CueWaveform waveform = CueWaveform::kNone;
  double intensity = 0.0;

  friend constexpr bool operator==(const Cue&, const Cue&) noexcept = default;
};

}  // namespace felt
