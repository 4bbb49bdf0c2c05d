#pragma once

#include <QColor>
#include <QImage>
#include <QSize>
#include <optional>
#include <vector>

#include "felt/material/materials.h"
#include "felt/render/grain.h"

namespace felt::desktop {

/// The content of a picture of a medium on a surface.
struct MediumPicture {
  Medium medium;
  SurfaceMaterial sheet;
  QSize size{64, 26};       ///< device-independent pixels
  qreal dpr = 1.0;          ///< device pixels per device-independent pixel
  QColor ink{35, 38, 45};   ///< of the stroke
  QColor paper{Qt::white};  ///< of the page
  /// Forces of the strokes, 0..1, one below the other. Empty: one stroke, light at its left end and
  /// hard at its right.
  std::vector<double> forces{};
  /// Grain of the surface for the known media. If absent it is made, which takes longer than the
  /// picture.
  std::optional<Grain> grain{};
};

/// Draws strokes of a medium on a surface, in life size, as the canvas does: felt/render with the
/// surface's grain. A stroke that is too wide for the picture is drawn as wide as fits. Takes some
/// milliseconds if the grain is given; any thread.
QImage draw_medium(const MediumPicture& picture);
/// Makes the grain of a surface for these media; takes up to 100 ms for a new relief; any thread.
Grain grain_for(const SurfaceMaterial& sheet, const Materials& media);

/// Returns this ink colour if it is readable on the paper, otherwise black or white.
QColor readable_ink(const QColor& ink, const QColor& paper);

}  // namespace felt::desktop
