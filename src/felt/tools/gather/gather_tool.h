#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "felt/tools/gather/brushed_bundle.h"
#include "felt/tools/gather/gather_options.h"
#include "felt/tools/gesture_tool.h"

namespace felt {

/// Presses a bundle of rough strokes into one line (gather.md). The user brushes along the strokes;
/// the preview shows the line. One gesture is one edit, "Gather".
class GatherTool final : public GestureTool {
 public:
  /// Minimum time between two previews, and for each point of the strokes under the brush.
  static constexpr std::int64_t kPreviewNs = 30'000'000;
  static constexpr std::int64_t kPreviewNsPerPoint = 10'000;
  /// Minimum time between two updates of the spread that the user feels.
  static constexpr std::int64_t kFeelNs = 12'000'000;

  GatherTool();

  [[nodiscard]] ForceModel force(const Scene& scene) const override;
  void draw(Overlay& overlay) const override;

 protected:
  ToolResult hover(const PenSample& sample, const Scene& scene) override;
  ToolResult begin(const PenSample& sample, const Scene& scene) override;
  ToolResult move(const PenSample& sample, const Scene& scene) override;
  ToolResult end(const Scene& scene) override;
  void drop() override;
  void stop_hovering() override;
  void take_options(const OptionValues& options) override;

 private:
  ToolResult preview(const PenSample& sample, const Scene& scene);
  void feel(const PenSample& sample);
  void stop();

  GatherSettings settings_;
  std::optional<Point> pen_;
  // The state of the gesture:
  std::optional<BrushPath> brush_;
  BrushedBundle bundle_;
  bool has_changed_ = false;  // since the last preview
  std::int64_t preview_ns_ = 0;
  std::int64_t preview_interval_ns_ = kPreviewNs;
  std::int64_t feel_ns_ = 0;
  double spread_mm_ = 0.0;  // felt spread, low-passed
};

std::unique_ptr<Tool> make_gather();

}  // namespace felt
