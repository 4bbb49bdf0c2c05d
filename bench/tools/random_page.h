#pragma once

#include <memory>
#include <random>

#include "felt/document/document.h"

namespace felt::bench {

/// Random ink on a large square page. Its density hardly depends on the number of strokes.
class Page {
 public:
  explicit Page(int strokes);

  [[nodiscard]] Document take() { return std::move(document_); }
  /// Returns a random stroke of 8 to 12 smooth segments, a few mm long each.
  StrokePtr scribble();
  [[nodiscard]] double side_mm() const noexcept { return side_mm_; }
  double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random_);
  }

 private:
  std::mt19937_64 random_{1};
  double side_mm_;
  Document document_;
};

}  // namespace felt::bench
