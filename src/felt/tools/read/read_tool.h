#pragma once

#include <map>
#include <memory>
#include <optional>

#include "felt/tools/gesture_tool.h"
#include "felt/tools/read/read_options.h"
#include "felt/tools/read/read_track.h"
#include "felt/tools/reading.h"

namespace felt {

/// Reads a drawing without eyes (read.md): lines attract the pen while it touches, ends and
/// crossings click, and reading() says what is under the pen. Changes nothing.
class ReadTool final : public GestureTool {
 public:
  ReadTool();

  [[nodiscard]] ForceModel force(const Scene& scene) const override;
  void draw(Overlay& overlay) const override;
  [[nodiscard]] const Reading* reading() const override { return &reading_; }

 protected:
  ToolResult hover(const PenSample& sample, const Scene& scene) override;
  ToolResult begin(const PenSample& sample, const Scene& scene) override;
  ToolResult move(const PenSample& sample, const Scene& scene) override;
  ToolResult end(const Scene& scene) override;
  void drop() override;
  void stop_hovering() override;
  void take_options(const OptionValues& options) override;

 private:
  /// The outline of a fill, so that it is computed only once.
  struct FillShape {
    FillPtr fill;
    Outline outline;
  };

  void read(Point pen, const Scene& scene);
  void report(const Reading& now);
  [[nodiscard]] FillId fill_at(Point pen, const Scene& scene);
  [[nodiscard]] bool is_in(const FillId& id, const FillPtr& fill, Point pen);
  void stop();

  ReadSettings settings_;
  Reading reading_;
  std::optional<Point> pen_;
  ReadTrack track_;
  std::optional<Point> filled_at_;  // the pen at the last search for fills
  FillId filled_{};
  std::map<FillId, FillShape> shapes_;
};

std::unique_ptr<Tool> make_read();

}  // namespace felt
