#include <array>

#include "felt/devices/haply/json_walk.h"
#include "felt/devices/haply/service_messages.h"

namespace felt::haply {
namespace {

struct Raw {
  std::string_view name, level, message, device_id, safety_type;
};

bool read_word(JsonScanner& json, std::string_view& word) noexcept {
  JsonScanner ahead = json;
  if (ahead.next() != JsonToken::kString) return json.skip_value();
  json = ahead;
  word = json.text();
  return true;
}

bool read_raw(JsonScanner& json, Raw& raw) noexcept {
  return walk_object(json, [&](std::string_view key) {
    if (key == "name") return read_word(json, raw.name);
    if (key == "level") return read_word(json, raw.level);
    if (key == "message") return read_word(json, raw.message);
    JsonScanner ahead = json;
    if (key != "data" || ahead.next() != JsonToken::kBeginObject) return json.skip_value();
    json = ahead;
    return walk_entered_object(json, [&](std::string_view inner) {
      if (inner == "device_id") return read_word(json, raw.device_id);
      if (inner == "safety_type") return read_word(json, raw.safety_type);
      return json.skip_value();
    });
  });
}

bool is_serious(std::string_view level) noexcept {
  return level == "error" || level == "critical" || level == "panic";
}

EventKind safety_kind(const Raw& raw) noexcept {
  if (raw.safety_type == "ebrake_triggered") return EventKind::kBrakeOn;
  if (raw.safety_type == "ebrake_released") return EventKind::kBrakeOff;
  // The service reports each change of the guard's stage: as a warning if the stage has risen, and
  // as information if it has fallen.
  if (raw.safety_type == "fod_stage_changed" && raw.level != "warning" && !is_serious(raw.level)) {
    return EventKind::kNotice;
  }
  return EventKind::kForceStopped;  // stall, stability ceiling, and kinds that we do not know
}

EventKind kind_of(const Raw& raw, bool is_ours) noexcept {
  if (raw.name == "device-battery-low" || raw.name == "device-battery-critical" ||
      raw.name == "device-sleep") {
    return EventKind::kNotice;  // about a grip, which has its own id
  }
  if (!is_ours) return EventKind::kNone;
  if (raw.name == "device-safety-triggered") return safety_kind(raw);
  if (raw.name == "device-disconnected") {
    return raw.device_id.empty() ? EventKind::kNotice : EventKind::kGone;
  }
  constexpr std::array<std::string_view, 3> kReported{"device-busy", "device-connection-loop",
                                                      "device-calibration-failed"};
  for (const std::string_view name : kReported) {
    if (raw.name == name) return EventKind::kNotice;
  }
  const bool is_rate = raw.name.find("rate") != std::string_view::npos;
  const bool is_reported = is_serious(raw.level) || (is_rate && raw.level == "warning");
  return is_reported ? EventKind::kNotice : EventKind::kNone;
}

}  // namespace

std::optional<Event> read_event(std::string_view message, std::string_view device_id) noexcept {
  JsonScanner json(message);
  Raw raw;
  if (!read_raw(json, raw) || json.next() != JsonToken::kEnd) return std::nullopt;
  const bool is_ours = raw.device_id.empty() || raw.device_id == device_id;
  Event event;
  event.kind = kind_of(raw, is_ours);
  if (event.kind != EventKind::kNone) {
    event.words = ShortText(raw.message.empty() ? raw.name : raw.message);
  }
  return event;
}

}  // namespace felt::haply
