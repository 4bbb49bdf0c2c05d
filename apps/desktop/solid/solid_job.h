#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/document/body_edit.h"
#include "felt/document/document.h"
#include "felt/render/grain.h"
#include "felt/solid/front_paint.h"
#include "felt/solid/outlines.h"
#include "felt/solid/solid.h"

namespace felt::desktop {

/// How the solid view makes bodies of a drawing.
struct SolidRequest {
  /// Gaps up to this size are closed, 0..32 mm. If not set, automatic_gap_mm() is used.
  std::optional<double> gap_mm;
  HoleChoice holes = HoleChoice::kFill;
  Grain grain{};  ///< the look of the ink that is painted on the bodies
  /// An edit of the body that the user has drawn, and that is not part of the drawing yet.
  std::optional<BodyEdit> new_edit;
};

/// The bodies of a drawing, and sentences about what is missing.
struct SolidAnswer {
  std::shared_ptr<const Solid> solid;       ///< null if there is no body
  std::shared_ptr<const FrontPaint> paint;  ///< the ink on the bodies; null if there is none
  bool is_open = false;                     ///< there is no body, because no line is closed
  double gap_mm = 0.0;                      ///< the gap that was used
  /// A wider gap that would enclose clearly more, or anything if there is no body.
  std::optional<double> wider_gap_mm;
  /// The library's sentences: what was left out or, if there is no body, why.
  std::vector<std::string> notes;
  /// Why the new edit does not fit the bodies; not set if it does, or if there was none.
  std::optional<std::string> new_edit_refusal;
};

/// Makes the bodies of a drawing, with its edits of the body. Outlines that cannot become bodies
/// are left out, with a note; so are edits that do not fit. Takes milliseconds for a sketch, but up
/// to 20 s for 10,000 strokes that all cross. If `is_cancelled` becomes true, the next step is not
/// begun, and the answer has no body. Safe to call from any thread.
SolidAnswer make_solid(const Document& document, const SolidRequest& request,
                       const std::atomic<bool>& is_cancelled);

}  // namespace felt::desktop
