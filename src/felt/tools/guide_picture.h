#pragma once

#include <memory>
#include <span>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/drawing_guide.h"
#include "felt/geometry/rect.h"
#include "felt/tools/overlay.h"

namespace felt {

/// Adds the lines and ticks of guides to an overlay. Lines without an end are cut at the edges of
/// `page`; grids cover the page. A ruler and a set square have a tick every millimetre, and the
/// body of a ruler is on the side of the angle + 90 degrees; a protractor has a tick every degree.
/// Traces show the strokes of `document`. At most kMaxGuideLines lines are drawn for each guide, so
/// that a fine grid on a large page stays drawable: every second, fifth or tenth line is shown.
inline constexpr int kMaxGuideLines = 600;
void add_guide_picture(Overlay& overlay, const DrawingGuide& guide, const Document& document,
                       const Rect& page);

/// Adds all guides of a document that are shown. If `preview` is not null, as they are after it.
void add_guide_pictures(Overlay& overlay, const Document& document, const Edit* preview,
                        const Rect& page);

/// Returns the part of the page that a guide needs to be recognised: a shape of limited size as a
/// whole, and the surroundings of the origin or of the vanishing points of others.
Rect guide_extent(const DrawingGuide& guide) noexcept;

/// Sets Overlay::ink_images to the mirror images at a guide of the kind kSymmetry.
void add_ink_images(Overlay& overlay, const DrawingGuide& symmetry);

}  // namespace felt
