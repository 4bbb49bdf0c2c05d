#pragma once

#include <cstddef>
#include <functional>
#include <random>

#include "felt/document/document.h"

namespace felt::bench {

/// A drawing as large as you like: the project's samples, drawn by the simulated hand and fitted,
/// again and again side by side.
class Ink {
 public:
  explicit Ink(std::size_t strokes);
  /// All of them on one page, sheet over sheet.
  Ink(std::size_t strokes, const Rect& page);

  [[nodiscard]] const Document& document() const noexcept { return document_; }
  [[nodiscard]] Document& document() noexcept { return document_; }
  /// Around all of it.
  [[nodiscard]] const Rect& area() const noexcept { return area_; }
  /// A stroke of the drawing.
  StrokeId any();
  /// The same line elsewhere.
  static StrokePtr moved(const Stroke& stroke, Vec by);
  /// The line with one joint moved, and the handles at it: what a pull does. Another joint for
  /// another number.
  static StrokePtr pulled(const Stroke& stroke, int joint, Vec by);
  double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random_);
  }

 private:
  void lay(std::size_t strokes, const std::function<Vec(double sheet)>& place);

  Document document_;
  Rect area_;
  std::mt19937_64 random_{1};
};

}  // namespace felt::bench
