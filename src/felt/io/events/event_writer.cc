#include "felt/io/events/event_writer.h"

#include <string_view>

#include "felt/io/events/event_words.h"
#include "felt/io/ndjson/ndjson_writer.h"

namespace felt {
namespace {

void append_key_number(std::string& out, std::string_view key, double number) {
  out += ",\"";
  out += key;
  out += "\":";
  append_number(out, number);
}

void append_key_string(std::string& out, std::string_view key, std::string_view text) {
  out += ",\"";
  out += key;
  out += "\":";
  append_json_string(out, text);
}

/// Of a PenEvent or a HandEvent.
template <class Pose>
void append_pose(std::string& out, const Vec3& at, const Pose& pose) {
  append_key_number(out, "x", at.x);
  append_key_number(out, "y", at.y);
  append_key_number(out, "z", at.z);
  if (pose.pressure) append_key_number(out, "pressure", *pose.pressure);
  if (pose.buttons != 0) append_key_number(out, "buttons", pose.buttons);
  if (pose.lean_deg) append_key_number(out, "lean", *pose.lean_deg);
}

/// Appends the kind of an event and its own keys.
struct AppendWhat {
  std::string& out;

  void kind(std::string_view name) const { append_key_string(out, "event", name); }

  void operator()(const SelectTool& e) const {
    kind("tool");
    append_key_string(out, "id", e.id);
  }
  void operator()(const SetOption& e) const {
    kind("option");
    append_key_string(out, "id", e.id);
    std::visit([this](const auto& value) { option_value(value); }, e.value);
  }
  void operator()(const PenEvent& e) const {
    kind("pen");
    append_pose(out, e.position, e);
  }
  void operator()(const HandEvent& e) const {
    kind("hand");
    append_pose(out, e.target, e);
  }
  void operator()(const UndoEvent&) const { kind("undo"); }
  void operator()(const RedoEvent&) const { kind("redo"); }
  void operator()(const CancelEvent&) const { kind("cancel"); }
  void operator()(const ImportEvent& e) const {
    kind("import");
    append_key_string(out, "path", e.path);
    if (e.select) out += ",\"select\":true";
  }
  void operator()(const SelectStrokes& e) const {
    kind("select");
    append_key_string(out, "what", json::word_of(e.what));
  }
  void operator()(const DeleteEvent&) const { kind("delete"); }
  void operator()(const DuplicateEvent&) const { kind("duplicate"); }
  void operator()(const RestyleEvent& e) const {
    kind("restyle");
    if (!e.color.empty()) append_key_string(out, "color", e.color);
    if (!e.medium.empty()) append_key_string(out, "medium", e.medium);
  }
  void operator()(const LayerEvent& e) const {
    kind("layer");
    append_key_string(out, "do", json::word_of(e.what));
    // An id has up to 20 digits: more than a double holds.
    if (e.layer) out += ",\"id\":" + std::to_string(e.layer.value);
    if (!e.name.empty()) append_key_string(out, "name", e.name);
    if (e.what == LayerEvent::Do::kMove) out += ",\"index\":" + std::to_string(e.index);
  }
  void operator()(const UseDevice& e) const {
    const Capabilities& can = e.capabilities;
    kind("device");
    append_key_number(out, "sensed_axes", can.sensed_axes);
    append_key_number(out, "actuated_axes", can.actuated_axes);
    append_key_number(out, "max_force_n", can.max_force_n);
    append_key_number(out, "continuous_force_n", can.continuous_force_n);
    append_key_number(out, "advised_force_n", can.advised_force_n);
    append_key_number(out, "max_stiffness_n_per_m", can.max_stiffness_n_per_m);
    append_key_number(out, "max_damping_n_s_per_m", can.max_damping_n_s_per_m);
    append_key_number(out, "position_step_mm", can.position_step_mm);
    append_key_number(out, "period_ms", static_cast<double>(can.period_ns) / 1e6);
    append_key_number(out, "delay_ticks", can.delay_ticks);
    out += can.senses_pressure ? ",\"senses_pressure\":true" : ",\"senses_pressure\":false";
    if (can.sheet_scale != 1.0) append_key_number(out, "sheet_scale", can.sheet_scale);
    if (e.defaults != 1) append_key_number(out, "defaults", e.defaults);
  }
  void operator()(const UseMaterial& e) const {
    kind("material");
    append_key_string(out, "text", e.text);
  }

 private:
  void option_value(double number) const { append_key_number(out, "value", number); }
  void option_value(bool is_on) const { out += is_on ? ",\"value\":true" : ",\"value\":false"; }
  void option_value(const std::string& text) const { append_key_string(out, "value", text); }
};

}  // namespace

void append_event_line(std::string& out, const Event& event) {
  out += "{\"t_ms\":";
  append_number(out, static_cast<double>(event.time_ns) / 1e6);
  std::visit(AppendWhat{out}, event.what);
  out += "}\n";
}

}  // namespace felt
