#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "felt/document/body_edit.h"
#include "felt/document/drawing_guide.h"
#include "felt/document/edit.h"
#include "felt/geometry/rect.h"
#include "felt/haptics/capabilities.h"
#include "felt/haptics/pen_sample.h"
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

/// Moves the strokes that are wholly selected. Strokes that are selected in part do not change. If
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

/// Changes a layer or a group of layers. {"event":"layer","do":"hide","id":2},
/// {"event":"layer","do":"add","name":"Ideas"}, {"event":"layer","do":"lock","group":1}
struct LayerEvent {
  enum class Do : std::uint8_t {
    kAdd,     ///< adds a layer above the current one and uses it; an empty `name` gives "Layer N"
    kRemove,  ///< removes the layer with its strokes
    kRename,
    kShow,
    kHide,
    kLock,
    kUnlock,
    kRaise,  ///< one position up; no effect at the top
    kLower,  ///< one position down; no effect at the bottom
    kUse,    ///< makes it the current layer for new ink; not an undo step
    kMove,   ///< to position `index`
    kOpacity,
    kDuplicate,  ///< adds a copy with all strokes above the layer and uses it
    kMerge,      ///< moves the strokes on top of the layer below and removes the layer
    kPlace,      ///< sets the place of the layer's picture
    kExport,     ///< exported files show the layer's picture
    kLeaveOut,   ///< exported files do not show the layer's picture
    kBlend,      ///< sets how the layer is combined with what is below it
    kGroup,      ///< puts `layers` into a new group, at the position of the highest of them
    kUngroup,    ///< dissolves the group; its layers stay as they look
  };
  Do what = Do::kAdd;
  LayerId layer;          ///< unused for kAdd
  std::string name = {};  ///< for kAdd and kRename
  std::size_t index = 0;  ///< for kMove: 0 is the lowest; greater values are clamped to the highest
  double opacity = 1.0;   ///< for kOpacity: 0..1
  Affine place = {};      ///< for kPlace: LayerPicture::place
  BlendMode mode = BlendMode::kNormal;  ///< for kBlend
  /// With a zero `layer`, the event is for this group: kUngroup, kRemove, kRename, kShow, kHide,
  /// kLock, kUnlock, kRaise, kLower, kMove, kOpacity, kDuplicate and kBlend. For kMove of a layer,
  /// this is its group after the move, zero for none; if it is not set, the position decides.
  std::optional<GroupId> group = {};
  std::vector<LayerId> layers = {};  ///< for kGroup
  /// For kAdd: the new layer gets the timing of this layer, without its pairs. Zero: a new timing.
  LayerId timing_of = {};
  friend bool operator==(const LayerEvent&, const LayerEvent&) = default;
};

/// Adds a layer with a picture below the current layer and uses it.
/// {"event":"picture","name":"Photo","png":"iVBORw0K...","matrix":[a,b,c,d,e,f]}
struct AddPicture {
  std::string name = {};  ///< name of the layer; empty gives "Layer N"
  std::shared_ptr<const PictureData> data = {};
  Affine place = {};  ///< LayerPicture::place
  friend bool operator==(const AddPicture& a, const AddPicture& b) {
    return a.name == b.name && a.place == b.place &&
           (a.data == b.data || (a.data && b.data && *a.data == *b.data));
  }
};

/// The version of the tools' default options. A recording contains this version, because a
/// recording leaves out options that have their default. old_defaults.h lists those of
/// earlier versions.
inline constexpr int kOptionDefaults = 3;

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

/// Adds, changes or removes guides of the drawing, shows or hides all of them, or unlinks mirrored
/// strokes. Each is one undo step. (UseGuide is another kind of guide: the path of a study, which
/// is not part of the drawing.)
/// {"event":"guides","do":"add","kind":"ruler","x":20,"y":30,"angle_rad":0.5,"size_mm":100}
struct GuidesEvent {
  enum class Do : std::uint8_t {
    kAdd,     ///< adds `guide`, and shows the guides if they were hidden
    kChange,  ///< replaces the guide `id` by `guide`
    kRemove,  ///< removes the guide `id`
    kClear,   ///< removes all guides
    kShow,
    kHide,    ///< hidden guides do not act on the pen
    kUnlink,  ///< ends the symmetry of the strokes that are wholly selected
  };
  Do what = Do::kAdd;
  GuideId id{};
  DrawingGuide guide{};
  friend bool operator==(const GuidesEvent&, const GuidesEvent&) = default;
};

/// Chooses the edges that are felt as soft ridges: those of the page, and those of the box around
/// the selection. At first neither is. Forces change, but the ink depends only on the pen samples.
/// {"event":"edges","page":[0,0,210,297],"selection":true}
struct UseEdges {
  Rect page = {};  ///< x0, y0, x1, y1 in mm; an empty one is not felt
  bool selection = false;
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

/// Sets how a film shows the key drawings of layers (KeyTiming). What is absent stays as it is. One
/// undo step for all layers. If the previous change of the document was a timing event of the same
/// layers at most kTogetherNs earlier, and neither has pairs, both are one undo step.
/// {"event":"timing","ids":[2,3],"between":8,"hold":2,
/// "ease":[0.42,0,1,1],"pairs":[[3,5],[4,0]]}
struct TimingEvent {
  static constexpr std::int64_t kTogetherNs = 1'000'000'000;

  std::vector<LayerId> layers = {};  ///< at least one
  std::optional<int> between = {};
  std::optional<int> hold = {};
  std::optional<EaseCurve> ease = {};
  std::optional<std::vector<KeyPair>> pairs = {};  ///< replaces all pairs
  friend bool operator==(const TimingEvent&, const TimingEvent&) = default;
};

/// Adds or removes edits of the body of the drawing. Each is one undo step.
/// {"event":"body","do":"add","kind":"cut","path":[[20,-10,0],[60,-80,0]],"view":[0,0,-1]}
struct BodyEvent {
  enum class Do : std::uint8_t {
    kAdd,     ///< adds `edit` after all others
    kRemove,  ///< removes the edit `id`
    kClear,   ///< removes all edits
  };
  Do what = Do::kAdd;
  BodyEditId id{};
  BodyEdit edit{};
  friend bool operator==(const BodyEvent&, const BodyEvent&) = default;
};

/// From now on, hides these layers from the view of the session, instead of the previous ones:
/// tools treat them as hidden, and windows do not show them. The document does not change, so this
/// is not an undo step. The current layer stays in view. {"event":"view","hidden":[1,3]}
struct UseView {
  std::vector<LayerId> hidden = {};  ///< layers that do not exist are ignored
  friend bool operator==(const UseView&, const UseView&) = default;
};

/// An event of a drawing session. Events are the only input of a session
/// (docs/design/loop.md#determinism). Times never run backwards.
struct Event {
  std::int64_t time_ns = 0;
  std::variant<SelectTool, SetOption, PenEvent, HandEvent, UndoEvent, RedoEvent, CancelEvent,
               AsDrawnEvent, ImportEvent, SelectStrokes, DeleteEvent, DuplicateEvent, MoveEvent,
               OrderEvent, RestyleEvent, LayerEvent, AddPicture, UseDevice, UseMaterial, UseGuide,
               ChooseOffer, GuidesEvent, ExactEvent, UseEdges, UseRing, TimingEvent, BodyEvent,
               UseView>
      what;
  friend bool operator==(const Event&, const Event&) = default;
};

}  // namespace felt
