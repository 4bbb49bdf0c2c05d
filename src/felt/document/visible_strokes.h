#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "felt/document/document.h"
#include "felt/geometry/rect.h"

namespace felt {

/// The layers of a document to include.
enum class LayerChoice { kAll, kVisible };

/// Returns the strokes of visible layers in drawing order. The strokes are shared, not copied.
std::vector<StrokePtr> visible_strokes(const Document& document);

/// Returns the picture of a layer if an exported file shows it, otherwise null.
const LayerPicture* exported_picture(const Layer& layer, PictureChoice pictures) noexcept;
/// Strokes with their fills, apart from a document. The pieces of the fills name strokes by their
/// numbers, from 1, in `strokes`.
struct VisibleInk {
  std::vector<StrokePtr> strokes;
  std::vector<FillPtr> fills;
};

/// Returns the strokes and fills of visible layers in drawing order. A loop of a fill that also has
/// a piece of another stroke keeps its points, but has no pieces.
VisibleInk visible_ink(const Document& document);

/// Returns a fill whose pieces name other strokes. A loop with a piece of a stroke that is not in
/// the table has no pieces; `is_complete` is false then.
struct RenamedFill {
  Fill fill;
  bool is_complete = true;
};
RenamedFill with_other_strokes(Fill fill, const std::map<StrokeId, StrokeId>& new_ids);

/// Returns true if the boundary of the fill has pieces of strokes, and `is_chosen` is true for each
/// of these strokes. Such a fill is copied, duplicated and exported together with the chosen
/// strokes.
bool goes_with_strokes(const Fill& fill, const std::function<bool(StrokeId)>& is_chosen);

/// Returns the bounds of the ink and fills in these layers; empty if they contain none.
Rect ink_bounds(const Document& document, LayerChoice layers = LayerChoice::kVisible);

/// Returns the name of a stroke in files, for example "s12".
std::string stroke_name(StrokeId id);
/// Returns the name of a fill in files, for example "f12".
std::string fill_name(FillId id);
/// Returns the id of a stroke or fill with such a name, or zero if it is another name or 2^40 or
/// more. That is far below the largest id that a file can hold (2^53), so that the ids of new
/// strokes, which are larger, can still be saved.
StrokeId stroke_id_of_name(std::string_view name) noexcept;
FillId fill_id_of_name(std::string_view name) noexcept;

}  // namespace felt
