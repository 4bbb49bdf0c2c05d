#pragma once

#include <QImage>
#include <QObject>
#include <QPixmap>
#include <QTimer>
#include <map>
#include <memory>
#include <set>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Small pictures of the layers of a studio's drawing: the page with the strokes, the fills and the
/// picture of one layer. Thin lines are darkened, because they cover little of a pixel. They are
/// painted again soon after an edit, and not while edits follow each other.
class LayerThumbnails : public QObject {
  Q_OBJECT

 public:
  /// Largest size, in device-independent pixels.
  static constexpr QSize kSize{34, 24};
  /// If a layer has more strokes, or more fills, only so many of them are shown, evenly spread, so
  /// that painting stays fast.
  static constexpr std::size_t kMaxShown = 1000;

  LayerThumbnails(Studio& studio, QObject* parent);

  /// Returns the thumbnail of a layer, which may be a little out of date. Null if it was not
  /// painted yet.
  [[nodiscard]] QPixmap of(LayerId layer) const;
  /// Paints all thumbnails that are out of date.
  void paint_now();

 Q_SIGNALS:
  void painted();

 private:
  void follow(const Edit& edit);
  void forget_all();
  [[nodiscard]] QPixmap paint(const Layer& layer);
  [[nodiscard]] QImage ink_of(const Layer& layer, double px_per_mm) const;

  Studio& studio_;
  QTimer timer_;
  std::map<LayerId, QPixmap> pixmaps_;
  std::set<LayerId> dirty_;
  // Reduced pictures of layers, because decoding a picture takes long.
  std::map<std::shared_ptr<const PictureData>, QImage> pictures_;
};

}  // namespace felt::desktop
