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

/// How a tool rubs on a sheet, as far as a cue device can tell.
struct CueFeel {
  CueWaveform waveform = CueWaveform::kPencil;
  double friction = 0.25;   ///< mu of the pair
  double roughness = 0.75;  ///< how much of the rubbing becomes humming, 0..1
  double grain = 0.0;       ///< 0..1, how much of the relief comes through (Medium::grain)
  double wear = 0.0;        ///< 0..1, share of it that a firm push flattens (Medium::wear)
  const HeightField* relief = nullptr;  ///< of the sheet (surface_grain); null: smooth
};

/// Of a pair. The waveform follows from what the medium feels like to the hand, a person's own
/// included: what rubs out; hairs and fibres, which carry little grain, light or dragging; a nib
/// that glides; wax, a broad marker; a pencil, which on a sheet without any grain glides like ink;
/// and what drags more than a pencil, charcoal and chalk, buzzes. The roughness grows with the
/// relief and with how much of it comes through the tool: 0.4 on glass, 0.81 pencil on paper,
/// towards 1 chalk on a blackboard; estimates, to be tuned. Looks for the relief: not on the haptic
/// thread.
CueFeel cue_feel_of(const Medium& tool, const SurfaceMaterial& surface);

/// What the pen does at one moment.
struct CueInput {
  std::int64_t time_ns = 0;     ///< on any clock that only grows
  bool touches = false;         ///< in_contact() of the sample
  double height_mm = 0.0;       ///< above the sheet
  double speed_mm_per_s = 0.0;  ///< along the sheet
  double push_n = 0.0;          ///< onto it
  Point place{};                ///< where on it, mm
};

/// Of a sample: pressure stands for kFullPushN where the device senses it, else the depth in the
/// sheet's spring.
CueInput cue_input_of(const PenSample& sample, const SurfaceMaterial& surface) noexcept;
inline constexpr double kFullPushN = 2.0;  ///< full width of a line (R17)

/// How strong rubbing is felt, 0..1: continuous, growing with speed up to 1, and with push as far
/// as the medium does not wear the relief away (relief_left of push/kFullPushN, the law of the hand
/// and the eye; it grows all the way up to a wear of 0.5).
///
///   I = r sqrt(P / 75 mW), at most 1,    P = mu Fn (v - 2 mm/s)+
///   r = 0.4 + (roughness - 0.4) relief_left
///
/// Nothing at rest or without push: the first 2 mm/s are a hand that trembles. Why a root of the
/// power of friction: where a fixed share of what rubbing costs becomes vibration, its amplitude is
/// the root of it. Recordings of tools dragged over materials agree in kind: vibration grows with
/// speed and with normal force (Romano and Kuchenbecker, IEEE Trans. Haptics 5(2), 2012), and felt
/// texture grows with the amplitude of vibration that is coupled to the motion (Strohmeier and
/// Hornbaek, CHI 2017). 75 mW: a pencil pressed with 1.5 N at 200 mm/s. The constants are
/// estimates.
double rub_intensity(const CueFeel& feel, double speed_mm_per_s, double push_n) noexcept;

/// The rhythm of the hills that the pen crosses, of the relief that hand, eye and ear have: a
/// factor of the intensity around 1, 1 + told grain relief_left h/(2 rms), h at most 2 rms either
/// way. Cues come 20 times a second where a device is used with care, so hills can be told while
/// at most kToldHillsPerS of them pass a second; from kLostHillsPerS on, where a hand that draws
/// mostly is, they are a steady humming: told falls from 0.6 to 0 between. 0.4 to 1.6, continuous
/// in all, 1 without a relief.
double hill_swell(const CueFeel& feel, const CueInput& now) noexcept;
inline constexpr double kToldHillsPerS = 3.0;
inline constexpr double kLostHillsPerS = 7.0;

/// What only the edit side knows.
enum class CueEvent : std::uint8_t {
  kFound,    ///< a hovering pen came to something that can be taken
  kTook,     ///< a tool took hold of something
  kSnapped,  ///< an end found its target, a curve closed
  kRefused,  ///< there was nothing to take, or the drawing says no
};

/// From what happens to cues: touching and lifting, events, and the humming of the stroke. A
/// deterministic state machine that may be fed at any rate, from 1 kHz to some ten a second:
///
///   law.set_feel(cue_feel_of(tool, sheet));
///   law.tell(CueEvent::kSnapped);                        // when it happens
///   if (auto cue = law.step(cue_input_of(pen, sheet))) device.play(*cue, now_ns);
///
/// * At most one cue every kLeastApartNs, and single ones of one kind kSameApartNs apart. What
/// could
///   not be said within kStaleNs is forgotten; of two events the more important one is said.
/// * Contact has the same hysteresis as ink (a pen is lifted when it is 0.5 mm up or away for 25
///   ms): a pen that chatters on the sheet touches once.
/// * Humming begins at 0.06 and ends below 0.03, follows within some 15 ms, and is said anew when
/// it
///   differs by 0.08 or each kSayAgainNs; a single cue interrupts it for kSingleNs.
/// * Above the sheet there is no humming; numbers that are not finite count as 0, times that run
///   back as no time.
///
/// A value; no allocation. Edit thread as a rule, though nothing in it is forbidden on the other.
class CueLaw {
 public:
  static constexpr std::int64_t kLeastApartNs = 20'000'000;
  static constexpr std::int64_t kSameApartNs = 80'000'000;
  static constexpr std::int64_t kStaleNs = 100'000'000;
  static constexpr std::int64_t kSingleNs = 60'000'000;
  static constexpr std::int64_t kSayAgainNs = kCueHoldNs / 2;
  static constexpr std::int64_t kLiftNs = 25'000'000;
  static constexpr double kLiftMm = 0.5;
  static constexpr double kStart = 0.06;  ///< intensity from which it hums
  static constexpr double kEnd = 0.03;    ///< below which it no longer does
  static constexpr double kStep = 0.08;

  /// Of the next step on.
  void set_feel(const CueFeel& feel) noexcept { feel_ = feel; }
  /// Is said by one of the next steps, unless something more important is.
  void tell(CueEvent event) noexcept;
  /// What is to be played now; nothing as a rule: what plays goes on.
  std::optional<Cue> step(const CueInput& now) noexcept;
  /// As new but for the feel: the device was changed and plays nothing.
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
  std::int64_t last_ns_ = 0;  // of the step before
  bool has_stepped_ = false;
  bool is_down_ = false;
  double away_ns_ = 0.0;  // since it was last in contact, while it is down
  double level_ = 0.0;    // follows rub_intensity with its hill_swell
  bool hums_ = false;
  Cue playing_;                     // the continuous one that was asked for last
  double quiet_ns_ = kLongAgo;      // since the last cue
  double since_single_ = kLongAgo;  // likewise, single
  CueWaveform wanted_ = CueWaveform::kNone;
  double wanted_ns_ = 0.0;              // how long it has been waiting
  std::array<double, kKinds> since_{};  // by kind, since it was said; set by the constructor
};

}  // namespace felt
