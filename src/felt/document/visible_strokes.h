#pragma once

#include <string>
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

/// Returns the bounds of the ink and fills in these layers; empty if they contain none.
Rect ink_bounds(const Document& document, LayerChoice layers = LayerChoice::kVisible);

/// Returns the name of a stroke in files, for example "s12".
std::string stroke_name(StrokeId id);
/// Returns the name of a fill in files, for example "f12".
std::string fill_name(FillId id);

}  // namespace felt
