#pragma once

#include <QColor>
#include <QImage>
#include <QSize>
#include <optional>
#include <vector>

#include "felt/material/materials.h"
#include "felt/render/grain.h"

namespace felt::desktop {

/// Describes a picture of a medium on a surface.
struct MediumPicture {
  Medium medium;
  SurfaceMaterial surface;
  QSize size{64, 26};       ///< device-independent pixels
  qreal dpr = 1.0;          ///< device pixels per device-independent pixel
  QColor ink{35, 38, 45};   ///< colour of the stroke
  QColor paper{Qt::white};  ///< colour of the page
  /// Pressure of each stroke, 0..1, from top to bottom. If empty, the picture has one stroke, with
  /// light pressure at its left end and strong pressure at its right end.
  std::vector<double> forces{};
  /// Grain of the surface for the known media (grain_for()). If absent, draw_medium() makes the
  /// grain; this takes longer than drawing the picture.
  std::optional<Grain> grain{};
};

/// Draws strokes of a medium on a surface, in life size, with the same renderer and grain as the
/// canvas. If a stroke is too wide for the picture, draws it as wide as possible. Takes some
/// milliseconds if the grain is given. Safe to call from any thread.
QImage draw_medium(const MediumPicture& picture);
/// Makes the grain of a surface for these media. Takes up to 100 ms for a new relief. Safe to call
/// from any thread.
Grain grain_for(const SurfaceMaterial& surface, const Materials& media);

/// Returns `ink` if it is readable on the paper, otherwise black or white.
QColor readable_ink(const QColor& ink, const QColor& paper);

}  // namespace felt::desktop
