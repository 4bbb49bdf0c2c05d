#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "felt/document/edit_builder.h"
#include "felt/tools/gesture_tool.h"
#include "felt/tools/stroke_hold.h"
#include "felt/tools/width/width_brush.h"
#include "felt/tools/width/width_force.h"
#include "felt/tools/width/width_options.h"
#include "felt/tools/width/width_retrace.h"

namespace felt {

/// Changes the width of lines but never their shape (paper, "Change curve width";
/// docs/design/editing.md#width-brush, R46; width.md): with a brush, by drawing along a line again,
/// or for whole lines.
///
/// A gesture acts on the first line that is within 8 mm of the pen. In the mode `scale`, if that
/// line is selected, the gesture acts on all selected lines.
class WidthTool final : public GestureTool {
 public:
  /// Length of an upward drag that doubles the width.
  static constexpr double kDoublingMm = 20.0;
  /// Maximum time step, s. Longer ones are clamped, so that a clock that jumps does not change ink.
  static constexpr double kLongestStepS = 0.050;
  /// The user feels the stop if the width is within this distance of a limit.
  static constexpr double kStopMm = 1.0;
  /// Minimum time between two previews. This time is also at least kPreviewNsPerPoint per control
  /// point. More previews would not be visible, and a long line should not be copied a thousand
  /// times a second.
  static constexpr std::int64_t kPreviewNs = 4'000'000;
  static constexpr std::int64_t kPreviewNsPerPoint = 2'000;

  WidthTool();

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
  [[nodiscard]] bool is_working() const noexcept { return !edit_.changes.empty(); }
  ToolResult take(const PenSample& sample, const Scene& scene);
  void find_lines(const Scene& scene);
  void apply(const PenSample& sample, const Scene& scene, bool is_near);
  void brush(double seconds, double rate);
  void retrace(const PenSample& sample, const Scene& scene);
  [[nodiscard]] double brush_rate(double pressure) const noexcept;
  void update_stops(double seconds);
  void update_edit();
  static void set_widths(StrokeChange& change, std::vector<WidthKnot> widths);
  [[nodiscard]] double width_here() const;
  void draw_reach(Overlay& overlay, const Stroke& shown) const;
  void stop();

  WidthSettings settings_;
  StrokeHold hold_;
  Point pen_;
  // State of the gesture:
  Edit edit_;  // the lines being changed, as shown; the line under the pen first
  std::optional<WidthBrush> brush_;
  std::optional<WidthRetrace> retrace_;
  WidthMap width_map_;
  WidthDirection direction_ = WidthDirection::kPressure;
  Point origin_;
  double factor_ = 1.0;
  double touch_u_ = 0.0;
  double rate_mm_per_s_ = 0.0;
  std::int64_t last_ns_ = 0;
  std::int64_t preview_ns_ = 0;
  std::int64_t preview_interval_ns_ = kPreviewNs;
  bool has_changed_ = false;  // since the last preview
  WidthStops stops_;
};

std::unique_ptr<Tool> make_width();

}  // namespace felt
