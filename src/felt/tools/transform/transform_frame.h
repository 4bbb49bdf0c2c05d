#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "felt/geometry/rect.h"
#include "felt/tools/overlay.h"
#include "felt/tools/transform/transform_drag.h"

namespace felt {

/// The frame around the selection, and its handles that a touch can grab.
///
///            o          turns
///      x-----x-----x    corners scale; a touch just outside a corner turns; edges stretch one axis
///      x     +     x    inside moves; + is the centre of turning, which can be dragged
///      x-----x-----x
///
/// Corners and edges keep the opposite corner or edge of the ink in place, unless the centre was
/// dragged.
///
/// Edges shorter than 4 kGripMm have no handle, because it would overlap with others.
class TransformFrame {
 public:
  static constexpr double kMarginMm = 3.0;  ///< distance of the frame from the control points
  static constexpr double kGripMm = 3.0;    ///< radius of a handle
  /// Outside the frame, a touch within this distance of a corner turns. The handle for turning is
  /// this far above the frame.
  static constexpr double kTurnMm = 9.0;

  TransformFrame() = default;
  /// Makes the frame of a box. The default centre is that of the box (docs/design/errata.md#e15).
  /// An empty box has no frame.
  explicit TransformFrame(const Rect& box, std::optional<Point> centre = {}) noexcept
      : TransformFrame(box, box, centre) {}
  /// Makes the frame around `ink`. The default centre is that of `box`.
  TransformFrame(const Rect& ink, const Rect& box, std::optional<Point> centre) noexcept;

  [[nodiscard]] bool empty() const noexcept { return frame_.empty(); }
  [[nodiscard]] Point centre() const noexcept { return centre_; }
  [[nodiscard]] std::array<Point, 4> corners() const noexcept;

  enum class Part : std::uint8_t { kNone, kInside, kCentre, kHandle };
  struct Grip {
    Part part = Part::kNone;
    TransformKind kind =
        TransformKind::kMove;  ///< the transform that a touch begins; unused for kNone and kCentre
    Point at;                  ///< position of the handle
    /// For a handle that scales or stretches: the corner of the ink, or the middle of its edge, on
    /// the other side. Nullopt if the user has dragged the centre, which is then the fixed point.
    std::optional<Point> opposite = {};
  };
  /// Returns the part of the frame at a point. If several handles are in reach, returns the
  /// nearest.
  [[nodiscard]] Grip grip_at(Point p) const noexcept;
  /// Returns true if the point is on the dot of the centre.
  [[nodiscard]] bool is_centre(Point p) const noexcept;

  /// Draws the frame and its handles.
  void draw(Overlay& overlay) const;

 private:
  struct Handle {
    Point at;
    TransformKind kind = TransformKind::kScale;
  };
  struct Handles {
    std::array<Handle, 9> all;
    std::size_t count = 0;
  };

  [[nodiscard]] Handles handles() const noexcept;
  [[nodiscard]] std::optional<Point> opposite(const Handle& handle) const noexcept;

  Rect frame_;
  Point centre_;
  bool has_centre_ = false;  // was dragged by the user
};

}  // namespace felt
