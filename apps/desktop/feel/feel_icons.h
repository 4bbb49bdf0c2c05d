#pragma once

#include <QIcon>
#include <QPalette>

#include "desktop/feel/safety_words.h"
#include "felt/material/materials.h"

namespace felt::desktop {

/// Device-independent pixels: 1/96 inch each.
inline constexpr double kScreenPxPerMm = 96.0 / 25.4;

/// A sign for a state, told by its shape: a check mark, a ring, an eye, dots, a triangle, a stop
/// sign. In the colour of the text.
QPixmap level_icon(FeelLevel level, const QPalette& palette, int size, qreal dpr);

/// A ring with a dot: something that is there; with a question mark: something to ask about.
QPixmap ring_icon(bool asks, const QPalette& palette, int size, qreal dpr);

/// A stop sign, red where colours are seen: for the button that ends all forces.
QIcon stop_icon(const QPalette& palette, int size, qreal dpr);

/// Of that button: a little red in what it had.
QPalette stop_palette(QPalette palette);

/// A picture of something to choose on a button: with an edge, and in a frame with a check mark
/// where it is the chosen one.
QIcon swatch_icon(const QPixmap& swatch, const QPalette& palette);

/// How a material looks under chalk that is pressed on harder from left to right: the very relief
/// that the hand feels (felt/render/grain.h), in life size. On the white of the sheet, in every
/// theme.
QIcon material_icon(const SurfaceMaterial& material, const QPalette& palette, QSize size,
                    qreal dpr);

}  // namespace felt::desktop
