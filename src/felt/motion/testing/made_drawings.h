#pragma once

// For tests and benchmarks, not installed: key drawings of random strokes, and how they move.

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/document/drawing.h"
#include "felt/document/edit_builder.h"
#include "felt/motion/similarity.h"
#include "felt/stroke/stroke.h"

namespace felt::testing {

/// Returns curved strokes of 5 to 40 mm, anywhere on a page of 200 mm.
inline std::vector<StrokePtr> made_strokes(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<StrokePtr> strokes;
  for (std::size_t k = 0; k < count; ++k) {
    StrokeData data;
    const int n = 2 + static_cast<int>(random.between(0.0, 5.0));
    double angle = random.between(0.0, kTau), bend = random.between(-0.8, 0.8);
    const double step = random.between(2.5, 8.0) / 3.0;
    data.points.push_back({random.between(0.0, 200.0), random.between(0.0, 200.0)});
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < 3; ++j) {
        data.points.push_back(data.points.back() + step * Vec{std::cos(angle), std::sin(angle)});
        if (j < 2) angle += 0.5 * bend;
      }
      if (i > 0) data.joints.push_back(JointKind::kSmooth);
      bend += random.between(-0.5, 0.5);
      data.widths.push_back({static_cast<double>(i), random.between(0.3, 1.5)});
    }
    data.widths.push_back({static_cast<double>(n), 0.5});
    strokes.push_back(std::make_shared<const Stroke>(Stroke::create(std::move(data)).value()));
  }
  return strokes;
}

/// Returns the strokes moved, each with its control points shaken by up to `noise_mm` as a whole.
inline std::vector<StrokePtr> moved_strokes(const std::vector<StrokePtr>& strokes,
                                            const Similarity& motion, double noise_mm,
                                            std::uint64_t seed) {
  Random random(seed);
  std::vector<StrokePtr> result;
  for (const StrokePtr& stroke : strokes) {
    StrokeData data = stroke->data();
    const Vec shift{noise_mm * random.normal(), noise_mm * random.normal()};
    for (Point& p : data.points) p = moved(motion, p) + shift;
    if (data.closed) data.points.back() = data.points.front();
    result.push_back(std::make_shared<const Stroke>(Stroke::create(std::move(data)).value()));
  }
  return result;
}

/// Returns a drawing with these strokes in one layer.
inline Drawing drawing_of(const std::vector<StrokePtr>& strokes) {
  Drawing drawing;
  EditBuilder edit(drawing.document);
  for (const StrokePtr& stroke : strokes) edit.add(drawing.document.layers().front().id, stroke);
  const Edit made = std::move(edit).build("Made");
  (void)drawing.document.apply(made);
  return drawing;
}

}  // namespace felt::testing
