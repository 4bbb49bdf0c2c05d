#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "felt/geometry/rect.h"
#include "felt/tools/overlay.h"
#include "felt/tools/transform/transform_drag.h"

namespace felt {

/// The frame round what is selected, and its handles: what a touch takes hold of.
///
///            o          turns
///      x-----x-----x    corners scale, just outside of one turns; edges stretch one axis
///      x     +     x    inside moves; + is the centre of turning and scaling, which can be dragged
///      x-----x-----x
///
/// Handles that would lie on each other are left out: those of edges shorter than 4 kGripMm.
class TransformFrame {
 public:
  static constexpr double kMarginMm = 3.0;  ///< of the frame round the control points
  static constexpr double kGripMm = 3.0;    ///< radius of a handle
  static constexpr double kTurnMm = 9.0;    ///< from a corner, outside, or of the handle above

  TransformFrame() = default;
  /// Without a centre that of the box (E15). An empty box has no frame.
  explicit TransformFrame(const Rect& box, std::optional<Point> centre = {}) noexcept
      : TransformFrame(box, box, centre) {}
  /// The frame around `ink`, with the centre of `box`.
  TransformFrame(const Rect& ink, const Rect& box, std::optional<Point> centre) noexcept;

  [[nodiscard]] bool empty() const noexcept { return frame_.empty(); }
  [[nodiscard]] Point centre() const noexcept { return centre_; }
  [[nodiscard]] std::array<Point, 4> corners() const noexcept;

  enum class Part : std::uint8_t { kNone, kInside, kCentre, kHandle };
  struct Grip {
    Part part = Part::kNone;
    TransformKind kind = TransformKind::kMove;  ///< what it begins, but for kNone and kCentre
    Point at;                                   ///< of the handle
  };
  /// What is at a place; of several the nearest handle.
  [[nodiscard]] Grip grip_at(Point p) const noexcept;
  /// True on the dot of the centre.
  [[nodiscard]] bool is_centre(Point p) const noexcept;

  /// The frame and its handles.
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

  Rect frame_;
  Point centre_;
  bool has_centre_ = false;  // dragged somewhere
};

}  // namespace felt
