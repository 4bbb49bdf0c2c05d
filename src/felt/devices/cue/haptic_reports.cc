#include "felt/devices/cue/haptic_reports.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

struct Relatives {
  CueWaveform waveform;
  std::uint16_t number;
  std::array<CueWaveform, 4> nearest;
};

using enum CueWaveform;

// The entries for brush and eraser come from HID Usage Tables 1.4, after 0x100E.
constexpr std::array<Relatives, 14> kWaveforms{{
    {kNone, 0x1002, {kNone, kNone, kNone, kNone}},
    {kInk, 0x100B, {kInk, kPencil, kMarker, kBuzz}},
    {kPencil, 0x100C, {kPencil, kInk, kMarker, kBuzz}},
    {kMarker, 0x100D, {kMarker, kChiselMarker, kInk, kBuzz}},
    {kChiselMarker, 0x100E, {kChiselMarker, kMarker, kPencil, kBuzz}},
    {kBrush, 0x100F, {kBrush, kMarker, kInk, kBuzz}},
    {kEraser, 0x1010, {kEraser, kMarker, kPencil, kBuzz}},
    {kBuzz, 0x1004, {kBuzz, kPencil, kMarker, kInk}},
    {kClick, 0x1003, {kClick, kPress, kPress, kPress}},
    {kPress, 0x1006, {kPress, kClick, kClick, kClick}},
    {kRelease, 0x1007, {kRelease, kClick, kClick, kClick}},
    {kHover, 0x1008, {kHover, kClick, kClick, kPress}},
    {kSuccess, 0x1009, {kSuccess, kClick, kClick, kPress}},
    {kError, 0x100A, {kError, kSuccess, kClick, kPress}},
}};

const Relatives& relatives(CueWaveform waveform) noexcept {
  return kWaveforms[std::min(static_cast<std::size_t>(waveform), kWaveforms.size() - 1)];
}

/// Converts `ms` to the field's logical value. The field's unit is the second, multiplied by a
/// power of ten.
std::int64_t logical_ms(const HidField& field, double ms) noexcept {
  const double low = field.physical_minimum, high = field.physical_maximum;
  const double smallest = field.minimum, largest = field.maximum;
  // A field without physical limits and unit is in ms, as in the examples of HUTRR63.
  double physical = ms;
  if (field.unit != 0) physical = ms * 1e-3 * std::pow(10.0, -field.exponent);
  if (low == high) return std::llround(std::clamp(physical, smallest, largest));
  const double share = std::clamp((physical - low) / (high - low), 0.0, 1.0);
  return std::llround(smallest + share * (largest - smallest));
}

std::string_view kind_of(std::uint32_t application) noexcept {
  switch (application) {
    case haptic_usage::kPen:
    case haptic_usage::kDigitizer:
      return "pen";
    case haptic_usage::kTouchpad:
      return "touchpad";
    case haptic_usage::kMouse:
      return "mouse";
    default:
      return "device";
  }
}

bool is_ordinal(std::uint32_t usage) noexcept {
  return usage >> 16 == haptic_usage::kOrdinals && (usage & 0xFFFF) > 0;
}

}  // namespace

std::uint16_t hid_waveform(CueWaveform waveform) noexcept {
  return relatives(waveform).number;
}

std::span<const CueWaveform> nearest_waveforms(CueWaveform waveform) noexcept {
  return relatives(waveform).nearest;
}

std::optional<HapticReports> HapticReports::find(const HidDescriptor& descriptor) {
  const auto& fields = descriptor.fields;
  const auto trigger = std::find_if(fields.begin(), fields.end(), [](const HidField& f) {
    return f.usage == haptic_usage::kManualTrigger && f.kind == HidReportKind::kOutput &&
           !f.is_constant;
  });
  if (trigger == fields.end()) return std::nullopt;
  HapticReports found;
  found.trigger_ = *trigger;
  const auto beside = [&](std::uint32_t usage) -> std::optional<HidField> {
    for (const HidField& f : fields) {
      if (f.usage == usage && f.kind == HidReportKind::kOutput && f.report == trigger->report)
        return f;
    }
    return std::nullopt;
  };
  found.intensity_ = beside(haptic_usage::kIntensity);
  found.repeat_ = beside(haptic_usage::kRepeatCount);
  found.retrigger_ = beside(haptic_usage::kRetriggerPeriod);
  found.cutoff_ = beside(haptic_usage::kCutoffTime);
  for (const HidField& f : fields) {
    if (f.kind != HidReportKind::kFeature || f.group != trigger->group || !is_ordinal(f.usage))
      continue;
    if (f.collection == haptic_usage::kWaveformList) found.waveform_list_.push_back(f);
    if (f.collection == haptic_usage::kDurationList) found.duration_list_.push_back(f);
  }
  found.kind_ = kind_of(trigger->application);
  found.is_touchpad_ = trigger->application == haptic_usage::kTouchpad;
  found.descriptor_ = descriptor;
  found.report_.resize(descriptor.report_bytes(HidReportKind::kOutput, trigger->report));
  return found;
}

tl::expected<std::vector<std::uint32_t>, int> HapticReports::ask_list(
    HidrawPort& port, std::span<const HidField> list) const {
  std::vector<std::uint32_t> values;
  std::optional<std::uint8_t> asked;
  std::vector<std::uint8_t> room;
  for (const HidField& field : list) {
    const std::uint32_t ordinal = field.usage & 0xFFFF;
    if (ordinal >= kMaxOrdinals) continue;
    if (asked != field.report) {
      room.assign(descriptor_.report_bytes(HidReportKind::kFeature, field.report), 0);
      room[0] = field.report;
      const auto count = port.feature(room);
      if (!count) return tl::unexpected(count.error());
      asked = field.report;
    }
    std::int64_t value = hid_value(room, field);
    // Some devices report the ordinal in a constant field. The physical value of the field is then
    // the waveform.
    if (field.physical_minimum == field.physical_maximum && field.physical_minimum > value) {
      value = field.physical_minimum;
    }
    if (values.size() <= ordinal) values.resize(ordinal + 1);
    values[ordinal] = static_cast<std::uint32_t>(std::clamp<std::int64_t>(value, 0, 0xFFFFFF));
  }
  return values;
}

tl::expected<void, int> HapticReports::ask(HidrawPort& port) {
  auto waveforms = ask_list(port, waveform_list_);
  if (!waveforms) return tl::unexpected(waveforms.error());
  waveforms_ = *std::move(waveforms);
  // Durations are useful but optional.
  if (auto durations = ask_list(port, duration_list_)) durations_ = *std::move(durations);
  return {};
}

std::uint32_t HapticReports::ordinal(CueWaveform waveform) const noexcept {
  if (waveform == kNone) return kStop;
  for (const CueWaveform relative : nearest_waveforms(waveform)) {
    const auto at = std::find(waveforms_.begin(), waveforms_.end(), hid_waveform(relative));
    const auto ordinal = static_cast<std::uint32_t>(at - waveforms_.begin());
    if (at != waveforms_.end() && ordinal >= kFirstListed) return ordinal;
  }
  return 0;
}

std::uint32_t HapticReports::duration_ms(std::uint32_t ordinal) const noexcept {
  return ordinal < durations_.size() ? durations_[ordinal] : 0;
}

std::span<const std::uint8_t> HapticReports::play(const Cue& cue, std::uint32_t hold_ms) noexcept {
  const std::uint32_t found = ordinal(cue.waveform);
  if (found == 0 || report_.empty()) return {};
  std::fill(report_.begin(), report_.end(), std::uint8_t{0});
  report_[0] = trigger_.report;
  set_hid_value(report_, trigger_, found);
  if (intensity_) {
    const double share = cue.intensity > 0.0 ? std::min(cue.intensity, 1.0) : 0.0;
    const double low = intensity_->minimum, high = intensity_->maximum;
    set_hid_value(report_, *intensity_, std::llround(low + share * (high - low)));
  }
  if (repeat_) set_hid_value(report_, *repeat_, 0);
  if (retrigger_) set_hid_value(report_, *retrigger_, 0);
  if (cutoff_ && is_continuous(cue.waveform)) {
    set_hid_value(report_, *cutoff_, logical_ms(*cutoff_, hold_ms));
  }
  return report_;
}

}  // namespace felt
