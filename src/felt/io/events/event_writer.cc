#include "felt/io/events/event_writer.h"

#include <string>
#include <string_view>
#include <vector>

#include "felt/base/base64.h"
#include "felt/io/events/event_words.h"
#include "felt/io/ndjson/json_text.h"
#include "felt/stroke/color_text.h"

namespace felt {
namespace {

/// Adds the pose of a PenEvent or a HandEvent.
template <class Pose>
void add_pose(JsonObject& out, const Vec3& at, const Pose& pose) {
  out.add_number("x", at.x);
  out.add_number("y", at.y);
  out.add_number("z", at.z);
  if (pose.pressure) out.add_number("pressure", *pose.pressure);
  // As a whole number: the shortest text of 300000 as a double is 3e+05, which is not one.
  if (pose.buttons != 0) out.add_raw("buttons", std::to_string(pose.buttons));
  if (pose.tilt_deg) out.add_number("tilt", *pose.tilt_deg);
}

void add_matrix(JsonObject& out, const Affine& m) {
  std::vector<std::string> numbers;
  for (const double x : {m.a, m.b, m.c, m.d, m.e, m.f}) numbers.push_back(json_number(x));
  out.add_raw("matrix", json_array(numbers));
}

std::string points_text(const std::vector<Point>& points) {
  std::vector<std::string> texts;
  for (const Point p : points) {
    texts.push_back(json_array({json_number(p.x), json_number(p.y)}));
  }
  return json_array(texts);
}

void add_points(JsonObject& out, const std::vector<Point>& points) {
  if (!points.empty()) out.add_raw("points", points_text(points));
}

void add_times(JsonObject& out, const std::vector<double>& times_ms) {
  if (times_ms.empty()) return;
  std::vector<std::string> texts;
  for (const double ms : times_ms) texts.push_back(json_number(ms));
  out.add_raw("times_ms", json_array(texts));
}

/// Adds a guide of the drawing. Leaves out values that a guide has without them.
void add_guide(JsonObject& out, const DrawingGuide& guide) {
  const DrawingGuide plain;
  const auto add = [&](std::string_view key, double value, double usual) {
    if (value != usual) out.add_number(key, value);
  };
  out.add_text("kind", guide_kind_name(guide.kind));
  out.add_number("x", guide.origin.x);
  out.add_number("y", guide.origin.y);
  add("angle_rad", guide.angle_rad, plain.angle_rad);
  add("size_mm", guide.size_mm, plain.size_mm);
  add("second_mm", guide.second_mm, plain.second_mm);
  add("step_rad", guide.step_rad, plain.step_rad);
  add("axes", guide.axes, plain.axes);
  if (guide.stroke) out.add_raw("stroke", std::to_string(guide.stroke.value));
  add_points(out, guide.points);
  add_times(out, guide.times_ms);
  add("strength", guide.strength, plain.strength);
}

std::string vec3_text(const Vec3& p) {
  return json_array({json_number(p.x), json_number(p.y), json_number(p.z)});
}

void add_path(JsonObject& out, std::string_view key, const std::vector<Vec3>& path) {
  if (path.empty()) return;
  std::vector<std::string> texts;
  for (const Vec3& p : path) texts.push_back(vec3_text(p));
  out.add_raw(key, json_array(texts));
}

/// Adds an edit of the body. Leaves out values that an edit has without them.
void add_body_edit(JsonObject& out, const BodyEdit& edit) {
  const BodyEdit plain;
  out.add_text("kind", body_edit_kind_name(edit.kind));
  add_path(out, "path", edit.path_mm);
  add_path(out, "profile", edit.profile_mm);
  if (edit.view != plain.view) out.add_raw("view", vec3_text(edit.view));
  if (edit.width_mm != plain.width_mm) out.add_number("width_mm", edit.width_mm);
  if (edit.color != plain.color) out.add_text("color", color_to_text(edit.color));
  if (edit.amount != plain.amount) out.add_number("amount", edit.amount);
}

/// Adds the kind of an event and its own keys.
struct AddWhat {
  JsonObject& out;

  void kind(std::string_view name) const { out.add_text("event", name); }

  void operator()(const SelectTool& e) const {
    kind("tool");
    out.add_text("id", e.id);
  }
  void operator()(const SetOption& e) const {
    kind("option");
    out.add_text("id", e.id);
    std::visit([this](const auto& value) { option_value(value); }, e.value);
  }
  void operator()(const PenEvent& e) const {
    kind("pen");
    add_pose(out, e.position, e);
  }
  void operator()(const HandEvent& e) const {
    kind("hand");
    add_pose(out, e.target, e);
  }
  void operator()(const UndoEvent&) const { kind("undo"); }
  void operator()(const RedoEvent&) const { kind("redo"); }
  void operator()(const CancelEvent&) const { kind("cancel"); }
  void operator()(const ExactEvent&) const { kind("exact"); }
  void operator()(const ImportEvent& e) const {
    kind("import");
    out.add_text("path", e.path);
    if (e.select) out.add_bool("select", true);
  }
  void operator()(const SelectStrokes& e) const {
    kind("select");
    out.add_text("what", json::word_of(e.what));
  }
  void operator()(const AsDrawnEvent&) const { kind("as-drawn"); }
  void operator()(const DeleteEvent&) const { kind("delete"); }
  void operator()(const DuplicateEvent&) const { kind("duplicate"); }
  void operator()(const MoveEvent& e) const {
    kind("move");
    out.add_number("dx", e.by_mm.x);
    out.add_number("dy", e.by_mm.y);
  }
  void operator()(const OrderEvent& e) const {
    kind("order");
    out.add_text("to", json::word_of(e.to));
  }
  void operator()(const RestyleEvent& e) const {
    kind("restyle");
    if (!e.color.empty()) out.add_text("color", e.color);
    if (!e.medium.empty()) out.add_text("medium", e.medium);
    if (e.opacity) out.add_number("opacity", *e.opacity);
    if (e.width_factor) out.add_number("width", *e.width_factor);
  }
  void operator()(const LayerEvent& e) const {
    kind("layer");
    out.add_text("do", json::word_of(e.what));
    // An id has up to 20 digits: more than a double holds.
    if (e.layer) out.add_raw("id", std::to_string(e.layer.value));
    if (!e.name.empty()) out.add_text("name", e.name);
    if (e.what == LayerEvent::Do::kMove) out.add_raw("index", std::to_string(e.index));
    if (e.what == LayerEvent::Do::kOpacity) out.add_number("opacity", e.opacity);
    if (e.what == LayerEvent::Do::kPlace) add_matrix(out, e.place);
    if (e.what == LayerEvent::Do::kBlend) out.add_text("mode", blend_mode_name(e.mode));
    if (e.group) out.add_raw("group", std::to_string(e.group->value));
    if (e.what == LayerEvent::Do::kGroup) add_layers("ids", e.layers);
    if (e.timing_of) out.add_raw("timing_of", std::to_string(e.timing_of.value));
  }
  void operator()(const AddPicture& e) const {
    kind("picture");
    if (!e.name.empty()) out.add_text("name", e.name);
    add_matrix(out, e.place);
    if (e.opacity != 1.0) out.add_number("opacity", e.opacity);
    out.add_text("png", base64_text(e.data ? e.data->png : std::string()));
  }
  void operator()(const AddLine& e) const {
    kind("line");
    add_points(out, e.points);
    if (e.is_closed) out.add_bool("closed", true);
    out.add_number("width_mm", e.width_mm);
  }
  void operator()(const UseDevice& e) const {
    const Capabilities& can = e.capabilities;
    kind("device");
    out.add_number("sensed_axes", can.sensed_axes);
    out.add_number("actuated_axes", can.actuated_axes);
    out.add_number("max_force_n", can.max_force_n);
    out.add_number("continuous_force_n", can.continuous_force_n);
    out.add_number("advised_force_n", can.advised_force_n);
    out.add_number("max_stiffness_n_per_m", can.max_stiffness_n_per_m);
    out.add_number("max_damping_n_s_per_m", can.max_damping_n_s_per_m);
    out.add_number("position_step_mm", can.position_step_mm);
    if (can.friction_n != 0.0) out.add_number("friction_n", can.friction_n);
    if (can.mass_kg != 0.0) out.add_number("mass_kg", can.mass_kg);
    out.add_number("period_ms", static_cast<double>(can.period_ns) / 1e6);
    out.add_number("delay_ticks", can.delay_ticks);
    out.add_bool("senses_pressure", can.senses_pressure);
    if (can.page_scale != 1.0) out.add_number("page_scale", can.page_scale);
    if (e.defaults != 1) out.add_number("defaults", e.defaults);
  }
  void operator()(const UseMaterial& e) const {
    kind("material");
    out.add_text("text", e.text);
  }
  void operator()(const UseGuide& e) const {
    const GuideLine& line = e.line;
    kind("guide");
    out.add_text("kind", json::word_of(line.kind));
    add_points(out, line.points);
    if (line.is_closed) out.add_bool("closed", true);
    if (line.strength != 1.0) out.add_number("strength", line.strength);
    add_times(out, line.times_ms);
  }
  void operator()(const GuidesEvent& e) const {
    kind("guides");
    out.add_text("do", json::word_of(e.what));
    if (e.id) out.add_raw("id", std::to_string(e.id.value));
    if (e.what == GuidesEvent::Do::kAdd || e.what == GuidesEvent::Do::kChange) {
      add_guide(out, e.guide);
    }
  }
  void operator()(const TimingEvent& e) const {
    kind("timing");
    add_layers("ids", e.layers);
    if (e.between) out.add_raw("between", std::to_string(*e.between));
    if (e.hold) out.add_raw("hold", std::to_string(*e.hold));
    if (e.ease) {
      out.add_raw("ease", json_array({json_number(e.ease->x1), json_number(e.ease->y1),
                                      json_number(e.ease->x2), json_number(e.ease->y2)}));
    }
    if (!e.pairs) return;
    std::vector<std::string> pairs;
    for (const KeyPair& pair : *e.pairs) {
      pairs.push_back(json_array({std::to_string(pair.from.value), std::to_string(pair.to.value)}));
    }
    out.add_raw("pairs", json_array(pairs));
  }
  void operator()(const UseView& e) const {
    kind("view");
    add_layers("hidden", e.hidden);
  }
  void operator()(const BodyEvent& e) const {
    kind("body");
    out.add_text("do", json::word_of(e.what));
    if (e.id) out.add_raw("id", std::to_string(e.id.value));
    if (e.what == BodyEvent::Do::kAdd) add_body_edit(out, e.edit);
  }
  void operator()(const UseEdges& e) const {
    kind("edges");
    if (!e.page.empty()) {
      std::vector<std::string> numbers;
      for (const double mm : {e.page.x0, e.page.y0, e.page.x1, e.page.y1}) {
        numbers.push_back(json_number(mm));
      }
      out.add_raw("page", json_array(numbers));
    }
    if (e.selection) out.add_bool("selection", true);
    if (e.contours.empty()) return;
    std::vector<std::string> contours;
    for (const auto& contour : e.contours) contours.push_back(points_text(contour));
    out.add_raw("contours", json_array(contours));
  }
  void operator()(const UseRing& e) const {
    kind("ring");
    if (e.is_open) add_points(out, {{e.middle, e.top, e.right}});
  }
  void operator()(const ChooseOffer& e) const {
    kind("choose");
    out.add_text("what", json::word_of(e.what));
  }

 private:
  void add_layers(std::string_view key, const std::vector<LayerId>& layers) const {
    std::vector<std::string> ids;
    for (const LayerId id : layers) ids.push_back(std::to_string(id.value));
    out.add_raw(key, json_array(ids));
  }
  void option_value(double number) const { out.add_number("value", number); }
  void option_value(bool is_on) const { out.add_bool("value", is_on); }
  void option_value(const std::string& text) const { out.add_text("value", text); }
};

}  // namespace

void append_event_line(std::string& out, const Event& event) {
  JsonObject line;
  line.add_number("t_ms", static_cast<double>(event.time_ns) / 1e6);
  std::visit(AddWhat{line}, event.what);
  out += line.text() + "\n";
}

}  // namespace felt
