#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/document/document.h"
#include "felt/render/grain.h"
#include "felt/solid/front_paint.h"
#include "felt/solid/outlines.h"
#include "felt/solid/solid.h"

namespace felt::desktop {

/// How the solid view makes bodies of a drawing.
struct SolidRequest {
  /// The gaps that are tried if none is given, in mm.
  static constexpr std::array kAutomaticGapsMm{2.0, 4.0, 8.0};

  /// Gaps up to this size are closed, 0..32 mm. If not set, the smallest of kAutomaticGapsMm is
  /// used that encloses at least kEnoughArea of what the best of them encloses.
  std::optional<double> gap_mm;
  HoleChoice holes = HoleChoice::kFill;
  Grain grain{};  ///< the look of the ink that is painted on the bodies

  /// Chosen so that the parts which an open outline leaves closed (the head of the sample cat, 43 %
  /// of its area) do not count as the whole drawing.
  static constexpr double kEnoughArea = 0.8;
  /// In larger drawings, no gap is searched: each search would take seconds.
  static constexpr std::size_t kMaxSearchedStrokes = 2000;
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
};

/// Makes the bodies of a drawing. Outlines that cannot become bodies are left out, with a note.
/// Takes milliseconds for a sketch, but up to 20 s for 10,000 strokes that all cross. If
/// `is_cancelled` becomes true, the next step is not begun, and the answer has no body. Safe to
/// call from any thread.
SolidAnswer make_solid(const Document& document, const SolidRequest& request,
                       const std::atomic<bool>& is_cancelled);

}  // namespace felt::desktop
