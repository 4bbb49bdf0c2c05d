#pragma once

#include <optional>

#include "felt/document/document.h"
#include "felt/document/edit.h"
#include "felt/document/stroke_index.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/stroke_guide.h"

namespace felt {

/// A stroke that kept to a guide, and the exact curve that can replace it.
struct ExactOffer {
  StrokeId id;
  StrokePtr drawn;  ///< as it is in the document; the offer is void if it has changed
  StrokePtr exact;
};

/// Points near which the exact curve is to start and end, instead of near the ends of the drawn
/// stroke.
struct ExactEnds {
  std::optional<Point> start = std::nullopt, end = std::nullopt;
};

/// Returns the line or the arc of a circle or ellipse that a drawn stroke kept to: from the
/// position of its start to that of its end, with the widths, medium and colour of the drawn
/// stroke. A closed stroke becomes the whole ellipse. Arcs consist of cubics of at most 30 degrees;
/// their largest error is 4e-7 of the radius, because the error of a cubic arc is proportional to
/// the sixth power of its angle, and 2.7e-4 for 90 degrees (Goldapp, Computer Aided Geometric
/// Design 8, 1991, DOI 10.1016/0167-8396(91)90007-X). Returns nullopt if the result would be
/// shorter than kMinExactMm, or not a stroke.
std::optional<Stroke> exact_stroke(const Stroke& drawn, const ExactPath& path,
                                   const ExactEnds& ends = {});
inline constexpr double kMinExactMm = 1.0;

/// Returns an offer for a stroke of the document. If an end of the stroke lies on another line, the
/// exact curve ends where the shape crosses that line. Returns nullopt if exact_stroke() does, or
/// if a connection would open (exact_edit).
std::optional<ExactOffer> offer_exact_ink(const Document& document, const StrokeIndex& index,
                                          StrokeId id, const ExactPath& path);

/// Returns the edit "Make exact", which replaces the stroke of an offer. Ends of other lines that
/// lie on the stroke move with it, so that they stay connected (junctions.h). Returns an empty edit
/// if a connection would open, for example because the other line is in a locked layer.
Edit exact_edit(const Document& document, const StrokeIndex& index, const ExactOffer& offer);

/// Shows an exact curve that is offered: its middle line and its ends.
void draw_exact(const Stroke& exact, Overlay& overlay);

}  // namespace felt
