#pragma once

/// Tools for the tests of this layer, small enough that their results are obvious.

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "felt/document/edit_builder.h"
#include "felt/tools/tool.h"

namespace felt {

/// A soft wall at z = 0 without damping.
struct FakeWall {
  double stiffness_n_per_mm = 0.3;

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
    const double push = stiffness_n_per_mm * depth_mm(sample);
    memory.terms.add("wall", {0, 0, push});
    return {0, 0, push};
  }
  [[nodiscard]] Slopes slopes() const noexcept { return {1000.0 * stiffness_n_per_mm, 0, 0}; }
};

/// Draws one straight segment per sample while the pen touches, so that the document contains every
/// position that the tool received. Shows the line so far as a preview.
class FakePencil : public Tool {
 public:
  static constexpr OptionSpec kOptions[] = {
      {"width_mm", "Width", "mm", OptionKind::kNumber, 0.1, 5.0, 1.0, {}, "Of new lines."},
      {"hard", "Hard", "", OptionKind::kSwitch, 0.0, 1.0, 0.0, {}, "A harder wall."},
  };

  explicit FakePencil(const char* id = "pencil", ToolKind kind = ToolKind::kDraws)
      : info_{id, id, "", 0, kOptions, kind} {}

  [[nodiscard]] const ToolInfo& info() const noexcept override { return info_; }

  ToolResult sample(const PenSample& sample, Contact::Change, const Scene& scene) override {
    const bool touches = in_contact(sample);
    if (!touches) {
      waits_for_lift_ = false;
      // If the pen is just above the surface, this may be a bounce, so the line waits.
      return sample.position.z < 0.5 ? ToolResult{} : finish(scene);
    }
    if (waits_for_lift_) return {};
    const Point at = on_page(sample.position);
    if (points_.empty() || distance(points_.back(), at) > 0.1) points_.push_back(at);
    ToolResult result;
    if (points_.size() > 1) result.preview = edit(scene);
    return result;
  }
  ToolResult finish(const Scene& scene) override {
    ToolResult result;
    if (points_.size() > 1) result.commit = edit(scene);
    points_.clear();
    return result;
  }
  void cancel() override {
    points_.clear();
    waits_for_lift_ = true;
  }
  [[nodiscard]] ForceModel force(const Scene&) const override {
    ForceModel model(FakeWall{options_.is_on(1) ? 0.6 : 0.3});
    model.set_fade_id(options_.is_on(1) ? 2 : 1);
    return model;
  }
  void draw(Overlay& overlay) const override {
    for (const Point& p : points_) overlay.rings.push_back({p, 1.0, Overlay::Role::kGuide});
  }
  Result<void> set_option(std::string_view id, const OptionValue& value) override {
    return options_.set(id, value);
  }
  [[nodiscard]] Result<OptionValue> option(std::string_view id) const override {
    return options_.get(id);
  }

 private:
  [[nodiscard]] Edit edit(const Scene& scene) const {
    StrokeData data;
    data.points.push_back(points_.front());
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const Point a = points_[i - 1], b = points_[i];
      data.points.push_back(lerp(a, b, 1.0 / 3.0));
      data.points.push_back(lerp(a, b, 2.0 / 3.0));
      data.points.push_back(b);
      if (i > 1) data.joints.push_back(JointKind::kCorner);
    }
    const double width_mm = options_.number(0);
    data.widths = {{0.0, width_mm}, {static_cast<double>(points_.size() - 1), width_mm}};
    data.color = scene.color;
    EditBuilder builder(scene.document);
    builder.add(scene.layer, std::make_shared<const Stroke>(*Stroke::create(data)));
    return std::move(builder).build("Draw");
  }

  ToolInfo info_;
  OptionValues options_{kOptions};
  std::vector<Point> points_;
  bool waits_for_lift_ = false;
};

/// Removes the topmost stroke of the current layer at the touch and returns the edit immediately,
/// before the pen is lifted.
class FakeEraser : public FakePencil {
 public:
  FakeEraser() : FakePencil("eraser", ToolKind::kErases) {}

  ToolResult sample(const PenSample& sample, Contact::Change, const Scene& scene) override {
    const bool touches = in_contact(sample);
    if (!touches) waits_ = false;
    const std::vector<StrokeId>& strokes = scene.document.layer(scene.layer)->strokes;
    if (!touches || waits_ || strokes.empty()) return {};
    waits_ = true;
    EditBuilder builder(scene.document);
    builder.remove(strokes.back());
    return {{}, std::move(builder).build("Erase")};
  }
  ToolResult finish(const Scene&) override { return {}; }
  void cancel() override { waits_ = true; }

 private:
  bool waits_ = false;
};

inline std::vector<std::unique_ptr<Tool>> fake_tools() {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(std::make_unique<FakeEraser>());
  tools.push_back(std::make_unique<FakePencil>());
  return tools;
}

}  // namespace felt
