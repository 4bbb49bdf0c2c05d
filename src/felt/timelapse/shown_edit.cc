#include "felt/timelapse/shown_edit.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "felt/session/session_medium.h"
#include "felt/tools/overlay.h"

namespace felt {
namespace {

using InkSegments = std::span<const Overlay::InkSegment>;

/// Returns wet ink as one stroke. Fails if the segments break an invariant of strokes; then the ink
/// has only just begun, or is a jump.
Result<Stroke> wet_stroke(InkSegments segments, const std::string& medium, Rgba color) {
  StrokeData data;
  data.medium = medium;
  data.color = color;
  data.points.push_back(segments.front().curve.p[0]);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Overlay::InkSegment& s = segments[i];
    data.points.insert(data.points.end(), s.curve.p.begin() + 1, s.curve.p.end());
    if (i > 0) data.joints.push_back(JointKind::kCorner);
    if (i == 0) {
      data.widths.push_back({0.0, std::max(s.start_width_mm, kMinWidthMm), s.start_tone});
    }
    data.widths.push_back(
        {static_cast<double>(i + 1), std::max(s.end_width_mm, kMinWidthMm), s.end_tone});
  }
  return Stroke::create(std::move(data));
}

/// Adds the strokes of wet ink: one for each piece that is connected. Segments that are too short
/// for a stroke (kMinSegmentMm) are left out; the next sample makes them longer.
void add_wet_strokes(std::vector<Overlay::InkSegment> segments, const std::string& medium,
                     Rgba color, std::vector<StrokePtr>& strokes) {
  std::erase_if(segments, [&](const Overlay::InkSegment& s) {
    return !wet_stroke(InkSegments(&s, 1), medium, color);
  });
  std::size_t first = 0;
  for (std::size_t i = 1; i <= segments.size(); ++i) {
    const bool ends = i == segments.size() || segments[i].curve.p[0] != segments[i - 1].curve.p[3];
    if (!ends) continue;
    const InkSegments piece(segments.data() + first, i - first);
    first = i;
    if (Result<Stroke> whole = wet_stroke(piece, medium, color)) {
      strokes.push_back(std::make_shared<const Stroke>(*std::move(whole)));
      continue;
    }
    for (const Overlay::InkSegment& s : piece) {
      strokes.push_back(
          std::make_shared<const Stroke>(*wet_stroke(InkSegments(&s, 1), medium, color)));
    }
  }
}

/// Returns an id of a stroke that neither the document has nor the edit adds.
std::uint64_t unused_id(const Document& document, const Edit& edit) {
  std::uint64_t id = document.new_id().value;
  for (const StrokeChange& c : edit.changes) id = std::max(id, c.id.value + 1);
  for (const FillChange& c : edit.fills) id = std::max(id, c.id.value + 1);
  return id;
}

/// Returns the number of strokes in a layer after the edit; nullopt if the layer is not there then.
std::optional<std::size_t> size_after(const Document& document, const Edit& edit, LayerId id) {
  const Layer* layer = document.layer(id);
  if (layer == nullptr) return std::nullopt;
  for (const LayerChange& c : edit.layers) {
    if (c.id == id && !c.after) return std::nullopt;
  }
  std::size_t size = layer->strokes.size();
  for (const StrokeChange& c : edit.changes) {
    if (c.after && c.after_place.layer == id) ++size;
    if (c.before && c.before_place.layer == id) --size;
  }
  return size;
}

}  // namespace

std::optional<Edit> shown_edit(const Session& session) {
  if (!session.gesture_in_progress()) return std::nullopt;
  Edit edit;
  if (session.preview()) edit = *session.preview_with_fills();
  Overlay overlay;
  session.draw(overlay);
  if (!overlay.ink.empty()) {
    const std::string& medium = medium_in_hand(session).id;
    std::vector<StrokePtr> strokes;
    add_wet_strokes(overlay.ink, medium, overlay.ink_color, strokes);
    for (const Affine& image : overlay.ink_images) {
      std::vector<Overlay::InkSegment> mirrored;
      for (const Overlay::InkSegment& s : overlay.ink) mirrored.push_back(mapped(s, image));
      add_wet_strokes(std::move(mirrored), medium, overlay.ink_color, strokes);
    }
    std::uint64_t id = unused_id(session.document(), edit);
    std::optional<std::size_t> index = size_after(session.document(), edit, session.layer());
    for (StrokePtr& stroke : strokes) {
      if (!index) break;
      edit.changes.push_back(
          {StrokeId{id++}, nullptr, std::move(stroke), {}, {session.layer(), (*index)++}});
    }
  }
  if (edit.empty()) return std::nullopt;
  return with_exported_pictures(session.seen_edit(std::move(edit)));
}

Edit with_exported_pictures(Edit edit) {
  for (LayerChange& change : edit.layers) {
    for (std::optional<LayerState>* state : {&change.before, &change.after}) {
      if (*state && (*state)->picture && !(*state)->picture->exported) (*state)->picture = nullptr;
    }
  }
  return edit;
}

}  // namespace felt
