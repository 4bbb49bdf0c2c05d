#pragma once

#include <cstdint>
#include <memory>

#include "felt/tools/gesture_tool.h"
#include "felt/tools/lasso/lasso_options.h"
#include "felt/tools/lasso/lasso_outline.h"
#include "felt/tools/lasso/lasso_preview.h"
#include "felt/tools/selection_view.h"

namespace felt {

/// Selects control points or whole strokes by a line or a rectangle drawn around them, or one whole
/// stroke by a click (paper, "Transformations": the lasso selects control points, not pixels;
/// lasso.md; R31, R32). A gesture results in a selection, not in an edit or undo step.
class LassoTool final : public GestureTool {
 public:
  /// A touch is a click if its path stays within a square of this size and encloses less than
  /// kMinAreaMm2.
  static constexpr double kClickMm = 3.0;
  static constexpr double kMinAreaMm2 = 1.0;

  LassoTool();

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
  [[nodiscard]] std::vector<Point> outline() const;
  [[nodiscard]] Selection click(const Scene& scene) const;

  LassoSettings settings_;
  LassoCombine combine_ = LassoCombine::kReplace;  // for this gesture
  LassoOutline way_;
  Point start_, pen_;
  LassoPreview preview_;
  SelectionView selected_;
  StrokePtr under_pen_;  // the stroke that a click would select
};

std::unique_ptr<Tool> make_lasso();

}  // namespace felt
