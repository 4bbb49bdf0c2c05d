#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "felt/tools/connected_pull.h"
#include "felt/tools/gesture_tool.h"
#include "felt/tools/moved_strokes.h"
#include "felt/tools/selection_view.h"
#include "felt/tools/transform/transform_drag.h"
#include "felt/tools/transform/transform_frame.h"
#include "felt/tools/transform/transform_options.h"

namespace felt {

/// Moves, turns, scales and stretches the selection. Lines that connect it to other strokes stay
/// attached and resist (paper, "Transformations", eq. 10; transform.md; R33-R38). The result is
/// always computed from the state at the touch, so moving back undoes it and the sample rate has no
/// effect.
///
/// A gesture is one of
///   - a transform, one edit: "Move", "Rotate", "Scale", "Stretch", or "Duplicate";
///   - a drag of the centre of turning and scaling, or a click on the centre, which resets it;
///     neither makes an edit;
///   - a click outside the frame, which selects another stroke, or nothing.
/// If nothing is selected and the current layer has a picture, the frame is around the picture, and
/// a transform that does not begin on a stroke changes the place of the picture.
class TransformTool final : public GestureTool {
 public:
  /// A touch that stays within this distance of its start is a click.
  static constexpr double kClickMm = 0.3;
  /// Maximum number of tethers drawn.
  static constexpr std::size_t kMaxTethers = 64;

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
  enum class Doing : std::uint8_t { kNothing, kTransform, kPicture, kCentre, kElsewhere };

  /// Returns the part of the frame that a touch at a point would grab.
  [[nodiscard]] TransformFrame::Grip grip_at(Point p) const;
  void look_at_stroke(Point p, const Scene& scene);
  void follow_selection(const Scene& scene);
  void begin_with_picture(const TransformFrame::Grip& grip, const Scene& scene,
                          std::uint32_t buttons);
  [[nodiscard]] std::optional<Edit> picture_edit(const Scene& scene) const;
  void take_hold(TransformKind kind, const Scene& scene, const Selection& selection,
                 std::uint32_t buttons);
  void hold_stroke(const Scene& scene, std::uint32_t buttons);
  [[nodiscard]] ToolResult end_transform(const Scene& scene);
  [[nodiscard]] ToolResult end_elsewhere(const Scene& scene) const;
  [[nodiscard]] double width_factor() const;
  void draw_gesture(Overlay& overlay) const;
  void draw_tethers(Overlay& overlay) const;

  TransformSettings settings_;
  SelectionView selected_;
  std::optional<Point> centre_;      // set if it was dragged
  std::uint64_t centre_is_for_ = 0;  // fingerprint of the selection that centre_ belongs to
  std::optional<std::uint64_t>
      moved_marks_;  // marks_fingerprint of points that this tool has moved
  TransformFrame frame_;

  LayerPicturePtr picture_;  // the picture in the frame; null if the frame is of the selection
  Point pen_;
  StrokeId under_pen_id_;
  StrokePtr under_pen_;  // the stroke that a touch would grab

  // State of the gesture.
  Doing doing_ = Doing::kNothing;
  std::uint32_t gesture_ = 0;
  Point grab_;
  double farthest_mm_ = 0.0;
  std::optional<Point> old_centre_;
  std::optional<Selection> taken_;  // stroke selected by the touch, if nothing was selected
  bool duplicates_ = false;
  MovedStrokes strokes_;
  std::optional<ConnectedPull> connected_;  // set if strokes_ may leave gaps
  std::int64_t completed_ns_ = 0;           // time of the last preview whose gaps were closed
  double completion_ns_ = 0.0;              // minimum time until the next one
  TransformDrag drag_;
};

std::unique_ptr<Tool> make_transform();

}  // namespace felt
