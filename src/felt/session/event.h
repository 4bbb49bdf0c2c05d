#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "felt/geometry/rect.h"
#include "felt/haptics/capabilities.h"
#include "felt/haptics/pen_sample.h"
#include "felt/session/document_events.h"
#include "felt/tools/guide_line.h"
#include "felt/tools/offer.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// Chooses a tool. {"event":"tool","id":"pencil"}
struct SelectTool {
  std::string id;
  friend bool operator==(const SelectTool&, const SelectTool&) = default;
};

/// Sets an option of a tool, an option of the surface ("surface.material"), or the colour of new
/// ink ("ink.color").
/// {"event":"option","id":"pencil.snap","value":"both"}
struct SetOption {
  std::string id;
  OptionValue value;
  friend bool operator==(const SetOption&, const SetOption&) = default;
};

/// A pen sample as read. {"event":"pen","x":..,"y":..,"z":..,"pressure":..,"buttons":0,"tilt":32.5}
/// The text form has no velocity; the player computes it as a device would.
struct PenEvent {
  Vec3 position;
  std::optional<double> pressure;
  std::uint32_t buttons = 0;
  std::optional<double> tilt_deg{};  ///< tilt of the pen from the normal, 0..90; absent if unknown
  friend bool operator==(const PenEvent&, const PenEvent&) = default;
};

/// Converts an event of the pen to a sample with velocity 0.
inline PenSample sample_of(std::int64_t time_ns, const PenEvent& pen) {
  return {time_ns, pen.position, {}, pen.pressure, pen.buttons, pen.tilt_deg};
}

/// Sets the position that the simulated hand wants for the pen; forces displace the pen from it.
/// Only the player handles it, because it owns the device; a session refuses it.
/// {"event":"hand","x":..,"y":..,"z":..}
struct HandEvent {
  Vec3 target;
  std::optional<double> pressure;
  std::uint32_t buttons = 0;
  std::optional<double> tilt_deg{};
  friend bool operator==(const HandEvent&, const HandEvent&) = default;
};

struct UndoEvent {
  friend bool operator==(const UndoEvent&, const UndoEvent&) = default;
};
struct RedoEvent {
  friend bool operator==(const RedoEvent&, const RedoEvent&) = default;
};
struct CancelEvent {
  friend bool operator==(const CancelEvent&, const CancelEvent&) = default;
};

/// Replaces the line that the steady hand has just drawn by the line of the unchanged pen samples,
/// as one undo step. Does nothing if the last change of the document was another one.
/// {"event":"as-drawn"}
struct AsDrawnEvent {
  friend bool operator==(const AsDrawnEvent&, const AsDrawnEvent&) = default;
};

/// Adds the strokes of a file. {"event":"import","path":".."} The code that reads the script also
/// reads this file, and passes its strokes to Session::import().
struct ImportEvent {
  std::string path;
  /// If true, selects the added strokes; if false, the selection does not change.
  bool select = false;
  friend bool operator==(const ImportEvent&, const ImportEvent&) = default;
};

/// Selects whole strokes of visible, unlocked layers. {"event":"select","what":"all"}
struct SelectStrokes {
  enum class What : std::uint8_t {
    kAll,
    kNone,
    kInvert,  ///< deselects the strokes that are wholly selected and selects all others
  };
  What what = What::kAll;
  friend bool operator==(const SelectStrokes&, const SelectStrokes&) = default;
};

/// Deletes the strokes that are wholly selected. Strokes that are selected in part do not change.
/// {"event":"delete"}
struct DeleteEvent {
  friend bool operator==(const DeleteEvent&, const DeleteEvent&) = default;
};
/// Copies the strokes that are wholly selected, and selects the copies. Each copy is slightly
/// shifted and goes to the top of the layer of its original. {"event":"duplicate"}
struct DuplicateEvent {
  friend bool operator==(const DuplicateEvent&, const DuplicateEvent&) = default;
};

/// Moves the strokes that are wholly selected. Lines that share a point with them follow at that
/// point, as in a drag of the transform tool; other strokes that are selected in part stay. If
/// the previous change of the document was a move of the same strokes at most kTogetherNs earlier,
/// both are one undo step. {"event":"move","dx":1,"dy":-0.1}
struct MoveEvent {
  static constexpr std::int64_t kTogetherNs = 1'000'000'000;
  static constexpr double kMaxMm = 10'000.0;

  Vec by_mm;  ///< each coordinate is -kMaxMm..kMaxMm
  friend bool operator==(const MoveEvent&, const MoveEvent&) = default;
};
/// Moves the strokes that are wholly selected above or below all other strokes of their layers.
/// Their own order does not change. {"event":"order","to":"front"}
struct OrderEvent {
  enum class To : std::uint8_t { kFront, kBack };
  To to = To::kFront;
  friend bool operator==(const OrderEvent&, const OrderEvent&) = default;
};

/// Changes the colour, the opacity, the medium or the width of all strokes that are selected wholly
/// or in part, as one undo step. Their curves do not change.
/// {"event":"restyle","color":"#b02020","medium":"chalk","opacity":0.5,"width":1.25}
struct RestyleEvent {
  static constexpr double kMinWidthFactor = 0.01, kMaxWidthFactor = 100.0;

  std::string color = {};              ///< in the form of "ink.color"; "" does not change it
  std::string medium = {};             ///< id of a known medium that draws; "" does not change it
  std::optional<double> opacity = {};  ///< 0..1; applied after the colour
  /// Factor on the widths, kMinWidthFactor..kMaxWidthFactor.
  std::optional<double> width_factor = {};
  friend bool operator==(const RestyleEvent&, const RestyleEvent&) = default;
};

/// The version of the tools' default options. A recording contains this version, because a
/// recording leaves out options that have their default. old_defaults.h lists those of
/// earlier versions.
inline constexpr int kOptionDefaults = 9;
/// Before this version, a layer event that left no open layer added one. Since then, the first ink
/// adds it.
inline constexpr int kLateLayerDefaults = 5;
/// Before this version, a line of full width could need a push of 2 N (Capabilities::full_push_n),
/// and the width of felt lines was fitted less exactly (Scene::felt_width_tolerance_mm).
inline constexpr int kFirmPushDefaults = 7;
inline constexpr double kOldFullPushN = 2.0, kOldFeltWidthToleranceMm = 0.15;

/// Sets the device that samples come from and forces go to. Applies to all later events.
/// {"event":"device","max_force_n":3.3,...} A gesture in progress is committed as if the pen had
/// been lifted. The event is meant for recordings that are passed directly to a session. The Player
/// refuses it, because the Player has a device already. The text form has no workspace, because
/// tools do not use the workspace.
struct UseDevice {
  Capabilities capabilities;
  /// The version of the defaults in the program that made the recording. If this version differs
  /// from that of the session, options that still have their default are set to the defaults of
  /// this version.
  int defaults = kOptionDefaults;
  friend bool operator==(const UseDevice&, const UseDevice&) = default;
};

/// Adds a surface or medium, or replaces the material with the same id. If that material is in use,
/// the change takes effect immediately. {"event":"material","text":"kind = \"surface\"..."} The
/// text defines the material completely (docs/formats/material.md).
struct UseMaterial {
  std::string text;
  friend bool operator==(const UseMaterial&, const UseMaterial&) = default;
};

/// Guides the pen of the pencil along a path, instead of along the previous one. A guide of the
/// kind "none" removes the guide. Forces change, but the ink depends only on the pen samples.
/// {"event":"guide","kind":"groove","points":[[x,y],...],"closed":true,"strength":1}
struct UseGuide {
  GuideLine line;
  friend bool operator==(const UseGuide&, const UseGuide&) = default;
};

/// Chooses what the last stroke means, or the stroke in progress (Offer). Has no effect if this is
/// not offered. {"event":"choose","what":"delete"}
struct ChooseOffer {
  OfferKind what = OfferKind::kInk;
  friend bool operator==(const ChooseOffer&, const ChooseOffer&) = default;
};

/// Chooses the edges that are felt: as soft ridges those of the page and of the box around the
/// selection, and as soft grooves the contours of pictures (find_contours). At first none is.
/// Forces change, but the ink depends only on the pen samples.
/// {"event":"edges","page":[0,0,210,297],"selection":true,"contours":[[[10,20],[30,20]]]}
struct UseEdges {
  static constexpr std::size_t kMaxContours = 1'000, kMaxContourPoints = 20'000;

  Rect page = {};  ///< x0, y0, x1, y1 in mm; an empty one is not felt
  bool selection = false;
  /// Polylines on the page, mm. The last point of a closed one is its first.
  std::vector<std::vector<Point>> contours = {};
  friend bool operator==(const UseEdges&, const UseEdges&) = default;
};

/// Opens a menu around the pen (ChoiceRing), or closes it. While it is open, the pen feels its
/// wells instead of the tool's force, and neither draws nor edits. What is chosen is another event,
/// of a tool or an option. Has no effect during a gesture.
/// {"event":"ring","points":[[60,70],[60,54],[76,70]]}
struct UseRing {
  bool is_open = false;
  Point middle = {};  ///< the others matter only if it is open
  Point top = {};     ///< the well at the top
  Point right = {};   ///< the well on the right
  friend bool operator==(const UseRing&, const UseRing&) = default;
};

/// Replaces the last stroke by the exact line or arc of the guide of the drawing that it kept to,
/// as one undo step. Does nothing if no exact curve is offered (Session::exact_offer).
/// {"event":"exact"}
struct ExactEvent {
  friend bool operator==(const ExactEvent&, const ExactEvent&) = default;
};

/// An event of a drawing session. Events are the only input of a session
/// (docs/design/loop.md#determinism). Times never run backwards.
struct Event {
  std::int64_t time_ns = 0;
  std::variant<SelectTool, SetOption, PenEvent, HandEvent, UndoEvent, RedoEvent, CancelEvent,
               AsDrawnEvent, ImportEvent, SelectStrokes, DeleteEvent, DuplicateEvent, MoveEvent,
               OrderEvent, RestyleEvent, LayerEvent, AddPicture, UseDevice, UseMaterial, UseGuide,
               ChooseOffer, GuidesEvent, ExactEvent, UseEdges, UseRing, TimingEvent, BodyEvent,
               UseView, AddLine>
      what;
  friend bool operator==(const Event&, const Event&) = default;
};

}  // namespace felt
