#pragma once

#include <optional>
#include <span>

#include "felt/document/edit.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/offer.h"
#include "felt/tools/scene.h"

namespace felt {

/// Which gestures of a finished line are recognised.
struct GestureOptions {
  bool scratch_out = false;
  bool double_loop = false;
  bool shapes = false;  ///< ShapeHold

  [[nodiscard]] bool any() const noexcept { return scratch_out || double_loop || shapes; }
};

/// Returns what a finished line means besides ink: it crosses strokes out, or it goes around
/// strokes twice. Only editable strokes count (visible, unlocked layers). The last choice is the
/// ink: `ink` is the edit that adds it, and it applies. Returns nullopt if the line is only ink.
/// `path` is the path of the line.
std::optional<Offer> line_meanings(std::span<const Point> path, const Edit& ink,
                                   const GestureOptions& options, const Scene& scene);

}  // namespace felt
