#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/session/event.h"

namespace felt {

/// Returns true if tools and the user may change the layer, that is, if it is visible and not
/// locked.
inline bool is_open(const Layer& layer) noexcept {
  return layer.visible && !layer.locked;
}

/// Returns the highest open layer, which becomes the current one if the current one is closed; an
/// empty id if no layer is open.
LayerId highest_open_layer(const Document& document) noexcept;

/// Returns the edit with these layers hidden, before and after it. `hidden` is ascending.
Edit with_layers_hidden(Edit edit, std::span<const LayerId> hidden);

/// Returns the whole effect of a layer event on a document as one edit, which is one undo step. The
/// edit is empty if nothing changes; for kUse it is always empty. If no layer would remain, or with
/// `keeps_one_open` no open layer, the edit also adds one on top.
///
/// If the event is for a group, the edit is that of group_edit().
///
/// Fails if the layer does not exist; if the event is kUse and the layer is not open; if a value is
/// out of range or a name longer than kMaxLayerNameBytes; if the event changes a picture and the
/// layer has none, or is locked; or if layers cannot be merged: both must be open, in the same
/// group and have the same opacity and blend mode, and the upper one must have no picture. The
/// message names the layer and the reason. Also fails if check_layer_count() refuses the edit.
Result<Edit> layer_edit(const Document& document, const LayerEvent& event, LayerId in_use,
                        bool keeps_one_open = false);

/// Returns an edit that adds a layer with a picture below the layer `in_use`, or on top if
/// that layer is hidden or locked. Fails if the event has no data, an opacity that is not
/// in 0..1, or a place that is_picture_place() refuses, or if check_layer_count() refuses the edit.
Result<Edit> picture_edit(const Document& document, const AddPicture& event, LayerId in_use);

/// Returns the layer that the event makes the current one; an empty id if it leaves the current
/// layer. `document` is the document before `edit`, which layer_edit() has returned for the event.
LayerId used_after(const Document& document, const LayerEvent& event, const Edit& edit);

/// Fails if the edit adds layers and the drawing would have more than kMaxLayers, because it could
/// not be saved.
Result<void> check_layer_count(const Document& document, const Edit& edit);

/// Returns the name of an event in the undo menu.
std::string label_of(LayerEvent::Do what);

/// The ids of the copies of strokes.
using CopiedStrokes = std::map<StrokeId, StrokeId>;

/// Returns the ids that add_copy() gives to the strokes of these layers, if it is called for each
/// of them in this order. Fails if check_copies() refuses the copies.
Result<CopiedStrokes> copied_strokes(const Document& document, std::span<const Layer> layers);

/// Adds a copy of a layer with all its strokes and fills to `edit`, at the position `index` and
/// with this state. The pieces of the copied fills and the pairs of the timing name the copies of
/// the strokes, also of strokes in other layers that are copied. Requires that the edit contains
/// only such copies, and that `copies` are the copied_strokes() of all of them.
void add_copy(const Document& document, const Layer& layer, LayerState state, std::size_t index,
              const CopiedStrokes& copies, Edit& edit);

/// Returns the name of a copy of a layer or group, of at most kMaxLayerNameBytes.
std::string copied_name(std::string_view name);

/// Returns an edit that adds an open layer on top.
Edit add_layer_on_top(const Document& document);

}  // namespace felt
