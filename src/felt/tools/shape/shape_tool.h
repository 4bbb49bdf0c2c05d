#pragma once

#include <memory>
#include <optional>

#include "felt/tools/gesture_tool.h"
#include "felt/tools/shape/shape_ink.h"
#include "felt/tools/shape/shape_options.h"

namespace felt {

/// Draws a line, a rectangle or an ellipse from corner to corner (shape.md). One gesture is one
/// edit, "Shape". The first modifier makes the shape regular; the second one makes the first point
/// the centre.
class ShapeTool final : public GestureTool {
 public:
  ShapeTool();

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
  ShapeSettings settings_;
  // The state of the gesture:
  Point touch_;
  std::optional<Stroke> shape_;
};

std::unique_ptr<Tool> make_shape();

}  // namespace felt
