#pragma once

#include <QImage>
#include <QThreadPool>
#include <QWidget>
#include <array>
#include <cstdint>

#include "desktop/materials/medium_picture.h"

namespace felt::desktop {

/// A preview of a medium on a surface: three strokes with light, medium and strong pressure, in
/// life size, on a page with the colour of the surface. Another thread draws the preview; a newer
/// request replaces an older one.
class StrokePreview : public QWidget {
  Q_OBJECT

 public:
  static constexpr std::array kForces{0.15, 0.5, 0.9};

  explicit StrokePreview(QWidget* parent = nullptr);
  ~StrokePreview() override;

  void show_medium(const Medium& medium, const SurfaceMaterial& surface);
  [[nodiscard]] const QImage& picture() const noexcept { return picture_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void drawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void draw();

  MediumPicture wanted_;
  QImage picture_;
  bool has_wish_ = false, is_busy_ = false, is_stale_ = false;
  QThreadPool worker_;  // last, so that it ends before the other members are destroyed
};

}  // namespace felt::desktop
