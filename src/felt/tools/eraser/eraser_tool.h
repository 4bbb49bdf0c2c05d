#pragma once

#include <memory>
#include <optional>

#include "felt/tools/eraser/eraser_aim.h"
#include "felt/tools/eraser/eraser_gesture.h"
#include "felt/tools/eraser/eraser_options.h"
#include "felt/tools/eraser/guard_ridge.h"
#include "felt/tools/gesture_tool.h"

namespace felt {

/// Erases the ink that the pen sweeps over, lines up to their next crossings, or whole lines
/// (paper, "eraser"; docs/design/editing.md#eraser; eraser.md). The remains are shown immediately;
/// each gesture is one edit, "Erase". With kFirstModifier at the touch it erases up to the
/// crossings, with kSecondModifier whole lines.
class EraserTool final : public GestureTool {
 public:
  EraserTool();

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
  [[nodiscard]] EraserMode mode_of(const PenSample& sample) const noexcept;
  /// Returns true if the pen is pressed so hard that whole lines are erased.
  [[nodiscard]] bool presses_through(const PenSample& sample, const Scene& scene) const noexcept;
  [[nodiscard]] ToolResult preview(bool changed, const Scene& scene) const;

  EraserSettings settings_;
  std::optional<EraserGesture> erasing_;
  EraserMode mode_ = EraserMode::kTouched;  // of this gesture
  bool erases_whole_ = false;               // the pen was pressed through in this gesture
  std::int64_t touch_ns_ = 0;
  EraserAim aim_;
  GuardRidge guard_;
  std::optional<Point> pen_;  // for the ring
};

std::unique_ptr<Tool> make_eraser();

}  // namespace felt
