#include "felt/session/layer_edit.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "felt/base/utf8.h"
#include "felt/document/copy_limit.h"
#include "felt/document/edit_builder.h"
#include "felt/session/group_edit.h"

namespace felt {
namespace {

using Do = LayerEvent::Do;

std::string title_of(const Layer& layer) {
  return "layer " + std::to_string(layer.id.value) + " (" + layer.name + ")";
}

tl::unexpected<Error> bad_opacity() {
  return fail(ErrorCode::kInvalidArgument, "opacity: is not a number from 0 to 1");
}

LayerChange new_layer(const Document& document, std::string name, std::size_t index) {
  const LayerId id = document.new_layer_id();
  if (name.empty()) name = "Layer " + std::to_string(id.value);
  return {id, std::nullopt, LayerState{std::move(name)}, 0, index};
}

/// A position for a new layer, and its group.
struct Beside {
  std::size_t index = 0;
  LayerGroupPtr group;
};

/// Returns the position below or above the current layer, in its group. If the current layer is
/// closed, returns the position on top, for two reasons: in a closed group, the new layer would be
/// closed, too; and files do not keep which one of several closed layers is the current one.
Beside beside(const Document& document, LayerId in_use, std::size_t above) {
  const std::size_t top = document.layers().size();
  const Layer* layer = document.layer(in_use);
  if (!layer || !is_open(*layer)) return {top, nullptr};
  return {std::min(document.layer_index(in_use) + above, top), layer->group};
}

/// Completes an edit of layers: if no layer would remain, or if `open` is true no open layer, the
/// edit also adds one on top.
void keep_one(const Document& document, bool open, Edit& edit) {
  if (edit.layers.empty()) return;
  const auto stays = [open](const LayerState& state) {
    return !open || (is_visible(state) && !is_locked(state));
  };
  std::set<LayerId> changed;
  std::size_t count = document.layers().size();
  for (const LayerChange& c : edit.layers) {
    if (c.after && stays(*c.after)) return;
    changed.insert(c.id);
    if (!c.before) ++count;
    if (!c.after) --count;
  }
  const std::span<const Layer> layers = document.layers();
  const bool other_stays = std::any_of(layers.begin(), layers.end(), [&](const Layer& l) {
    return !changed.contains(l.id) && (!open || is_open(l));
  });
  if (!other_stays) edit.layers.push_back(new_layer(document, {}, count));
}

/// Returns the state of the layer after the event. Position and removal are not part of this state.
LayerState changed(LayerState state, const LayerEvent& event) {
  if (event.what == Do::kRename) state.name = event.name;
  if (event.what == Do::kShow || event.what == Do::kHide) {
    state.visible = event.what == Do::kShow;
  }
  if (event.what == Do::kLock || event.what == Do::kUnlock) {
    state.locked = event.what == Do::kLock;
  }
  if (event.what == Do::kOpacity) state.opacity = event.opacity;
  if (event.what == Do::kBlend) state.blend = event.mode;
  if (event.what == Do::kPlace) state.picture = placed(*state.picture, event.place);
  if (event.what == Do::kExport || event.what == Do::kLeaveOut) {
    LayerPicture picture = *state.picture;
    picture.exported = event.what == Do::kExport;
    state.picture = std::make_shared<const LayerPicture>(std::move(picture));
  }
  return state;
}

Edit change_of(const Document& document, const Layer& layer, const LayerEvent& event) {
  const std::size_t index = document.layer_index(layer.id);
  LayerChange change{layer.id, layer.state(), changed(layer.state(), event), index, index};
  if (change.after == change.before) return {};
  return {label_of(event.what), {}, {std::move(change)}};
}

Edit removal_of(const Document& document, const Layer& layer) {
  EditBuilder builder(document);
  for (const StrokeId id : layer.strokes) builder.remove(id);
  for (const FillId id : layer.fills) builder.remove_fill(id);
  Edit edit = std::move(builder).build(label_of(Do::kRemove));
  edit.layers.push_back({layer.id, layer.state(), {}, document.layer_index(layer.id), 0});
  return edit;
}

/// Returns the timing of a copy of a layer: its pairs name the copies of the strokes. The pairs of
/// a stroke that is not copied go away; a partner that is not copied stays.
KeyTimingPtr copied_timing(const KeyTimingPtr& timing, const CopiedStrokes& copies) {
  if (!timing || timing->pairs.empty()) return timing;
  KeyTiming copy = *timing;
  std::erase_if(copy.pairs,
                [&](const KeyPair& pair) { return pair.from && !copies.contains(pair.from); });
  for (KeyPair& pair : copy.pairs) {
    if (pair.from) pair.from = copies.at(pair.from);
    if (const auto to = copies.find(pair.to); to != copies.end()) pair.to = to->second;
  }
  return shared_timing(std::move(copy));
}

/// Returns the timing of `below` with the pairs of both layers, as long as no stroke is in two
/// pairs; those of `below` come first.
KeyTimingPtr merged_timing(const Layer& below, const Layer& layer) {
  if (!layer.timing || layer.timing->pairs.empty()) return below.timing;
  KeyTiming merged = timing_or_default(below.timing);
  std::set<StrokeId> from, to;
  for (const KeyPair& pair : merged.pairs) {
    from.insert(pair.from);
    to.insert(pair.to);
  }
  for (const KeyPair& pair : layer.timing->pairs) {
    const bool is_taken =
        (pair.from && from.contains(pair.from)) || (pair.to && to.contains(pair.to));
    if (!is_taken && merged.pairs.size() < KeyTiming::kMaxPairs) merged.pairs.push_back(pair);
  }
  return shared_timing(std::move(merged));
}

/// Returns an edit that adds a copy of the layer with all its strokes and fills above it.
Result<Edit> copy_of(const Document& document, const Layer& layer) {
  const Result<CopiedStrokes> copies = copied_strokes(document, {&layer, 1});
  if (!copies) return tl::unexpected(copies.error());
  LayerState state = layer.state();
  state.name = copied_name(state.name);
  Edit edit{label_of(Do::kDuplicate), {}, {}};
  add_copy(document, layer, std::move(state), document.layer_index(layer.id) + 1, *copies, edit);
  return edit;
}

Edit merge_of(const Document& document, const Layer& layer) {
  const std::size_t index = document.layer_index(layer.id);
  const Layer& below = document.layers()[index - 1];
  Edit edit{label_of(Do::kMerge), {}, {}};
  edit.layers.push_back({layer.id, layer.state(), std::nullopt, index, 0});
  LayerState merged = below.state();
  merged.timing = merged_timing(below, layer);
  if (merged != below.state()) {
    edit.layers.push_back({below.id, below.state(), std::move(merged), index - 1, index - 1});
  }
  edit.changes.reserve(layer.strokes.size());
  for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
    const StrokePtr stroke = document.find(layer.strokes[i]);
    edit.changes.push_back(
        {layer.strokes[i], stroke, stroke, {layer.id, i}, {below.id, below.strokes.size() + i}});
  }
  for (std::size_t i = 0; i < layer.fills.size(); ++i) {
    const FillPtr fill = document.find_fill(layer.fills[i]);
    edit.fills.push_back(
        {layer.fills[i], fill, fill, {layer.id, i}, {below.id, below.fills.size() + i}});
  }
  return edit;
}

tl::unexpected<Error> no_layer(LayerId id) {
  return fail(ErrorCode::kNotFound, "no layer " + std::to_string(id.value));
}

tl::unexpected<Error> refusal(const Layer& layer, const std::string& why) {
  return fail(ErrorCode::kInvalidArgument, title_of(layer) + ' ' + why);
}

Result<void> check_merge(const Document& document, const Layer& layer) {
  const std::size_t index = document.layer_index(layer.id);
  if (index == 0) return refusal(layer, "is the lowest: there is no layer to merge it with");
  const Layer& below = document.layers()[index - 1];
  for (const Layer* part : {&layer, &below}) {
    if (is_open(*part)) continue;
    return refusal(
        *part, part->visible ? "is locked and cannot be merged" : "is hidden and cannot be merged");
  }
  if (layer.picture) return refusal(layer, "has a picture and cannot be merged");
  if (!equal_groups(layer.group, below.group)) {
    return refusal(layer, "and " + title_of(below) + " are not in the same group");
  }
  if (layer.opacity != below.opacity) {
    return refusal(layer, "and " + title_of(below) +
                              " differ in opacity: make it equal before you merge them");
  }
  if (layer.blend != below.blend) {
    return refusal(layer, "and " + title_of(below) +
                              " differ in blend mode: make it equal before you merge them");
  }
  return {};
}

/// Files hold no longer names, so that the drawing could not be saved.
Result<void> check_name(const std::string& name) {
  if (name.size() <= kMaxLayerNameBytes) return {};
  return fail(ErrorCode::kInvalidArgument, "name: is longer than 4096 bytes");
}

/// Returns an error if the event cannot be applied to the layer.
Result<void> check_event(const Document& document, const Layer& layer, const LayerEvent& event) {
  switch (event.what) {
    case Do::kUse:
      if (is_open(layer)) return {};
      return refusal(layer, std::string(layer.visible ? "is locked" : "is hidden") +
                                ": you cannot draw on it");
    case Do::kOpacity:
      if (event.opacity >= 0.0 && event.opacity <= 1.0) return {};
      return bad_opacity();
    case Do::kMerge:
      return check_merge(document, layer);
    case Do::kPlace:
      if (layer.locked) return refusal(layer, "is locked: its picture cannot be moved");
      if (!is_picture_place(event.place)) {
        return fail(ErrorCode::kInvalidArgument, "matrix: a picture cannot be placed like this");
      }
      break;
    case Do::kExport:
    case Do::kLeaveOut:
      break;
    default:
      return {};
  }
  return layer.picture ? Result<void>() : refusal(layer, "has no picture");
}

}  // namespace

std::string label_of(Do what) {
  switch (what) {
    case Do::kAdd:
      return "Add layer";
    case Do::kRemove:
      return "Remove layer";
    case Do::kRename:
      return "Rename layer";
    case Do::kShow:
      return "Show layer";
    case Do::kHide:
      return "Hide layer";
    case Do::kLock:
      return "Lock layer";
    case Do::kUnlock:
      return "Unlock layer";
    case Do::kRaise:
      return "Raise layer";
    case Do::kLower:
      return "Lower layer";
    case Do::kMove:
      return "Move layer";
    case Do::kOpacity:
      return "Layer opacity";
    case Do::kDuplicate:
      return "Duplicate layer";
    case Do::kMerge:
      return "Merge layers";
    case Do::kPlace:
      return "Place picture";
    case Do::kExport:
    case Do::kLeaveOut:
      return "Export picture";
    case Do::kBlend:
      return "Layer blend mode";
    case Do::kGroup:
      return "Group layers";
    case Do::kUngroup:
      return "Ungroup layers";
    case Do::kUse:
      break;
  }
  return "Use layer";
}

Result<CopiedStrokes> copied_strokes(const Document& document, std::span<const Layer> layers) {
  InkSize size;
  for (const Layer& layer : layers) size.add(document, layer);
  if (Result<void> fits = check_copies(document, size); !fits) {
    return tl::unexpected(fits.error());
  }
  CopiedStrokes copies;
  std::size_t made = 0;
  for (const Layer& layer : layers) {
    for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
      copies.emplace(layer.strokes[i], document.new_id(made + i));
    }
    made += layer.strokes.size() + layer.fills.size();
  }
  return copies;
}

void add_copy(const Document& document, const Layer& layer, LayerState state, std::size_t index,
              const CopiedStrokes& copies, Edit& edit) {
  const LayerId id = document.new_layer_id(edit.layers.size());
  const std::size_t made = edit.changes.size() + edit.fills.size();
  state.timing = copied_timing(state.timing, copies);
  edit.layers.push_back({id, std::nullopt, std::move(state), 0, index});
  for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
    const StrokeId stroke = layer.strokes[i];
    edit.changes.push_back({copies.at(stroke), nullptr, document.find(stroke), {}, {id, i}});
  }
  for (std::size_t i = 0; i < layer.fills.size(); ++i) {
    Fill fill = *document.find_fill(layer.fills[i]);
    for (FillLoop& loop : fill.loops) {
      for (FillPiece& piece : loop.pieces) {
        const auto copy = copies.find(piece.stroke);
        if (copy != copies.end()) piece.stroke = copy->second;
      }
    }
    const FillId copy = document.new_fill_id(made + layer.strokes.size() + i);
    edit.fills.push_back(
        {copy, nullptr, std::make_shared<const Fill>(std::move(fill)), {}, {id, i}});
  }
}

LayerId highest_open_layer(const Document& document) noexcept {
  const std::span<const Layer> layers = document.layers();
  const auto open = std::find_if(layers.rbegin(), layers.rend(), is_open);
  return open == layers.rend() ? LayerId{} : open->id;
}

Edit with_layers_hidden(Edit edit, std::span<const LayerId> hidden) {
  for (LayerChange& c : edit.layers) {
    if (!std::binary_search(hidden.begin(), hidden.end(), c.id)) continue;
    if (c.before) c.before->visible = false;
    if (c.after) c.after->visible = false;
  }
  return edit;
}

std::string copied_name(std::string_view name) {
  constexpr std::string_view kEnd = " copy";
  return std::string(utf8_prefix(name, kMaxLayerNameBytes - kEnd.size())).append(kEnd);
}

Result<void> check_layer_count(const Document& document, const Edit& edit) {
  std::size_t count = document.layers().size();
  for (const LayerChange& c : edit.layers) {
    if (!c.before) ++count;
    if (!c.after) --count;
  }
  if (count <= std::max(kMaxLayers, document.layers().size())) return {};
  return fail(ErrorCode::kLimitExceeded,
              "a drawing has at most " + std::to_string(kMaxLayers) + " layers");
}

namespace {

Result<Edit> unchecked_layer_edit(const Document& document, const LayerEvent& event,
                                  LayerId in_use) {
  if (auto ok = check_name(event.name); !ok) return tl::unexpected(ok.error());
  if (event.what == Do::kAdd) {
    const Beside place = beside(document, in_use, 1);
    Edit edit{label_of(event.what), {}, {new_layer(document, event.name, place.index)}};
    LayerState& added = *edit.layers.front().after;
    added.group = place.group;
    if (!event.timing_of) return edit;
    const Layer* key = document.layer(event.timing_of);
    if (!key) return no_layer(event.timing_of);
    KeyTiming timing = timing_or_default(key->timing);
    timing.pairs.clear();
    added.timing = shared_timing(std::move(timing));
    return edit;
  }
  const bool is_of_group = event.what == Do::kGroup || event.what == Do::kUngroup;
  if (is_of_group || (!event.layer && event.group)) return group_edit(document, event);
  const Layer* layer = document.layer(event.layer);
  if (!layer) return no_layer(event.layer);
  if (auto ok = check_event(document, *layer, event); !ok) return tl::unexpected(ok.error());
  if (event.what == Do::kUse) return Edit{};
  if (event.what == Do::kDuplicate) return copy_of(document, *layer);
  if (event.what == Do::kMerge) return merge_of(document, *layer);
  const bool moves =
      event.what == Do::kMove || event.what == Do::kRaise || event.what == Do::kLower;
  if (moves) return layer_move(document, event);
  if (event.what == Do::kRemove) return removal_of(document, *layer);
  return change_of(document, *layer, event);
}

}  // namespace

Result<Edit> layer_edit(const Document& document, const LayerEvent& event, LayerId in_use,
                        bool keeps_one_open) {
  Result<Edit> edit = unchecked_layer_edit(document, event, in_use);
  if (!edit) return edit;
  keep_one(document, keeps_one_open, *edit);
  if (Result<void> fits = check_layer_count(document, *edit); !fits) {
    return tl::unexpected(fits.error());
  }
  return edit;
}

Result<Edit> picture_edit(const Document& document, const AddPicture& event, LayerId in_use) {
  if (auto ok = check_name(event.name); !ok) return tl::unexpected(ok.error());
  if (!event.data) return fail(ErrorCode::kInvalidArgument, "picture: has no data");
  if (!is_picture_place(event.place)) {
    return fail(ErrorCode::kInvalidArgument, "matrix: a picture cannot be placed like this");
  }
  if (!(event.opacity >= 0.0 && event.opacity <= 1.0)) return bad_opacity();
  const Beside place = beside(document, in_use, 0);
  LayerChange change = new_layer(document, event.name, place.index);
  change.after->group = place.group;
  change.after->opacity = event.opacity;
  change.after->picture =
      std::make_shared<const LayerPicture>(LayerPicture{event.data, event.place});
  Edit edit{"Add picture", {}, {std::move(change)}};
  if (Result<void> fits = check_layer_count(document, edit); !fits) {
    return tl::unexpected(fits.error());
  }
  return edit;
}

LayerId used_after(const Document& document, const LayerEvent& event, const Edit& edit) {
  if (event.what == Do::kUse) return event.layer;
  if (event.what == Do::kAdd) return edit.layers.front().id;
  if (event.what == Do::kDuplicate) return edit.layers.back().id;
  if (event.what != Do::kMerge) return {};
  return document.layers()[document.layer_index(event.layer) - 1].id;
}

Edit add_layer_on_top(const Document& document) {
  return {label_of(Do::kAdd), {}, {new_layer(document, {}, document.layers().size())}};
}

}  // namespace felt
