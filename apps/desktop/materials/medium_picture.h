#pragma once

#include <QColor>
#include <QImage>
#include <QSize>
#include <optional>
#include <vector>

#include "felt/material/materials.h"
#include "felt/render/grain.h"

namespace felt::desktop {

/// What a picture of a medium on a sheet shows.
struct MediumPicture {
  Medium medium;
  SurfaceMaterial sheet;
  QSize size{64, 26};       ///< device-independent pixels
  qreal dpr = 1.0;          ///< pixels of the screen for one of them
  QColor ink{35, 38, 45};   ///< of the stroke
  QColor paper{Qt::white};  ///< of the sheet
  /// One stroke each, below each other, pressed on so hard, 0..1. Empty: one stroke, lightly at its
  /// left end and hard at its right.
  std::vector<double> forces{};
  /// Of the sheet, with the media that are known; made where it is absent, which takes longer than
  /// the picture.
  std::optional<Grain> grain{};
};

/// Strokes of a medium on a sheet, in life size, drawn as the canvas draws them: felt/render with
/// the sheet's grain. A stroke that is too broad for the picture is drawn as broad as fits.
/// Some milliseconds with a grain; any thread.
QImage draw_medium(const MediumPicture& picture);
/// Of a sheet and media; up to 100 ms for a relief that nobody has asked for yet; any thread.
Grain grain_for(const SurfaceMaterial& sheet, const Materials& media);

/// Ink of this colour where it is seen on such paper, else black or white.
QColor readable_ink(const QColor& ink, const QColor& paper);

}  // namespace felt::desktop
