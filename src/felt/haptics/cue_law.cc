#include "felt/haptics/cue_law.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/haptics/capabilities.h"
#include "felt/material/relief.h"

namespace felt {
namespace {

constexpr double kRestMmPerS = 2.0;
constexpr double kFullPowerMw = 75.0;
constexpr double kFollowNs = 15e6;
constexpr double kSmooth = 0.4;      // roughness of a surface without grain
constexpr double kRoughUm = 3.0;     // grain at which 63 % of the remaining roughness is reached
constexpr double kLongAgoNs = 1e18;  // far beyond any session

struct Single {
  CueWaveform waveform;
  int rank;  ///< the cue with the higher rank is sent
  double intensity;
};

// The amplitudes are estimates. A cue that informs the user is stronger than a cue that confirms
// the user's own action.
constexpr std::array<Single, 6> kSingles{{
    {CueWaveform::kHover, 1, 0.30},
    {CueWaveform::kRelease, 2, 0.35},
    {CueWaveform::kPress, 3, 0.45},
    {CueWaveform::kClick, 4, 0.60},
    {CueWaveform::kSuccess, 5, 0.80},
    {CueWaveform::kError, 6, 0.70},
}};

const Single& single(CueWaveform waveform) noexcept {
  const auto* const at = std::find_if(kSingles.begin(), kSingles.end(),
                                      [=](const Single& s) { return s.waveform == waveform; });
  return at == kSingles.end() ? kSingles.front() : *at;
}

CueWaveform waveform_of(const Medium& tool) noexcept {
  constexpr double kSoftTip = 0.3, kWax = 0.6;                     // grain
  constexpr double kWet = 0.2, kGliding = 0.17, kGraphite = 0.35;  // friction on paper
  if (!tool.draws) return CueWaveform::kEraser;
  if (tool.grain < kSoftTip)
    return tool.friction < kWet ? CueWaveform::kBrush : CueWaveform::kMarker;
  if (tool.friction < kGliding) return CueWaveform::kInk;
  if (tool.grain < kWax) return CueWaveform::kChiselMarker;
  return tool.friction < kGraphite ? CueWaveform::kPencil : CueWaveform::kBuzz;
}

CueWaveform waveform_of(CueEvent event) noexcept {
  switch (event) {
    case CueEvent::kFound:
      return CueWaveform::kHover;
    case CueEvent::kTook:
      return CueWaveform::kClick;
    case CueEvent::kSnapped:
      return CueWaveform::kSuccess;
    case CueEvent::kRefused:
      return CueWaveform::kError;
  }
  return CueWaveform::kNone;
}

}  // namespace

CueFeel cue_feel_of(const Medium& tool, const SurfaceMaterial& surface) {
  CueFeel feel;
  feel.relief = surface_grain(surface);
  feel.grain = tool.grain;
  feel.wear = tool.wear;
  feel.waveform = waveform_of(tool);
  if (feel.waveform == CueWaveform::kPencil && feel.relief == nullptr) {
    feel.waveform = CueWaveform::kInk;
  }
  feel.friction = friction_of(tool, surface);
  const double rough_um = feel.relief == nullptr ? 0.0 : tool.grain * feel.relief->spec().rms_um;
  feel.roughness = kSmooth + (1.0 - kSmooth) * (1.0 - std::exp(-rough_um / kRoughUm));
  return feel;
}

CueInput cue_input_of(const PenSample& sample, const SurfaceMaterial& surface) noexcept {
  CueInput now;
  now.time_ns = sample.time_ns;
  now.touches = in_contact(sample);
  now.height_mm = finite_positive(sample.position.z);
  now.place = on_page(sample.position);
  now.speed_mm_per_s = std::hypot(sample.velocity.x, sample.velocity.y);
  if (!now.touches) return now;
  now.push_n = sample.pressure
                   ? kFullPushN * std::min(finite_positive(*sample.pressure), 1.0)
                   : 1e-3 * surface.stiffness_n_per_m * finite_positive(depth_mm(sample));
  return now;
}

double rub_intensity(const CueFeel& feel, double speed_mm_per_s, double push_n) noexcept {
  const double speed = finite_positive(finite_positive(speed_mm_per_s) - kRestMmPerS);
  const double power_mw = finite_positive(feel.friction) * finite_positive(push_n) * speed;
  const double roughness = std::min(finite_positive(feel.roughness), 1.0);
  const double smooth = std::min(roughness, kSmooth);
  const double left = relief_left(feel.wear, finite_positive(push_n) / kFullPushN);
  return std::min(1.0, (smooth + (roughness - smooth) * left) * std::sqrt(power_mw / kFullPowerMw));
}

double hill_swell(const CueFeel& feel, const CueInput& now) noexcept {
  constexpr double kMaxReported = 0.6, kHighest = 2.0;
  if (feel.relief == nullptr || !(feel.relief->spec().rms_um > 0.0)) return 1.0;
  const double hills_per_s =
      finite_positive(now.speed_mm_per_s) / feel.relief->spec().wavelength_mm;
  const double x =
      std::clamp((kLostHillsPerS - hills_per_s) / (kLostHillsPerS - kReportedHillsPerS), 0.0, 1.0);
  const double reported = kMaxReported * x * x * (3.0 - 2.0 * x);
  const double share = std::min(finite_positive(feel.grain), 1.0) *
                       relief_left(feel.wear, finite_positive(now.push_n) / kFullPushN);
  const double height = 1e3 * feel.relief->at(now.place).height_mm / feel.relief->spec().rms_um;
  return 1.0 + reported * share * std::clamp(height / kHighest, -1.0, 1.0);
}

void CueLaw::report(CueEvent event) noexcept {
  want(waveform_of(event));
}

void CueLaw::want(CueWaveform waveform) noexcept {
  if (since_[static_cast<std::size_t>(waveform)] < static_cast<double>(kSameApartNs)) return;
  if (wanted_ != CueWaveform::kNone && single(wanted_).rank > single(waveform).rank) return;
  wanted_ = waveform;
  wanted_ns_ = 0.0;
}

std::optional<Cue> CueLaw::step(const CueInput& now) noexcept {
  // Computed in double, because the difference of two arbitrary times may not fit into 64 bits.
  const double passed_ns =
      has_stepped_
          ? std::clamp(static_cast<double>(now.time_ns) - static_cast<double>(last_ns_), 0.0, 1e15)
          : 0.0;
  has_stepped_ = true;
  last_ns_ = now.time_ns;
  const auto age = [passed_ns](double& ns) { ns = std::min(ns + passed_ns, kLongAgoNs); };
  age(quiet_ns_);
  age(since_single_);
  age(wanted_ns_);
  for (double& ns : since_) age(ns);
  follow_contact(now, passed_ns);
  follow_level(now, passed_ns);
  if (wanted_ns_ > static_cast<double>(kStaleNs)) wanted_ = CueWaveform::kNone;
  if (quiet_ns_ < static_cast<double>(kMinApartNs)) return std::nullopt;
  const std::optional<Cue> cue = wanted_ != CueWaveform::kNone ? say_single() : say_humming();
  if (cue) quiet_ns_ = 0.0;
  return cue;
}

void CueLaw::follow_contact(const CueInput& now, double passed_ns) noexcept {
  if (now.touches) {
    away_ns_ = 0.0;
    if (!std::exchange(is_down_, true)) want(CueWaveform::kPress);
    return;
  }
  if (!is_down_) return;
  away_ns_ += passed_ns;
  if (away_ns_ < static_cast<double>(kLiftNs) && finite_positive(now.height_mm) < kLiftMm) return;
  is_down_ = false;
  want(CueWaveform::kRelease);
}

/// If the pen is off the surface for a moment, humming continues unchanged.
void CueLaw::follow_level(const CueInput& now, double passed_ns) noexcept {
  if (!is_down_) {
    level_ = 0.0;
    hums_ = false;
    return;
  }
  const double rubs = rub_intensity(feel_, now.speed_mm_per_s, now.push_n);
  const double to = now.touches ? std::min(1.0, rubs * hill_swell(feel_, now)) : level_;
  level_ += (1.0 - std::exp(-passed_ns / kFollowNs)) * (to - level_);
  hums_ = level_ >= (hums_ ? kEnd : kStart);
}

std::optional<Cue> CueLaw::say_single() noexcept {
  const Single& said = single(std::exchange(wanted_, CueWaveform::kNone));
  since_[static_cast<std::size_t>(said.waveform)] = 0.0;
  since_single_ = 0.0;
  playing_ = {};
  return Cue{said.waveform, said.intensity};
}

std::optional<Cue> CueLaw::say_humming() noexcept {
  const Cue to = hums_ ? Cue{feel_.waveform, level_} : Cue{};
  if (to.waveform == CueWaveform::kNone) {
    if (playing_.waveform == CueWaveform::kNone) return std::nullopt;
    return playing_ = Cue{};
  }
  if (since_single_ < static_cast<double>(kSingleNs)) return std::nullopt;
  const bool is_same =
      to.waveform == playing_.waveform && std::abs(to.intensity - playing_.intensity) < kStep;
  if (is_same && quiet_ns_ < static_cast<double>(kSayAgainNs)) return std::nullopt;
  return playing_ = to;
}

}  // namespace felt
