#pragma once

#include <cstddef>

#include "felt/base/result.h"
#include "felt/document/document.h"

namespace felt {

/// Copies stop when a drawing has this many strokes and fills, or control points in them:
/// each copy of everything doubles a drawing, so a short script would fill any memory.
inline constexpr std::size_t kMaxCopiedObjects = 1'000'000, kMaxCopiedPoints = 20'000'000;

/// The strokes and fills of a drawing, or of a part of it.
struct InkSize {
  std::size_t objects = 0;
  std::size_t points = 0;  ///< control points

  void add(const Stroke& stroke) noexcept;
  void add(const Fill& fill) noexcept;
  /// Adds all strokes and fills of a layer.
  void add(const Document& document, const Layer& layer);
};

/// Fails with kLimitExceeded if the drawing would be too large with copies of this size.
Result<void> check_copies(const Document& document, InkSize copies);

}  // namespace felt
