#pragma once

#include "felt/document/document.h"
#include "felt/document/drawing_guide.h"
#include "felt/document/selection.h"

namespace felt {

/// The strokes of a symmetry group stay mirror images of each other. Changes an edit so that it
/// changes the partners of each stroke that it changes by the mirrored result: the partners get the
/// mirrored shape, width, colour and medium, are divided like the stroke, and are removed with it.
///
/// If the edit changes several strokes of a group, the one that changes most decides, and the
/// others follow it. If it moves, turns, scales or flips all of them together, the axes of the
/// group follow instead. A partner on a hidden or locked layer does not change and leaves the
/// group. If an edit joins two strokes, their partners are joined in the same way if both have the
/// same axes and images; otherwise the groups of both strokes end, and the partners stay as they
/// are.
void let_images_follow(const Document& document, Edit& edit);

/// Adds the mirror images of the strokes that an edit of a drawing tool adds or draws on, each
/// above its original, and links them as symmetry groups. Images that coincide with another one are
/// left out, and so are those of a stroke with an image far outside of any page. Requires a guide
/// of the kind kSymmetry. `document` is the document before the edit, which let_images_follow() has
/// completed: the strokes that it added are in groups and get no images.
void add_images(const Document& document, const DrawingGuide& symmetry, Edit& edit);

/// Returns an edit that ends the symmetry groups of the strokes that are wholly selected.
Edit unlink_edit(const Document& document, const Selection& selection);

/// Returns the mirror image of a stroke. `map` must keep distances. Null if the image breaks an
/// invariant of strokes, for example because it is too far away.
StrokePtr mirrored(const Stroke& stroke, const Affine& map);

}  // namespace felt
