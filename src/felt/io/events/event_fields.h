#pragma once

/// The keys of event lines, each parsed into its field. Private to this layer. Errors start with
/// the key.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "felt/geometry/vec3.h"
#include "felt/io/ndjson/ndjson_object.h"
#include "felt/session/event.h"

namespace felt::json {

/// The values of an event line, for all kinds of events.
struct EventFields {
  std::int64_t time_ns = 0;
  std::string id;
  OptionValue value;
  Vec3 position;
  bool has_z = false;
  std::optional<double> pressure;
  std::uint32_t buttons = 0;
  std::optional<double> tilt_deg;
  std::string path;
  bool select = false;
  int defaults = 1;  ///< version of the default options; 1 if the recording has none
  SelectStrokes::What selection{};
  OrderEvent::To order{};
  LayerEvent::Do action{};
  LayerId timing_of;
  LayerId layer;
  std::string name;
  Capabilities device;
  std::optional<std::size_t> index;
  std::string text;
  std::string color;
  std::string medium;
  std::optional<double> opacity;
  std::optional<double> width_factor;
  std::shared_ptr<const PictureData> picture;
  std::optional<Affine> matrix;
  std::optional<BlendMode> mode;
  std::optional<GroupId> group;
  std::vector<LayerId> layers;
  GuideLine guide;
  OfferKind offer{};
  GuidesEvent guides;
  bool has_kind = false;  ///< of guides
  UseEdges edges;
  TimingEvent timing;
  BodyEvent body;
  double width_mm = 1.0;  ///< of a line
};

/// The kinds of events, by their name in the file.
enum class EventName {
  kTool,
  kOption,
  kPen,
  kHand,
  kUndo,
  kRedo,
  kCancel,
  kAsDrawn,
  kExact,
  kImport,
  kSelect,
  kDelete,
  kDuplicate,
  kMove,
  kOrder,
  kRestyle,
  kLayer,
  kPicture,
  kDevice,
  kMaterial,
  kGuide,
  kChoose,
  kGuides,
  kEdges,
  kRing,
  kTiming,
  kBody,
  kView,
  kLine
};

/// Returns the kind of event. Fails if the name is unknown.
Result<EventName> parse_event_name(Value& value);

/// Returns the keys of one kind of event, including `event` and `t_ms`.
std::span<const Field<EventFields>> fields_of(EventName name) noexcept;

}  // namespace felt::json
