#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/history.h"
#include "felt/document/stroke_index.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/tools/tool.h"

namespace felt::testing {

/// Test fixture for tools: a document, a surface and a device. It applies the results of a tool as
/// a session does.
struct Fixture {
  Document document;
  StrokeIndex index;
  Selection selection;
  History history;
  SurfaceMaterial surface = surface_materials().front();
  Capabilities device{.max_force_n = 3.3, .continuous_force_n = 0.0, .max_stiffness_n_per_m = 0.0};
  LayerId layer{1};
  Rgba color{};

  [[nodiscard]] Scene scene() const {
    return {document, index, selection, layer, surface, device, color};
  }

  void apply(const Edit& edit) {
    ASSERT_TRUE(document.apply(edit));
    follow(edit);
    history.record(edit);
  }
  void undo() { follow(history.undo(document).value()); }
  void redo() { follow(history.redo(document).value()); }
  void follow(const Edit& edit) {
    index.update(edit, document);
    selection.follow(edit);
  }

  /// Adds a stroke, as an import does.
  StrokeId add(Stroke stroke) {
    const StrokeId id = document.new_id();
    apply({"Import",
           {{id,
             nullptr,
             std::make_shared<const Stroke>(std::move(stroke)),
             {},
             {layer, document.layer(layer)->strokes.size()}}}});
    return id;
  }

  /// Returns the strokes in drawing order.
  [[nodiscard]] std::vector<StrokePtr> strokes() const {
    std::vector<StrokePtr> all;
    for (const Layer& l : document.layers()) {
      for (StrokeId id : l.strokes) all.push_back(document.find(id));
    }
    return all;
  }
};

/// A pen that sends samples to a tool. Time advances by step_ns per sample.
class Pen {
 public:
  Pen(Tool& tool, Fixture& fixture) : tool_(tool), fixture_(fixture) {}

  std::int64_t step_ns = 1'000'000;
  double depth = 1.0;  ///< depth in contact, mm; on paper 1 mm is 0.5 N
  std::optional<double> pressure;
  std::uint32_t buttons = 0;
  int commits = 0;

  ToolResult at(const Vec3& position) {
    PenSample s;
    s.time_ns = now_ns += step_ns;
    s.position = position;
    if (position.z < 0.0) s.pressure = pressure;
    s.buttons = buttons;
    return give(s);
  }
  ToolResult give(const PenSample& s) {
    if (!is_pen_position(s.position)) return {};
    ToolResult result = tool_.sample(s, contact_.update(s), fixture_.scene());
    if (result.selection) fixture_.selection = *result.selection;
    if (result.commit) {
      ++commits;
      fixture_.apply(*result.commit);
    }
    return result;
  }
  void down(Point p) { at({p.x, p.y, -depth}); }
  void up(Point p) { at({p.x, p.y, 10.0}); }
  /// Moves in contact along the points, without lifting.
  void along(const std::vector<Point>& way) {
    for (const Point p : way) down(p);
  }
  /// Draws one whole line: touches at the first point, moves along the points and lifts at the last
  /// one.
  void line(const std::vector<Point>& way) {
    up(way.front());
    along(way);
    up(way.back());
  }

  std::int64_t now_ns = 0;

 private:
  Tool& tool_;
  Fixture& fixture_;
  Contact contact_;
};

/// Returns points every `step` mm on the straight line from a to b.
inline std::vector<Point> way(Point a, Point b, double step = 0.1) {
  std::vector<Point> points;
  const int n = std::max(1, static_cast<int>(distance(a, b) / step));
  for (int i = 0; i <= n; ++i) points.push_back(lerp(a, b, static_cast<double>(i) / n));
  return points;
}

inline std::vector<Point> operator+(std::vector<Point> a, const std::vector<Point>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Returns points on a circle, from angle a0 to a1 in degrees.
inline std::vector<Point> arc(Point center, double radius, double a0, double a1) {
  std::vector<Point> points;
  for (int i = 0; i <= 600; ++i) {
    const double a = (a0 + (a1 - a0) * i / 600) * std::numbers::pi / 180.0;
    points.push_back(center + radius * Vec{std::cos(a), std::sin(a)});
  }
  return points;
}

}  // namespace felt::testing
