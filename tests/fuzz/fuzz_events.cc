/// Reads any bytes as an event script. The reader must not crash. Accepted events must keep the
/// reader's documented guarantees, and must be unchanged after writing and reading them.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/check.h"
#include "felt/io/events/event_reader.h"
#include "felt/io/events/event_writer.h"
#include "felt/material/material_file.h"
#include "felt/render/picture_pixels.h"

namespace felt {
namespace {

void check_number(double number) {
  FELT_CHECK(std::fabs(number) <= limits::kMaxCoordinate);
}

void check_pose(const Vec3& at, const std::optional<double>& pressure) {
  check_number(at.x);
  check_number(at.y);
  check_number(at.z);
  FELT_CHECK(!pressure || (*pressure >= 0.0 && *pressure <= 1.0));
}

void check_text(const std::string& text) {
  FELT_CHECK(!text.empty() && text.size() <= limits::kMaxNameBytes);
  FELT_CHECK(text.find('\0') == std::string::npos);
}

struct CheckWhat {
  void operator()(const SelectTool& e) const { check_text(e.id); }
  void operator()(const SetOption& e) const {
    check_text(e.id);
    if (const double* number = std::get_if<double>(&e.value)) check_number(*number);
    if (const auto* text = std::get_if<std::string>(&e.value)) {
      FELT_CHECK(text->size() <= limits::kMaxNameBytes);
    }
  }
  void operator()(const PenEvent& e) const { check_pose(e.position, e.pressure); }
  void operator()(const HandEvent& e) const { check_pose(e.target, e.pressure); }
  void operator()(const UndoEvent&) const {}
  void operator()(const RedoEvent&) const {}
  void operator()(const CancelEvent&) const {}
  void operator()(const ExactEvent&) const {}
  void operator()(const ImportEvent& e) const { check_text(e.path); }
  void operator()(const SelectStrokes& e) const {
    FELT_CHECK(e.what <= SelectStrokes::What::kInvert);
  }
  void operator()(const AsDrawnEvent&) const {}
  void operator()(const DeleteEvent&) const {}
  void operator()(const DuplicateEvent&) const {}
  void operator()(const MoveEvent& e) const {
    FELT_CHECK(std::abs(e.by_mm.x) <= MoveEvent::kMaxMm);
    FELT_CHECK(std::abs(e.by_mm.y) <= MoveEvent::kMaxMm);
  }
  void operator()(const OrderEvent& e) const { FELT_CHECK(e.to <= OrderEvent::To::kBack); }
  void operator()(const RestyleEvent& e) const {
    if (!e.color.empty()) check_text(e.color);
    if (!e.medium.empty()) check_text(e.medium);
    FELT_CHECK(!e.opacity || (*e.opacity >= 0.0 && *e.opacity <= 1.0));
    FELT_CHECK(!e.width_factor || (*e.width_factor >= RestyleEvent::kMinWidthFactor &&
                                   *e.width_factor <= RestyleEvent::kMaxWidthFactor));
  }
  void operator()(const LayerEvent& e) const {
    using Do = LayerEvent::Do;
    FELT_CHECK(e.what <= Do::kUngroup);
    const bool is_new = e.what == Do::kAdd || e.what == Do::kGroup;
    const bool has_group = e.group && *e.group;
    FELT_CHECK(is_new ? !e.layer && !e.group : e.layer || has_group);
    FELT_CHECK((e.what == Do::kGroup) == !e.layers.empty());
    FELT_CHECK(e.mode <= BlendMode::kMultiply);
    if (e.what == Do::kRename || !e.name.empty()) check_text(e.name);
    FELT_CHECK(e.name.empty() || is_new || e.what == Do::kRename);
    FELT_CHECK(e.index == 0 || e.what == Do::kMove);
    FELT_CHECK(e.opacity >= 0.0 && e.opacity <= 1.0);
    FELT_CHECK(is_picture_place(e.place));
  }
  void operator()(const AddPicture& e) const {
    FELT_CHECK(e.data && PicturePixels::decode(*e.data).has_value());
    FELT_CHECK(is_picture_place(e.place));
    if (!e.name.empty()) check_text(e.name);
  }
  void operator()(const UseDevice& e) const {
    const Capabilities& can = e.capabilities;
    for (const double quantity :
         {can.max_force_n, can.continuous_force_n, can.advised_force_n, can.max_stiffness_n_per_m,
          can.max_damping_n_s_per_m, can.position_step_mm, can.friction_n, can.mass_kg}) {
      check_number(quantity);
      FELT_CHECK(quantity >= 0.0);
    }
    for (const int count : {can.sensed_axes, can.actuated_axes, can.delay_ticks}) {
      FELT_CHECK(count >= 0 && count <= 1000);
    }
    FELT_CHECK(can.period_ns > 0 && can.period_ns <= 1'000'000'000);
  }
  void operator()(const UseMaterial& e) const {
    FELT_CHECK(!e.text.empty() && e.text.size() <= kMaxMaterialBytes);
  }
  void operator()(const UseGuide& e) const { FELT_CHECK(check_guide(e.line).has_value()); }
  void operator()(const UseEdges& e) const {
    FELT_CHECK(e.page == Rect{} || !e.page.empty());
    FELT_CHECK(e.contours.size() <= UseEdges::kMaxContours);
    for (const auto& contour : e.contours) {
      FELT_CHECK(contour.size() <= UseEdges::kMaxContourPoints);
      for (const Point& p : contour) {
        check_number(p.x);
        check_number(p.y);
      }
    }
    if (e.page.empty()) return;
    for (const double mm : {e.page.x0, e.page.y0, e.page.x1, e.page.y1}) check_number(mm);
  }
  void operator()(const UseRing& e) const {
    for (const Point& p : {e.middle, e.top, e.right}) {
      check_number(p.x);
      check_number(p.y);
    }
  }
  void operator()(const TimingEvent& e) const {
    FELT_CHECK(!e.layers.empty());
    const KeyTiming timing{e.between.value_or(0), e.hold.value_or(1), e.ease.value_or(EaseCurve{}),
                           e.pairs.value_or(std::vector<KeyPair>())};
    FELT_CHECK(check_key_timing(timing).has_value());
  }
  void operator()(const UseView&) const {}
  void operator()(const AddLine& e) const {
    check_number(e.width_mm);
    for (const Point p : e.points) {
      check_number(p.x);
      check_number(p.y);
    }
  }
  void operator()(const BodyEvent& e) const {
    FELT_CHECK(e.what != BodyEvent::Do::kAdd || check_body_edit(e.edit).has_value());
  }
  void operator()(const ChooseOffer& e) const { FELT_CHECK(e.what <= OfferKind::kPolygon); }
  void operator()(const GuidesEvent& e) const {
    FELT_CHECK(e.what != GuidesEvent::Do::kAdd || check_drawing_guide(e.guide).has_value());
  }
};

void check_round_trip(const std::vector<Event>& events) {
  std::string text, again;
  for (const Event& event : events) append_event_line(text, event);
  const Result<std::vector<Event>> read = read_events("again", read_text(text));
  FELT_CHECK(read.has_value() && *read == events);
  for (const Event& event : *read) append_event_line(again, event);
  FELT_CHECK(text == again);
}

/// Checks each line separately, as it is read by a reader that continues after errors.
void check_lines(std::string_view text) {
  constexpr std::size_t kMaxLine = 2000;  // small, so that inputs of the fuzzer exceed it
  LineReader lines(read_text(text), kMaxLine);
  LineBatch batch;
  EventReader reader;
  std::vector<Event> events;
  std::int64_t last_ns = 0;
  while (lines.fill(batch, 512).value_or(false)) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      Event event;
      RawStroke stroke;
      const Result<ScriptLineKind> kind = reader.read(batch.line(i), event, stroke);
      FELT_CHECK(kind || !kind.error().message.empty());
      if (kind != ScriptLineKind::kEvent) continue;
      FELT_CHECK(event.time_ns >= last_ns);
      last_ns = event.time_ns;
      std::visit(CheckWhat{}, event.what);
      events.push_back(event);
    }
  }
  if (!events.empty()) check_round_trip(events);
}

}  // namespace
}  // namespace felt

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  felt::check_lines({reinterpret_cast<const char*>(data), size});
  return 0;
}
