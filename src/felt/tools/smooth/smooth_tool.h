#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "felt/document/edit_builder.h"
#include "felt/tools/connected_pull.h"
#include "felt/tools/gesture_tool.h"
#include "felt/tools/smooth/ironing.h"
#include "felt/tools/smooth/smooth_options.h"
#include "felt/tools/stroke_hold.h"

namespace felt {

/// Irons the jitter out of a line under the pen without shrinking it (smooth.md). The more the user
/// rubs, the more it irons. A gesture acts on the first line that is within 8 mm of the pen. Lines
/// that share a point with the ironed line follow it (R33).
class SmoothTool final : public GestureTool {
 public:
  static constexpr double kLongestStepS = 0.050;
  /// Factor of the dose. If the pen rests at pressure p and the option `amount` is 1, the dose per
  /// second is kDoseRate (0.2 + 1.6 p).
  static constexpr double kDoseRate = 6.0;
  static constexpr double kMousePressure = 0.5;
  /// Minimum time between two updates of the roughness that the user feels, and between two
  /// previews. The time between previews is also at least kPreviewNsPerPoint per control point of
  /// the line.
  static constexpr std::int64_t kPreviewNs = 12'000'000;
  static constexpr std::int64_t kPreviewNsPerPoint = 10'000;

  SmoothTool();

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
  ToolResult take(const PenSample& sample, const Scene& scene);
  [[nodiscard]] Edit edit(Stroke ironed, const Scene& scene);
  void iron(const PenSample& sample, const Scene& scene, bool is_near);
  void feel(double seconds);
  void stop();

  SmoothSettings settings_;
  StrokeHold hold_;
  // State of the gesture:
  std::optional<StrokeReplacement> replacement_;
  std::optional<Ironing> ironing_;
  std::optional<ConnectedPull> connected_;
  double rate_ = 0.0;  // dose per second at the last sample
  std::int64_t last_ns_ = 0;
  std::int64_t preview_ns_ = 0;
  std::int64_t force_ns_ = 0;
  std::int64_t preview_interval_ns_ = kPreviewNs;
  bool has_changed_ = false;
  bool is_caught_up_ = false;  // the next sample makes the preview
  double rough_mm_ = 0.0;      // felt roughness, low-passed
};

std::unique_ptr<Tool> make_smooth();

}  // namespace felt
