#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/render/style_layout.h"
#include "felt/render/style_spine.h"
#include "felt/render/styled_outline.h"

namespace felt {

/// Draws the parts of a style along a spine, as closed polygons with the same orientation, so that
/// parts may overlap. Reuses its buffers.
class StylePen {
 public:
  StylePen();

  /// Starts to replace `ink`. All three must outlive the drawing.
  void begin(const Spine& spine, double tolerance, StyledInk& ink);

  /// Draws the part `span` of the line as a line whose width is the share `thin` of the line's.
  void line(StyleSpan span, double thin);
  /// Draws a line on each side, with the share `thin` of the line's width each, at most a half.
  void rails(StyleSpan span, double thin);
  /// Draws a shape, stretched over `span` and bent with the line. If `from` is greater than `to`,
  /// the shape points backwards.
  void shape(StyleSpan span, const StyleShape& shape);
  /// Draws parallel lines inside the closed spine. Lengths in the unit of the row. Their width is
  /// the share `thin` of the line's mean width, and at an end at most the line's width there.
  void hatching(double angle_deg, double spacing, double thin);

 private:
  /// A point where a line of the hatching enters or leaves the area.
  struct Crossing {
    std::int64_t line = 0;
    double at = 0.0;  ///< position along the line of the hatching
    double radius = 0.0;

    bool operator<(const Crossing& o) const noexcept {
      return line != o.line ? line < o.line : at < o.at;
    }
  };

  [[nodiscard]] bool is_full() const noexcept;
  void append_row();
  void append_points(StyleSpan span, double thin);
  void rail(StyleSpan span, double share, double side);
  [[nodiscard]] bool is_inside_bend(const Dab& dab, double offset, std::size_t near) const noexcept;
  [[nodiscard]] bool meets_line(const Dab& dab, double offset, std::size_t near,
                                int way) const noexcept;
  void join_rail(bool is_ring);
  void bend(Point from, Point to, std::vector<Point>& out) const;
  void append_inner(Point from, Point to, std::vector<Point>& out) const;
  void bend_contour(std::span<const Point> curves, StyleSpan span, double width);
  [[nodiscard]] Point place(Point p) const noexcept;

  const Spine* spine_ = nullptr;
  double tolerance_ = 0.0;
  StyledInk* ink_ = nullptr;
  StrokeOutliner outliner_;
  double orientation_ = 1.0;  // sign of the area of the outliner's contours
  std::vector<Dab> row_;
  std::vector<Dab> rail_;
  std::vector<bool> is_kept_;
  std::vector<Point> contour_;
  std::vector<Crossing> crossings_;
  Outline bent_;
};

}  // namespace felt
