#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "felt/tools/gesture_tool.h"
#include "felt/tools/guide/guide_options.h"
#include "felt/tools/guide_choice.h"

namespace felt {

/// Places, moves, turns and removes guides of the drawing (guide.md). One gesture is one edit. The
/// first modifier turns in steps; the second one removes the guide under the pen.
class GuideTool final : public GestureTool {
 public:
  GuideTool();

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
  /// What the pen is on: a guide, and one of its handles or none.
  struct Grip {
    GuideId id;
    DrawingGuidePtr guide;
    std::optional<std::size_t> handle;
  };

  void look(Point pen, const Scene& scene);
  [[nodiscard]] std::optional<Edit> edit_at(Point pen, bool in_steps, const Scene& scene) const;
  [[nodiscard]] std::optional<Edit> added(Point pen, bool in_steps, const Scene& scene) const;

  GuideToolSettings settings_;
  GuideBounds bounds_;
  std::optional<Grip> grip_;    // under the pen; during a gesture, what it took
  std::vector<Point> handles_;  // of all visible guides, while the pen hovers
  // The state of the gesture:
  Point touch_;
  bool removes_ = false;
  std::optional<Edit> edit_;
};

std::unique_ptr<Tool> make_guide();

}  // namespace felt
