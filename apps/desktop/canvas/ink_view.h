#pragma once

#include <QImage>
#include <QObject>
#include <QPainter>
#include <QRect>
#include <QSize>
#include <memory>
#include <optional>

#include "desktop/canvas/canvas_view.h"
#include "felt/document/document.h"
#include "felt/render/grain.h"

namespace felt::desktop {

struct TileNews;

/// Paints a document's ink in a widget from raster tiles. A worker thread keeps the tiles up to
/// date, so that painting only copies pixels and the pen never waits
/// (docs/design/rendering.md#tiles).
///
///   view.set_document(document);        // once; then
///   view.apply(edit);                   // for every edit that the document applied
///   view.show(session.preview());       // the preview of a gesture
///   view.set_view(canvas_view, dpr);
///   view.paint(painter, dirty);         // copies the tiles; old tiles replace missing tiles
///
/// Use it in Qt's main thread. It owns the worker thread.
class InkView : public QObject {
  Q_OBJECT

 public:
  explicit InkView(QObject* parent = nullptr);
  ~InkView() override;

  void set_document(const Document& document);
  void apply(const Edit& edit);
  /// Shows `preview` applied to the document, replacing any previous preview. This is fast if all
  /// previews of a gesture change the same strokes, as they usually do.
  void show(const std::optional<Edit>& preview);
  /// Sets the view. `dpr` is the number of device pixels per widget pixel.
  void set_view(const CanvasView& view, double dpr);
  /// Sets the relief of the surface that the ink shows. The field of `grain` must outlive this
  /// object.
  void set_grain(const Grain& grain);
  /// Sets the colour below the ink, with which blend modes multiply. A transparent one counts as
  /// white.
  void set_paper(Rgba paper);
  /// Sets whether strokes are shown only as hairlines along their centres.
  void set_outline_mode(bool on);
  /// Sets the layer of new ink; the layers above it cover new ink. Without a layer, new ink is
  /// painted above all other ink.
  void draw_below(std::optional<LayerId> layer);
  /// Paints the layers above the new ink onto `ink`, which is a picture of the new ink. The top
  /// left corner of the picture is at the device pixel `at` of the widget. Changes only pixels that
  /// have new ink, so that the caller can then paint `ink` over the canvas.
  void cover(QImage& ink, QPoint at);
  /// Returns the exact transform from mm to widget pixels with which the ink is painted: the view's
  /// transform, shifted by less than a device pixel so that panning can copy pixels. Use this
  /// transform for everything that must be exactly aligned with the ink.
  [[nodiscard]] QTransform transform() const;
  /// Paints the ink of this part of the widget over the painter's existing content.
  void paint(QPainter& painter, const QRect& part);
  /// Returns the number of the view's tiles that are missing. Older tiles are painted in their
  /// place.
  [[nodiscard]] int missing_tiles() const;
  /// Returns true if all tiles of the view are up to date.
  [[nodiscard]] bool is_up_to_date() const;
  /// Waits until is_up_to_date() is true; for tests and pictures.
  void finish();

 Q_SIGNALS:
  /// Emitted when this part of the widget must be painted again.
  void changed(const QRect& part);

 private:
  void take_news();
  void take_over(TileNews& news);
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt::desktop
