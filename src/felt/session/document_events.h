#pragma once

/// The events that change layers, guides and edits of the body of a drawing, or what of it is in
/// view. The other events are in event.h.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/document/body_edit.h"
#include "felt/document/drawing_guide.h"
#include "felt/document/edit.h"
#include "felt/geometry/point.h"

namespace felt {

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
  Affine place = {};     ///< LayerPicture::place
  double opacity = 1.0;  ///< of the layer, 0..1
  friend bool operator==(const AddPicture& a, const AddPicture& b) {
    return a.name == b.name && a.place == b.place && a.opacity == b.opacity &&
           (a.data == b.data || (a.data && b.data && *a.data == *b.data));
  }
};

/// Adds a line of ink in the medium and colour of new ink: straight pieces with corners between
/// them, of one width. A trial of a study begins with such lines.
/// {"event":"line","points":[[20,30],[80,30]],"closed":true,"width_mm":0.8}
struct AddLine {
  static constexpr std::size_t kMaxPoints = 20'000;
  static constexpr double kMaxWidthMm = 50.0;

  /// In mm, 2 to kMaxPoints. Points closer than 0.1 mm to the one before are left out.
  std::vector<Point> points = {};
  bool is_closed = false;  ///< the last point is joined to the first, which may be repeated
  double width_mm = 1.0;   ///< kMinWidthMm..kMaxWidthMm
  friend bool operator==(const AddLine&, const AddLine&) = default;
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

}  // namespace felt
