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

/// Changes the width of lines and never their shape (paper, "Change curve width"; specification 5h,
/// R46; width.md): by a brush, by drawing along a line again, or of whole lines at once.
///
/// One gesture acts on the line that the pen first comes within 8 mm of, and in the mode `scale`,
/// when that one is selected, on all selected lines.
class WidthTool final : public GestureTool {
 public:
  /// Dragging up by this much doubles the width.
  static constexpr double kDoublingMm = 20.0;
  /// Longer steps of time do not count: a clock that jumped is no reason to change ink.
  static constexpr double kLongestStepS = 0.050;
  /// Nearer to a limit than this the stop is felt.
  static constexpr double kStopMm = 1.0;
  /// Previews are at least this far apart, and by kPreviewNsPerPoint for each control point:
  /// an eye sees no more, and a long line is not copied a thousand times a second.
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
  // Of the gesture:
  Edit edit_;  // the lines in work, the one held first, with what is shown of them
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
