#include "felt/io/events/event_reader.h"

#include <optional>
#include <utility>

#include "felt/io/events/body_fields.h"
#include "felt/io/events/event_fields.h"
#include "felt/io/events/guide_fields.h"
#include "felt/io/events/timing_fields.h"
#include "felt/io/ndjson/ndjson_parser.h"

namespace felt {
namespace {

using json::EventFields;
using json::EventName;
using json::Value;

/// Number of bytes of lines that read_script keeps in memory at a time.
constexpr std::size_t kBatchBytes = std::size_t{64} << 10;

/// The kind of a line, found in a first pass over its keys.
struct Glance {
  std::optional<EventName> event;
  bool is_other = false;  ///< the line is a stroke or a header, which NdjsonParser reads
};

/// Copies only the fields that the action of the event uses.
LayerEvent layer_event(EventFields&& fields) {
  using Do = LayerEvent::Do;
  LayerEvent event{fields.action, fields.layer};
  const bool is_new = event.what == Do::kAdd || event.what == Do::kGroup;
  if (is_new || event.what == Do::kUngroup) event.layer = {};
  if (is_new || event.what == Do::kRename) event.name = std::move(fields.name);
  if (event.what == Do::kAdd) event.timing_of = fields.timing_of;
  if (event.what == Do::kGroup) event.layers = std::move(fields.layers);
  const bool is_of_group = !event.layer && !is_new;
  if (is_of_group || event.what == Do::kMove) event.group = fields.group;
  if (event.what == Do::kMove) event.index = fields.index.value_or(0);
  if (event.what == Do::kOpacity) event.opacity = fields.opacity.value_or(1.0);
  if (event.what == Do::kBlend) event.mode = fields.mode.value_or(BlendMode::kNormal);
  if (event.what == Do::kPlace) event.place = fields.matrix.value_or(Affine{});
  return event;
}

decltype(Event::what) content_of_other(EventName name, EventFields&& fields) {
  switch (name) {
    case EventName::kTiming:
      return std::move(fields.timing);
    case EventName::kBody:
      return std::move(fields.body);
    case EventName::kView:
      return UseView{std::move(fields.layers)};
    case EventName::kLine:
      return AddLine{std::move(fields.guide.points), fields.guide.is_closed, fields.width_mm};
    case EventName::kEdges:
      return fields.edges;
    case EventName::kRing: {
      const std::vector<Point>& points = fields.guide.points;
      return points.empty() ? UseRing{} : UseRing{true, points[0], points[1], points[2]};
    }
    default:
      return ChooseOffer{fields.offer};
  }
}

decltype(Event::what) content_of(EventName name, EventFields&& fields) {
  switch (name) {
    case EventName::kTool:
      return SelectTool{std::move(fields.id)};
    case EventName::kOption:
      return SetOption{std::move(fields.id), std::move(fields.value)};
    case EventName::kPen:
      return PenEvent{fields.position, fields.pressure, fields.buttons, fields.tilt_deg};
    case EventName::kHand:
      return HandEvent{fields.position, fields.pressure, fields.buttons, fields.tilt_deg};
    case EventName::kUndo:
      return UndoEvent{};
    case EventName::kRedo:
      return RedoEvent{};
    case EventName::kCancel:
      return CancelEvent{};
    case EventName::kAsDrawn:
      return AsDrawnEvent{};
    case EventName::kExact:
      return ExactEvent{};
    case EventName::kImport:
      return ImportEvent{std::move(fields.path), fields.select};
    case EventName::kSelect:
      return SelectStrokes{fields.selection};
    case EventName::kDelete:
      return DeleteEvent{};
    case EventName::kDuplicate:
      return DuplicateEvent{};
    case EventName::kMove:
      return MoveEvent{{fields.position.x, fields.position.y}};
    case EventName::kOrder:
      return OrderEvent{fields.order};
    case EventName::kRestyle:
      return RestyleEvent{std::move(fields.color), std::move(fields.medium), fields.opacity,
                          fields.width_factor};
    case EventName::kLayer:
      return layer_event(std::move(fields));
    case EventName::kPicture:
      return AddPicture{std::move(fields.name), std::move(fields.picture),
                        fields.matrix.value_or(Affine{}), fields.opacity.value_or(1.0)};
    case EventName::kDevice:
      return UseDevice{fields.device, fields.defaults};
    case EventName::kMaterial:
      return UseMaterial{std::move(fields.text)};
    case EventName::kGuides:
      return std::move(fields.guides);
    case EventName::kGuide:
      return UseGuide{std::move(fields.guide)};
    default:
      return content_of_other(name, std::move(fields));
  }
}

/// A pose without z is valid only if it has a pressure, which says whether the pen touches.
Result<void> check_pose(EventName name, const EventFields& fields) {
  const bool is_pose = name == EventName::kPen || name == EventName::kHand;
  if (!is_pose || fields.has_z || fields.pressure) return {};
  return json::bad("key \"z\" is missing, and there is no pressure");
}

/// A layer event is for a layer, several layers or a group.
Result<void> check_layer_name(const EventFields& fields) {
  using Do = LayerEvent::Do;
  const bool has_group = fields.group && *fields.group;
  switch (fields.action) {
    case Do::kAdd:
      return {};
    case Do::kGroup:
      return fields.layers.empty() ? json::bad("key \"ids\" is missing") : Result<void>();
    case Do::kUngroup:
      return has_group ? Result<void>() : json::bad("key \"group\" is missing");
    case Do::kUse:
    case Do::kMerge:
    case Do::kPlace:
    case Do::kExport:
    case Do::kLeaveOut:
      break;
    default:
      if (has_group) return {};
  }
  return fields.layer ? Result<void>() : json::bad("key \"id\" is missing");
}

/// The required keys of a layer event depend on its action.
Result<void> check_layer(EventName name, const EventFields& fields) {
  if (name != EventName::kLayer) return {};
  if (auto named = check_layer_name(fields); !named) return named;
  if (fields.action == LayerEvent::Do::kRename && fields.name.empty()) {
    return json::bad("key \"name\" is missing");
  }
  if (fields.action == LayerEvent::Do::kMove && !fields.index) {
    return json::bad("key \"index\" is missing");
  }
  if (fields.action == LayerEvent::Do::kOpacity && !fields.opacity) {
    return json::bad("key \"opacity\" is missing");
  }
  if (fields.action == LayerEvent::Do::kPlace && !fields.matrix) {
    return json::bad("key \"matrix\" is missing");
  }
  if (fields.action == LayerEvent::Do::kBlend && !fields.mode) {
    return json::bad("key \"mode\" is missing");
  }
  return {};
}

/// A ring has all of its points, or none if it closes.
Result<void> check_ring(EventName name, const EventFields& fields) {
  const std::size_t points = fields.guide.points.size();
  if (name != EventName::kRing || points == 0 || points == 3) return {};
  return json::bad("points: a ring has three, its middle, its top and its right");
}

/// Checks an event whose fields depend on each other, and keeps the fields that it uses.
template <class T>
Result<void> keep_event(Result<T> event, T& out) {
  if (!event) return tl::unexpected(event.error());
  out = *std::move(event);
  return {};
}

Result<void> check_whole_event(EventName name, EventFields& fields) {
  switch (name) {
    case EventName::kGuides:
      return keep_event(json::guides_event(std::move(fields)), fields.guides);
    case EventName::kTiming:
      return keep_event(json::timing_event(std::move(fields)), fields.timing);
    case EventName::kBody:
      return keep_event(json::body_event(std::move(fields)), fields.body);
    default:
      return {};
  }
}

std::string milliseconds_text(std::int64_t time_ns) {
  std::string text = std::to_string(static_cast<double>(time_ns) / 1e6);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

struct EventReader::State {
  simdjson::ondemand::parser parser;
  NdjsonParser strokes;
  std::int64_t last_ns = 0;

  /// Finds the kind of a line. Reads only the value of "event" and skips all others.
  Result<Glance> look(const NdjsonLine& line) {
    Glance seen;
    const auto take = [&seen](std::string_view key, Value value) -> Result<void> {
      if (key == "points" || key == "feltline") seen.is_other = true;
      if (key != "event" || seen.event) return {};
      const Result<EventName> name = json::parse_event_name(value);
      if (!name) return tl::unexpected(name.error());
      seen.event = *name;
      return {};
    };
    if (Result<void> walked = json::for_each_member(parser, line, take); !walked) {
      return tl::unexpected(walked.error());
    }
    return seen;
  }

  Result<Event> event(const NdjsonLine& line, EventName name) {
    EventFields values;
    json::Fields<EventFields> fields(json::fields_of(name), values);
    Result<void> read = json::for_each_member(
        parser, line,
        [&fields](std::string_view key, Value value) { return fields.take(key, value); });
    if (read) read = fields.finish();
    if (read) read = check_pose(name, values);
    if (read) read = check_layer(name, values);
    if (read) read = check_ring(name, values);
    if (read && name == EventName::kGuide) read = check_guide(values.guide);
    if (read) read = check_whole_event(name, values);
    if (!read) return tl::unexpected(read.error());
    if (values.time_ns < last_ns) {
      return json::bad("t_ms: " + milliseconds_text(values.time_ns) + " is before " +
                       milliseconds_text(last_ns) + ", the time of the previous event");
    }
    last_ns = values.time_ns;
    const std::int64_t time_ns = values.time_ns;
    return Event{time_ns, content_of(name, std::move(values))};
  }
};

EventReader::EventReader() : state_(std::make_unique<State>()) {}
EventReader::~EventReader() = default;
EventReader::EventReader(EventReader&&) noexcept = default;
EventReader& EventReader::operator=(EventReader&&) noexcept = default;

Result<ScriptLineKind> EventReader::read(const NdjsonLine& line, Event& event, RawStroke& stroke) {
  const Result<Glance> seen = state_->look(line);
  if (!seen) return tl::unexpected(seen.error());
  if (seen->event) {
    Result<Event> read = state_->event(line, *seen->event);
    if (!read) return tl::unexpected(read.error());
    event = std::move(*read);
    return ScriptLineKind::kEvent;
  }
  if (!seen->is_other) return json::bad("neither an event nor a stroke: key \"event\" is missing");
  const Result<NdjsonKind> kind = state_->strokes.raw_stroke(line, stroke);
  if (!kind) return tl::unexpected(kind.error());
  return *kind == NdjsonKind::kHeader ? ScriptLineKind::kHeader : ScriptLineKind::kStroke;
}

namespace {

Result<void> read_line(EventReader& reader, const NdjsonLine& line, const ScriptSink& sink) {
  Event event;
  RawStroke stroke;
  const Result<ScriptLineKind> kind = reader.read(line, event, stroke);
  if (!kind) return tl::unexpected(kind.error());
  if (*kind == ScriptLineKind::kEvent) return sink.event(event);
  if (*kind == ScriptLineKind::kHeader) return {};
  if (sink.stroke) return sink.stroke(stroke);
  return json::bad("found a stroke, but only events are allowed");
}

}  // namespace

Result<void> read_script(const std::string& name, ReadBytes read, const ScriptSink& sink) {
  LineReader lines(std::move(read));
  LineBatch batch;
  EventReader reader;
  for (;;) {
    const Result<bool> more = lines.fill(batch, kBatchBytes);
    if (!more) return tl::unexpected(with_context(more.error(), name));
    if (!*more) return {};
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      if (Result<void> done = read_line(reader, line, sink); !done) {
        return tl::unexpected(
            with_context(done.error(), name + ":" + std::to_string(line.number())));
      }
    }
  }
}

Result<std::vector<Event>> read_events(const std::string& name, ReadBytes read) {
  std::vector<Event> events;
  ScriptSink sink;
  sink.event = [&events](const Event& event) -> Result<void> {
    events.push_back(event);
    return {};
  };
  if (Result<void> done = read_script(name, std::move(read), sink); !done) {
    return tl::unexpected(done.error());
  }
  return events;
}

}  // namespace felt
