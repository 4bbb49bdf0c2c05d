#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "felt/geometry/height_field.h"
#include "felt/haptics/cue.h"
#include "felt/haptics/pen_sample.h"
#include "felt/material/materials.h"

namespace felt {

/// How a medium rubs on a surface, as far as a cue device can render it.
struct CueFeel {
  CueWaveform waveform = CueWaveform::kPencil;
  double friction = 0.25;   ///< mu of the medium on the surface
  double roughness = 0.75;  ///< share of the rubbing that becomes humming, 0..1
  double grain = 0.0;       ///< 0..1, share of the relief that is felt through the medium
  double wear = 0.0;        ///< 0..1, share of the relief that a firm push flattens (Medium::wear)
  /// Relief of the surface (surface_grain); null means smooth.
  const HeightField* relief = nullptr;
};

/// Returns the cue feel of a medium on a surface. The waveform follows from the medium's
/// properties, so that custom media also have a waveform. The first of these that applies is used:
/// kEraser if the medium does not draw; kBrush or kMarker, depending on friction, if little grain
/// is felt through it (hairs and fibres); kInk if it glides; kChiselMarker if it is waxy; kPencil
/// if it has about the friction of a pencil or less (but kInk on a surface without grain);
/// otherwise kBuzz (charcoal, chalk). The roughness grows with the relief and with the share of the
/// relief that is felt: 0.4 on glass, 0.81 for a pencil on paper, towards 1 for chalk on a
/// blackboard. These values are estimates. The function looks up the relief, so don't call it on
/// the haptic thread.
CueFeel cue_feel_of(const Medium& tool, const SurfaceMaterial& surface);

/// The state of the pen at one moment.
struct CueInput {
  std::int64_t time_ns = 0;     ///< on any monotonic clock
  bool touches = false;         ///< in_contact() of the sample
  double height_mm = 0.0;       ///< above the surface
  double speed_mm_per_s = 0.0;  ///< along the surface
  double push_n = 0.0;          ///< onto the surface
  Point place{};                ///< position on the surface, mm
};

/// Converts a sample of the pen. If the device senses pressure, a pressure of 1 counts as
/// kFullPushN; otherwise the push follows from the depth in the surface's spring.
CueInput cue_input_of(const PenSample& sample, const SurfaceMaterial& surface) noexcept;
inline constexpr double kFullPushN = 2.0;  ///< full width of a line (R17)

/// Returns how strongly rubbing is felt, 0..1. It is continuous and grows with speed up to 1. It
/// also grows with the push, unless the push flattens the relief faster. The share of the relief
/// that is left is relief_left(wear, push/kFullPushN), the same formula as for the relief that the
/// hand feels and for the relief on screen. If the wear is at most 0.5, the intensity always grows
/// with the push.
///
///   I = r sqrt(P / 75 mW), at most 1,    P = mu Fn (v - 2 mm/s)+
///   r = 0.4 + (roughness - 0.4) relief_left
///
/// (x)+ is max(0, x). The intensity is 0 without push and at rest; the first 2 mm/s are ignored
/// because they may be hand tremor. It is proportional to the root of the friction power P because,
/// if a fixed share of P becomes vibration, the amplitude of the vibration is proportional to the
/// root of P. Recordings of tools dragged over materials show the same tendency: vibration grows
/// with speed and with normal force (Romano and Kuchenbecker, IEEE Trans. Haptics 5(2), 2012), and
/// felt texture grows with the amplitude of vibration that is coupled to the motion (Strohmeier and
/// Hornbaek, CHI 2017). 75 mW is the power of a pencil that is pressed with 1.5 N and moved at 200
/// mm/s. The constants are estimates.
double rub_intensity(const CueFeel& feel, double speed_mm_per_s, double push_n) noexcept;

/// Returns a factor for the intensity, around 1. It renders the hills of the relief that the pen
/// crosses: 1 + reported grain relief_left h/(2 rms). The height h is limited to 2 rms in either
/// direction. This is the same relief that is also rendered as force, ink and sound. A device
/// receives only some 20 cues a second, so hills can be rendered fully only if at most
/// kReportedHillsPerS of them pass per second. At kLostHillsPerS and more, which is typical of
/// drawing, the hills merge into steady humming: `reported` falls from 0.6 to 0 between the two
/// rates. The result is 0.4 to 1.6, continuous, and 1 without a relief.
double hill_swell(const CueFeel& feel, const CueInput& now) noexcept;
inline constexpr double kReportedHillsPerS = 3.0;
inline constexpr double kLostHillsPerS = 7.0;

/// Events that only the edit thread can report.
enum class CueEvent : std::uint8_t {
  kFound,    ///< a hovering pen reached something that can be grabbed
  kTook,     ///< a tool grabbed something
  kSnapped,  ///< an end found its target, a curve closed
  kRefused,  ///< nothing could be grabbed, or the drawing does not allow it
};

/// Decides which cues to play: for touching and lifting, for events, and for the humming of the
/// stroke. It is a deterministic state machine that may be updated at any rate, from about ten
/// times a second to 1 kHz:
///
///   law.set_feel(cue_feel_of(medium, surface));
///   law.report(CueEvent::kSnapped);                      // when it happens
///   if (auto cue = law.step(cue_input_of(pen, surface))) device.play(*cue, now_ns);
///
/// * It sends at most one cue every kMinApartNs; single cues of one kind are at least kSameApartNs
///   apart. A cue that could not be sent within kStaleNs is dropped. If two cues wait, only the
///   more important one is sent.
/// * Contact has the same hysteresis as ink, except while a pen lands: a pen counts as lifted when
/// it
///   is 0.5 mm above the surface or has been off the surface for 25 ms. So a pen that chatters on
///   the surface counts as touching once.
/// * Humming starts at an intensity of 0.06 and ends below 0.03. It follows changes within some 15
///   ms. Its cue is sent again when the intensity has changed by 0.08, or every kSayAgainNs. A
///   single cue interrupts the humming for kSingleNs.
/// * A pen above the surface does not hum. Numbers that are not finite count as 0, and if time runs
///   backwards, the law assumes that no time has passed.
///
/// CueLaw is a value type that does not allocate. It is normally used on the edit thread, but it is
/// real-time safe, too.
class CueLaw {
 public:
  static constexpr std::int64_t kMinApartNs = 20'000'000;
  static constexpr std::int64_t kSameApartNs = 80'000'000;
  static constexpr std::int64_t kStaleNs = 100'000'000;
  static constexpr std::int64_t kSingleNs = 60'000'000;
  static constexpr std::int64_t kSayAgainNs = kCueHoldNs / 2;
  static constexpr std::int64_t kLiftNs = 25'000'000;
  static constexpr double kLiftMm = 0.5;
  static constexpr double kStart = 0.06;  ///< intensity at which humming starts
  static constexpr double kEnd = 0.03;    ///< intensity below which it ends
  static constexpr double kStep = 0.08;

  /// Sets the feel, which is used from the next step on.
  void set_feel(const CueFeel& feel) noexcept { feel_ = feel; }
  /// Requests the cue of an event. One of the next steps sends it, unless a more important one
  /// replaces it.
  void report(CueEvent event) noexcept;
  /// Returns the cue to play now. Usually returns nullopt, which means that the current cue
  /// continues.
  std::optional<Cue> step(const CueInput& now) noexcept;
  /// Resets all state except the feel. Call it if the device was replaced and does not play
  /// anything.
  void reset() noexcept { *this = CueLaw(feel_); }

  CueLaw() noexcept : CueLaw(CueFeel{}) {}

 private:
  static constexpr std::size_t kKinds = static_cast<std::size_t>(CueWaveform::kError) + 1;

  static constexpr double kLongAgo = 1e18;

  explicit CueLaw(const CueFeel& feel) noexcept : feel_(feel) { since_.fill(kLongAgo); }
  void follow_contact(const CueInput& now, double passed_ns) noexcept;
  void follow_level(const CueInput& now, double passed_ns) noexcept;
  void want(CueWaveform waveform) noexcept;
  std::optional<Cue> say_single() noexcept;
  std::optional<Cue> say_humming() noexcept;

  CueFeel feel_;
  std::int64_t last_ns_ = 0;  // time of the previous step
  bool has_stepped_ = false;
  bool is_down_ = false;
  double away_ns_ = 0.0;  // since the last contact, while is_down_
  double level_ = 0.0;    // follows rub_intensity times hill_swell
  bool hums_ = false;
  Cue playing_;                     // the continuous cue that was sent last
  double quiet_ns_ = kLongAgo;      // since the last cue
  double since_single_ = kLongAgo;  // since the last single cue
  CueWaveform wanted_ = CueWaveform::kNone;
  double wanted_ns_ = 0.0;              // time for which it has been waiting
  std::array<double, kKinds> since_{};  // since a cue of this kind was sent; set by the constructor
};

}  // namespace felt
