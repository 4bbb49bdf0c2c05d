#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "felt/tools/gesture_tool.h"
#include "felt/tools/selection_view.h"
#include "felt/tools/transform/moved_strokes.h"
#include "felt/tools/transform/transform_drag.h"
#include "felt/tools/transform/transform_frame.h"
#include "felt/tools/transform/transform_options.h"

namespace felt {

/// Moves, turns, scales and stretches what is selected, held back by the lines that tie it to the
/// rest (paper, "Transformations", eq. 10; transform.md; R33-R38). Always from the state at the
/// touch: going back undoes it, whatever the rate of samples.
///
/// A gesture is one of
///   - a transform, one edit: "Move", "Rotate", "Scale", "Stretch", or "Duplicate";
///   - the centre of turning and scaling being dragged; a click on it puts it back: no edit;
///   - a click beside the frame: another selection, or none.
class TransformTool final : public GestureTool {
 public:
  /// A touch that never comes farther than this from where it began is a click.
  static constexpr double kClickMm = 0.3;
  /// Tethers that are drawn at most.
  static constexpr std::size_t kMostTethers = 64;

  TransformTool();

  [[nodiscard]] ForceModel force(const Scene& scene) const override;
  void draw(Overlay& overlay) const override;

 protected:
  ToolResult hover(const PenSample& sample, const Scene& scene) override;
  ToolResult begin(const PenSample& sample, const Scene& scene) override;
  ToolResult move(const PenSample& sample, const Scene& scene) override;
  ToolResult end(const Scene& scene) override;
  void drop() override;
  void take_options(const OptionValues& options) override;

 private:
  enum class Doing : std::uint8_t { kNothing, kTransform, kCentre, kElsewhere };

  /// Where a touch at a place takes hold of the frame.
  [[nodiscard]] TransformFrame::Grip grip_at(Point p) const;
  void look_at_stroke(Point p, const Scene& scene);
  void follow_selection();
  void take_hold(TransformKind kind, const Scene& scene, const Selection& selection,
                 std::uint32_t buttons);
  void hold_stroke(const Scene& scene, std::uint32_t buttons);
  [[nodiscard]] ToolResult end_transform();
  [[nodiscard]] ToolResult end_elsewhere(const Scene& scene) const;
  [[nodiscard]] double width_factor() const;
  void draw_gesture(Overlay& overlay) const;
  void draw_tethers(Overlay& overlay) const;

  TransformSettings settings_;
  SelectionView selected_;
  std::optional<Point> centre_;               // dragged there
  std::uint64_t centre_is_for_ = 0;           // fingerprint of the selection that it belongs to
  std::optional<std::uint64_t> moved_marks_;  // these lie elsewhere by this tool's doing
  TransformFrame frame_;

  Point pen_;
  StrokeId under_pen_id_;
  StrokePtr under_pen_;  // what a touch would take

  // Of the gesture.
  Doing doing_ = Doing::kNothing;
  std::uint32_t gesture_ = 0;
  Point grab_;
  double farthest_mm_ = 0.0;
  std::optional<Point> old_centre_;
  std::optional<Selection> taken_;  // at the touch: a stroke with nothing selected before
  bool duplicates_ = false;
  MovedStrokes strokes_;
  TransformDrag drag_;
};

std::unique_ptr<Tool> make_transform();

}  // namespace felt
