#pragma once

#include <memory>
#include <optional>

#include "felt/stroke/arc_map.h"
#include "felt/tools/connected_pull.h"
#include "felt/tools/gesture_tool.h"
#include "felt/tools/pull/pull_gesture.h"
#include "felt/tools/pull/pull_options.h"

namespace felt {

/// Corrects lines by pulling and pushing them (paper, "local modifications"; pull.md). A touch
/// within the grab radius of a line grabs the line. In the mode `push`, the nib pushes every line
/// that it meets; `bulge` and `pinch` move all lines around the touch. Each mode has its own
/// PullGesture.
class PullTool final : public GestureTool {
 public:
  PullTool();

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
  /// The line that a touch would grab.
  struct Target {
    StrokePtr stroke;
    ArcMap map;  // of *stroke
    double u = 0.0;
    Point point;
    bool is_free = false;

    explicit Target(StrokePtr s) : stroke(std::move(s)), map(*stroke, 1e-3) {}
  };

  [[nodiscard]] bool reaches_by_size() const noexcept;
  [[nodiscard]] BrushOptions brush_for(const PenSample& sample) const;
  void draw_target(Overlay& overlay) const;

  PullSettings settings_;
  Point pen_;  // position while hovering
  bool hovers_ = false;
  std::unique_ptr<Target> target_;  // reused for the same stroke, because a new map takes time
  bool has_target_ = false;
  std::unique_ptr<PullGesture> gesture_;
  std::optional<ConnectedPull> connected_;  // not of bulges and pushes, which join lines themselves
};

std::unique_ptr<Tool> make_pull();

}  // namespace felt
