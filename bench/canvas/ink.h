#pragma once

#include <cstddef>
#include <functional>
#include <random>

#include "felt/document/document.h"

namespace felt::bench {

/// A drawing of any size: copies of the project's samples, drawn by the simulated hand and fitted.
class Ink {
 public:
  /// Places the copies side by side.
  explicit Ink(std::size_t strokes);
  /// Places all copies on `page`, at random positions, one over another.
  Ink(std::size_t strokes, const Rect& page);

  [[nodiscard]] const Document& document() const noexcept { return document_; }
  [[nodiscard]] Document& document() noexcept { return document_; }
  /// Returns the bounding box of all strokes.
  [[nodiscard]] const Rect& area() const noexcept { return area_; }
  /// Returns a random stroke of the drawing.
  StrokeId any();
  /// Returns a copy of the stroke, moved by `by`.
  static StrokePtr moved(const Stroke& stroke, Vec by);
  /// Returns the stroke with one joint and its handles moved by `by`, as a pull does. `joint` is
  /// taken modulo the number of joints. Returns nullptr if the result is not a valid stroke, or if
  /// the joint is the start of a closed stroke.
  static StrokePtr pulled(const Stroke& stroke, int joint, Vec by);
  double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random_);
  }

 private:
  void lay(std::size_t strokes, const std::function<Vec(double area)>& place);

  Document document_;
  Rect area_;
  std::mt19937_64 random_{1};
};

}  // namespace felt::bench
