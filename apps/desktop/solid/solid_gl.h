#pragma once

#include <QImage>
#include <QSize>
#include <cstdint>
#include <memory>

#include "felt/solid/solid.h"
#include "felt/solid/solid_picture.h"

namespace felt::desktop {

/// Paints solids with OpenGL 2.1 or OpenGL ES 2.0, with the light and colours of paint_solid(). It
/// paints into a buffer of its own and returns a picture: a QOpenGLWidget would make Qt compose the
/// whole window with OpenGL, so that every line of the pen would be shown later.
///
/// Use it in Qt's main thread.
class SolidGl {
 public:
  /// How the edges look: smooth ones take about three times as long with software OpenGL. A fast
  /// picture leaves out a wireframe of more than 30,000 lines.
  enum class Quality : std::uint8_t { kFast, kSmooth };

  /// Returns null if this computer, or the platform plugin, has no OpenGL.
  static std::unique_ptr<SolidGl> create();
  ~SolidGl();
  SolidGl(const SolidGl&) = delete;
  SolidGl& operator=(const SolidGl&) = delete;

  /// Sets the bodies, and the ink on their fronts or null. Both are copied to the graphics memory.
  void set_solid(const Solid& solid, const FrontPaint* paint);
  /// Returns the picture, or a null picture if OpenGL has failed, for example because the driver
  /// was reset.
  QImage paint(const SolidCamera& camera, const SolidLook& look, QSize size_px, Quality quality);

 private:
  struct Parts;
  explicit SolidGl(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace felt::desktop
