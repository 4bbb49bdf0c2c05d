#include "felt/io/events/event_fields.h"

#include <array>
#include <cmath>
#include <limits>

#include "felt/geometry/tilt.h"
#include "felt/io/events/body_fields.h"
#include "felt/io/events/event_values.h"
#include "felt/io/events/event_words.h"
#include "felt/io/events/guide_fields.h"
#include "felt/io/events/layer_fields.h"
#include "felt/io/events/timing_fields.h"
#include "felt/material/material_file.h"
#include "felt/stroke/fit/sample_faults.h"

namespace felt::json {
namespace {

constexpr NumberLimit kMoveLimit = {MoveEvent::kMaxMm, "10000"};
constexpr NumberLimit kPeriodLimit = {1000.0, "1000"};
constexpr std::uint64_t kMaxCounted = 1000;

template <double Vec3::*Axis>
Result<void> parse_axis(Value& value, const char* key, EventFields& out) {
  return parse_number(value, key, kCoordinateLimit, out.position.*Axis);
}

/// Reads a part of the offset of a move event.
template <double Vec3::*Axis>
Result<void> parse_shift(Value& value, const char* key, EventFields& out) {
  return parse_number(value, key, kMoveLimit, out.position.*Axis);
}

Result<void> parse_time(Value& value, EventFields& out) {
  double ms = 0.0;
  if (Result<void> read = parse_number(value, "t_ms", kEventTimeLimit, ms); !read) return read;
  if (ms < 0.0) return bad("t_ms: is before 0, the start of the session");
  out.time_ns = std::llround(ms * 1e6);
  return {};
}

Result<void> parse_pressure(Value& value, EventFields& out) {
  if (token_of(value) == "null") return {};
  double pressure = 0.0;
  if (Result<void> read = parse_number(value, "pressure", kCoordinateLimit, pressure); !read) {
    return read;
  }
  // Drivers slightly exceed their own range, but a raw pressure (0 to 1023) has no meaning.
  if (pressure < -kPressureSlack || pressure > 1.0 + kPressureSlack) {
    return bad("pressure: is not between 0 and 1");
  }
  out.pressure = std::fmin(std::fmax(pressure, 0.0), 1.0);
  return {};
}

Result<void> parse_buttons(Value& value, EventFields& out) {
  const std::string_view token = token_of(value);
  std::uint64_t bits = 0;
  if (token.size() > limits::kMaxNumberChars || value.get_uint64().get(bits) ||
      bits > std::numeric_limits<std::uint32_t>::max()) {
    return bad("buttons: " + excerpt(token) + " is not a whole number from 0 to 4294967295");
  }
  out.buttons = static_cast<std::uint32_t>(bits);
  return {};
}

Result<void> parse_tilt(Value& value, EventFields& out) {
  const std::string_view token = token_of(value);
  if (token == "null") return {};
  double tilt_deg = 0.0;
  if (Result<void> read = parse_number(value, "tilt", kCoordinateLimit, tilt_deg); !read) {
    return read;
  }
  if (tilt_deg < 0.0 || tilt_deg > kMaxTiltDeg) {
    return bad("tilt: " + excerpt(token) + " is not an angle from 0 to 90 degrees");
  }
  out.tilt_deg = tilt_deg;
  return {};
}

Result<void> parse_opacity(Value& value, EventFields& out) {
  double opacity = 0.0;
  if (Result<void> read = parse_number(value, "opacity", kCoordinateLimit, opacity); !read) {
    return read;
  }
  if (opacity < 0.0 || opacity > 1.0) return bad("opacity: is not a number from 0 to 1");
  out.opacity = opacity;
  return {};
}

Result<void> parse_width_factor(Value& value, EventFields& out) {
  double factor = 0.0;
  if (Result<void> read = parse_number(value, "width", kCoordinateLimit, factor); !read) {
    return read;
  }
  if (factor < RestyleEvent::kMinWidthFactor || factor > RestyleEvent::kMaxWidthFactor) {
    return bad("width: is not a factor from 0.01 to 100");
  }
  out.width_factor = factor;
  return {};
}

/// Reads a non-negative quantity of a device.
template <double Capabilities::*Quantity>
Result<void> parse_quantity(Value& value, const char* key, EventFields& out) {
  double& number = out.device.*Quantity;
  if (Result<void> read = parse_number(value, key, kCoordinateLimit, number); !read) return read;
  if (number < 0.0) return bad(std::string(key) + ": is negative");
  return {};
}

/// Reads a small whole number that is not negative: a number of axes or ticks.
template <int Capabilities::*Count>
Result<void> parse_count(Value& value, const char* key, EventFields& out) {
  const std::string_view token = token_of(value);
  std::uint64_t count = 0;
  if (token.size() > limits::kMaxNumberChars || value.get_uint64().get(count) ||
      count > kMaxCounted) {
    return bad(std::string(key) + ": " + excerpt(token) + " is not a whole number from 0 to 1000");
  }
  out.device.*Count = static_cast<int>(count);
  return {};
}

Result<void> parse_period(Value& value, EventFields& out) {
  double ms = 0.0;
  if (Result<void> read = parse_number(value, "period_ms", kPeriodLimit, ms); !read) return read;
  out.device.period_ns = std::llround(ms * 1e6);
  if (out.device.period_ns > 0) return {};
  return bad("period_ms: is not more than 0");
}

Result<void> parse_senses_pressure(Value& value, EventFields& out) {
  const Result<bool> senses = read_bool(value);
  if (!senses) return tl::unexpected(with_context(senses.error(), "senses_pressure"));
  out.device.senses_pressure = *senses;
  return {};
}

Result<void> parse_defaults(Value& value, EventFields& out) {
  const std::string_view token = token_of(value);
  std::uint64_t version = 0;
  if (token.size() > limits::kMaxNumberChars || value.get_uint64().get(version) || version == 0) {
    return bad("defaults: " + excerpt(token) + " is not a whole number of at least 1");
  }
  if (version > kOptionDefaults) {
    return bad("defaults: " + excerpt(token) + " is from a newer version of Feltline");
  }
  out.defaults = static_cast<int>(version);
  return {};
}

Result<void> parse_select(Value& value, EventFields& out) {
  const Result<bool> select = read_bool(value);
  if (!select) return tl::unexpected(with_context(select.error(), "select"));
  out.select = *select;
  return {};
}

using EventField = Field<EventFields>;

/// The key "event". It is parsed first, because its value decides which other keys apply.
constexpr EventField kEvent = {"event", true, [](Value& v, EventFields&) -> Result<void> {
                                 const Result<EventName> name = parse_event_name(v);
                                 if (!name) return tl::unexpected(name.error());
                                 return {};
                               }};
constexpr EventField kTime = {"t_ms", true, parse_time};
constexpr EventField kId = {"id", true,
                            [](Value& v, EventFields& e) { return parse_text(v, "id", e.id); }};

constexpr std::array kPlainFields = {kEvent, kTime};
constexpr std::array kToolFields = {kEvent, kTime, kId};
constexpr std::array kOptionFields = {kEvent, kTime, kId,
                                      EventField{"value", true, parse_option_value}};
constexpr std::array kImportFields = {
    kEvent, kTime,
    EventField{"path", true,
               [](Value& v, EventFields& e) { return parse_text(v, "path", e.path); }},
    EventField{"select", false, parse_select}};
constexpr std::array kSelectFields = {
    kEvent, kTime, EventField{"what", true, [](Value& v, EventFields& e) {
                                return parse_word(v, "what", kSelectionWords, e.selection);
                              }}};
constexpr std::array kChooseFields = {
    kEvent, kTime, EventField{"what", true, [](Value& v, EventFields& e) {
                                return parse_word(v, "what", kOfferKinds, e.offer);
                              }}};
constexpr std::array kLayerFields = {
    kEvent,
    kTime,
    EventField{"do", true,
               [](Value& v, EventFields& e) { return parse_word(v, "do", kLayerWords, e.action); }},
    EventField{"id", false, parse_layer},
    EventField{"index", false, parse_index},
    EventField{"name", false,
               [](Value& v, EventFields& e) { return parse_text(v, "name", e.name); }},
    EventField{"opacity", false, parse_opacity},
    EventField{"matrix", false, parse_matrix},
    EventField{"mode", false, parse_mode},
    EventField{"group", false, parse_group},
    EventField{"ids", false, parse_layers},
    EventField{"timing_of", false, parse_timing_of}};
constexpr std::array kMoveFields = {
    kEvent, kTime,
    EventField{"dx", false,
               [](Value& v, EventFields& e) { return parse_shift<&Vec3::x>(v, "dx", e); }},
    EventField{"dy", false,
               [](Value& v, EventFields& e) { return parse_shift<&Vec3::y>(v, "dy", e); }}};
constexpr std::array kOrderFields = {kEvent, kTime,
                                     EventField{"to", true, [](Value& v, EventFields& e) {
                                                  return parse_word(v, "to", kOrderWords, e.order);
                                                }}};
constexpr std::array kPictureFields = {
    kEvent,
    kTime,
    EventField{"name", false,
               [](Value& v, EventFields& e) { return parse_text(v, "name", e.name); }},
    EventField{"png", true, parse_png},
    EventField{"matrix", true, parse_matrix},
    EventField{"opacity", false, parse_opacity}};
constexpr std::array kMaterialFields = {
    kEvent, kTime, EventField{"text", true, [](Value& v, EventFields& e) {
                                return parse_text(v, "text", e.text, kMaxMaterialBytes);
                              }}};
constexpr std::array kPoseFields = {
    kEvent,
    kTime,
    EventField{"x", true, [](Value& v, EventFields& e) { return parse_axis<&Vec3::x>(v, "x", e); }},
    EventField{"y", true, [](Value& v, EventFields& e) { return parse_axis<&Vec3::y>(v, "y", e); }},
    EventField{"z", false,
               [](Value& v, EventFields& e) {
                 e.has_z = true;
                 return parse_axis<&Vec3::z>(v, "z", e);
               }},
    EventField{"pressure", false, parse_pressure},
    EventField{"buttons", false, parse_buttons},
    EventField{"tilt", false, parse_tilt},
    EventField{"lean", false, parse_tilt},  // "tilt" in older recordings
};

constexpr std::array kRestyleFields = {
    kEvent,
    kTime,
    EventField{"color", false,
               [](Value& v, EventFields& e) { return parse_text(v, "color", e.color); }},
    EventField{"medium", false,
               [](Value& v, EventFields& e) { return parse_text(v, "medium", e.medium); }},
    EventField{"opacity", false, parse_opacity},
    EventField{"width", false, parse_width_factor},
};

constexpr std::array kDeviceFields = {
    kEvent,
    kTime,
    EventField{"sensed_axes", false,
               [](Value& v, EventFields& e) {
                 return parse_count<&Capabilities::sensed_axes>(v, "sensed_axes", e);
               }},
    EventField{"actuated_axes", false,
               [](Value& v, EventFields& e) {
                 return parse_count<&Capabilities::actuated_axes>(v, "actuated_axes", e);
               }},
    EventField{"max_force_n", false,
               [](Value& v, EventFields& e) {
                 return parse_quantity<&Capabilities::max_force_n>(v, "max_force_n", e);
               }},
    EventField{"continuous_force_n", false,
               [](Value& v, EventFields& e) {
                 return parse_quantity<&Capabilities::continuous_force_n>(v, "continuous_force_n",
                                                                          e);
               }},
    EventField{"advised_force_n", false,
               [](Value& v, EventFields& e) {
                 return parse_quantity<&Capabilities::advised_force_n>(v, "advised_force_n", e);
               }},
    EventField{"max_stiffness_n_per_m", false,
               [](Value& v, EventFields& e) {
                 return parse_quantity<&Capabilities::max_stiffness_n_per_m>(
                     v, "max_stiffness_n_per_m", e);
               }},
    EventField{"max_damping_n_s_per_m", false,
               [](Value& v, EventFields& e) {
                 return parse_quantity<&Capabilities::max_damping_n_s_per_m>(
                     v, "max_damping_n_s_per_m", e);
               }},
    EventField{"position_step_mm", false,
               [](Value& v, EventFields& e) {
                 return parse_quantity<&Capabilities::position_step_mm>(v, "position_step_mm", e);
               }},
    EventField{"friction_n", false,
               [](Value& v, EventFields& e) {
                 return parse_quantity<&Capabilities::friction_n>(v, "friction_n", e);
               }},
    EventField{"mass_kg", false,
               [](Value& v, EventFields& e) {
                 return parse_quantity<&Capabilities::mass_kg>(v, "mass_kg", e);
               }},
    EventField{"period_ms", false, parse_period},
    EventField{"delay_ticks", false,
               [](Value& v, EventFields& e) {
                 return parse_count<&Capabilities::delay_ticks>(v, "delay_ticks", e);
               }},
    EventField{"senses_pressure", false, parse_senses_pressure},
    EventField{"defaults", false, parse_defaults},
    EventField{"page_scale", false,
               [](Value& v, EventFields& e) {
                 return parse_quantity<&Capabilities::page_scale>(v, "page_scale", e);
               }},
    EventField{"sheet_scale", false,  // "page_scale" in older recordings
               [](Value& v, EventFields& e) {
                 return parse_quantity<&Capabilities::page_scale>(v, "sheet_scale", e);
               }},
};

constexpr std::array kGuideFields = {
    kEvent,
    kTime,
    EventField{
        "kind", true,
        [](Value& v, EventFields& e) { return parse_word(v, "kind", kGuideWords, e.guide.kind); }},
    EventField{"points", false, parse_guide_points},
    EventField{"closed", false, parse_closed_guide},
    EventField{"strength", false,
               [](Value& v, EventFields& e) {
                 return parse_number(v, "strength", kCoordinateLimit, e.guide.strength);
               }},
    EventField{"times_ms", false, parse_guide_times},
};

constexpr std::array kGuidesFields = {
    kEvent,
    kTime,
    EventField{
        "do", true,
        [](Value& v, EventFields& e) { return parse_word(v, "do", kGuidesWords, e.guides.what); }},
    EventField{"id", false, parse_guide_id},
    EventField{"kind", false, parse_guide_kind},
    EventField{"x", false,
               [](Value& v, EventFields& e) { return parse_axis<&Vec3::x>(v, "x", e); }},
    EventField{"y", false,
               [](Value& v, EventFields& e) { return parse_axis<&Vec3::y>(v, "y", e); }},
    EventField{"angle_rad", false,
               [](Value& v, EventFields& e) {
                 return parse_number(v, "angle_rad", kCoordinateLimit, e.guides.guide.angle_rad);
               }},
    EventField{"size_mm", false,
               [](Value& v, EventFields& e) {
                 return parse_number(v, "size_mm", kCoordinateLimit, e.guides.guide.size_mm);
               }},
    EventField{"second_mm", false,
               [](Value& v, EventFields& e) {
                 return parse_number(v, "second_mm", kCoordinateLimit, e.guides.guide.second_mm);
               }},
    EventField{"step_rad", false,
               [](Value& v, EventFields& e) {
                 return parse_number(v, "step_rad", kCoordinateLimit, e.guides.guide.step_rad);
               }},
    EventField{"axes", false, parse_guide_axes},
    EventField{"stroke", false, parse_guide_stroke},
    EventField{"points", false, parse_guide_points},
    EventField{"times_ms", false, parse_guide_times},
    EventField{"strength", false,
               [](Value& v, EventFields& e) {
                 return parse_number(v, "strength", kCoordinateLimit, e.guides.guide.strength);
               }},
};

constexpr std::array kEdgesFields = {kEvent, kTime, EventField{"page", false, parse_edges_page},
                                     EventField{"selection", false, parse_edges_selection},
                                     EventField{"contours", false, parse_edges_contours}};

constexpr std::array kRingFields = {kEvent, kTime, EventField{"points", false, parse_guide_points}};

constexpr std::array kTimingFields = {kEvent,
                                      kTime,
                                      EventField{"ids", true, parse_layers},
                                      EventField{"between", false, parse_timing_between},
                                      EventField{"hold", false, parse_timing_hold},
                                      EventField{"ease", false, parse_timing_ease},
                                      EventField{"pairs", false, parse_timing_pairs}};

constexpr std::array kBodyFields = {
    kEvent,
    kTime,
    EventField{
        "do", true,
        [](Value& v, EventFields& e) { return parse_word(v, "do", kBodyWords, e.body.what); }},
    EventField{"id", false, parse_body_id},
    EventField{"kind", false, parse_body_kind},
    EventField{"path", false, parse_body_path},
    EventField{"profile", false, parse_body_profile},
    EventField{"view", false, parse_body_view},
    EventField{"width_mm", false,
               [](Value& v, EventFields& e) {
                 return parse_number(v, "width_mm", kCoordinateLimit, e.body.edit.width_mm);
               }},
    EventField{"color", false, parse_body_color},
    EventField{"amount", false,
               [](Value& v, EventFields& e) {
                 return parse_number(v, "amount", kCoordinateLimit, e.body.edit.amount);
               }},
};

constexpr std::array kViewFields = {kEvent, kTime, EventField{"hidden", true, parse_hidden_layers}};

constexpr std::array kLineFields = {
    kEvent,
    kTime,
    EventField{"points", true, parse_guide_points},
    EventField{"closed", false, parse_closed_guide},
    EventField{"width_mm", false,
               [](Value& v, EventFields& e) {
                 return parse_number(v, "width_mm", kCoordinateLimit, e.width_mm);
               }},
};

struct NamedEvent {
  std::string_view text;
  EventName name;
  std::span<const EventField> fields;
};
constexpr NamedEvent kEvents[] = {
    {"tool", EventName::kTool, kToolFields},
    {"option", EventName::kOption, kOptionFields},
    {"pen", EventName::kPen, kPoseFields},
    {"hand", EventName::kHand, kPoseFields},
    {"undo", EventName::kUndo, kPlainFields},
    {"redo", EventName::kRedo, kPlainFields},
    {"cancel", EventName::kCancel, kPlainFields},
    {"as-drawn", EventName::kAsDrawn, kPlainFields},
    {"exact", EventName::kExact, kPlainFields},
    {"import", EventName::kImport, kImportFields},
    {"select", EventName::kSelect, kSelectFields},
    {"delete", EventName::kDelete, kPlainFields},
    {"duplicate", EventName::kDuplicate, kPlainFields},
    {"move", EventName::kMove, kMoveFields},
    {"order", EventName::kOrder, kOrderFields},
    {"restyle", EventName::kRestyle, kRestyleFields},
    {"layer", EventName::kLayer, kLayerFields},
    {"picture", EventName::kPicture, kPictureFields},
    {"device", EventName::kDevice, kDeviceFields},
    {"material", EventName::kMaterial, kMaterialFields},
    {"guide", EventName::kGuide, kGuideFields},
    {"choose", EventName::kChoose, kChooseFields},
    {"guides", EventName::kGuides, kGuidesFields},
    {"edges", EventName::kEdges, kEdgesFields},
    {"ring", EventName::kRing, kRingFields},
    {"timing", EventName::kTiming, kTimingFields},
    {"body", EventName::kBody, kBodyFields},
    {"view", EventName::kView, kViewFields},
    {"line", EventName::kLine, kLineFields},
};

}  // namespace

Result<EventName> parse_event_name(Value& value) {
  const std::string_view token = token_of(value);
  std::string_view text;
  if (const auto error = value.get_string().get(text)) {
    if (error == simdjson::INCORRECT_TYPE) {
      return bad("event: " + excerpt(token) + " is not a string");
    }
    return tl::unexpected(with_context(syntax_error(error), "event"));
  }
  for (const NamedEvent& event : kEvents) {
    if (event.text == text) return event.name;
  }
  std::string known;
  for (const NamedEvent& event : kEvents) {
    known += (known.empty() ? "" : ", ") + std::string(event.text);
  }
  return bad("event: \"" + excerpt(text) + "\" is not one of " + known);
}

std::span<const Field<EventFields>> fields_of(EventName name) noexcept {
  return kEvents[static_cast<std::size_t>(name)].fields;
}

}  // namespace felt::json
