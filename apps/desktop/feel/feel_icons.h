#pragma once

#include <QIcon>
#include <QPalette>

#include "desktop/feel/safety_words.h"
#include "felt/material/materials.h"

namespace felt::desktop {

/// Device-independent pixels per mm; such a pixel is 1/96 inch.
inline constexpr double kScreenPxPerMm = 96.0 / 25.4;

/// Returns an icon for a state, in the colour of text. Each state has its own shape, so that it can
/// be recognised without colour: a check mark, a ring, an eye, dots, a triangle or a stop sign.
QPixmap level_icon(FeelLevel level, const QPalette& palette, int size, qreal dpr);

/// Returns a ring with a question mark, which stands for help, if `asks` is true; otherwise a ring
/// with a dot, which stands for something that is present.
QPixmap ring_icon(bool asks, const QPalette& palette, int size, qreal dpr);

/// Returns a red stop sign, for the button that ends all forces.
QIcon stop_icon(const QPalette& palette, int size, qreal dpr);

/// Returns the palette of the button that ends all forces: `palette` with a slight red tint.
QPalette stop_palette(QPalette palette);

/// Returns the icon of a button for a choice. It shows the swatch with an outline. If the button is
/// checked, it also shows a frame with a check mark.
QIcon swatch_icon(const QPixmap& swatch, const QPalette& palette);

/// Returns a picture of a chalk stroke on a surface. The pressure of the stroke increases from left
/// to right. The picture shows the same relief that the hand feels (felt/render/grain.h), in life
/// size, on white paper in every theme.
QIcon material_icon(const SurfaceMaterial& material, const QPalette& palette, QSize size,
                    qreal dpr);

}  // namespace felt::desktop
