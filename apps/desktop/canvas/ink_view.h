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

/// The picture of a document's ink for a widget: raster tiles that a worker keeps up to date, so
/// that painting is copying and the pen is never waited for (performance 1.4).
///
///   view.set_document(document);        // once; then
///   view.apply(edit);                   // every edit that it took
///   view.show(session.preview());       // what a gesture would do: its strokes apart
///   view.set_view(canvas_view, dpr);
///   view.paint(painter, dirty);         // copies what is there; old tiles, scaled, where new ones
///                                       // are being made
///
/// Qt's main thread; the worker is inside.
class InkView : public QObject {
  Q_OBJECT

 public:
  explicit InkView(QObject* parent = nullptr);
  ~InkView() override;

  void set_document(const Document& document);
  void apply(const Edit& edit);
  /// The document with this edit is what is to be seen; replaces the last one. Cheap when it is the
  /// same strokes of which others come out, as in every gesture.
  void show(const std::optional<Edit>& preview);
  /// `dpr`: device pixels a widget pixel.
  void set_view(const CanvasView& view, double dpr);
  /// The relief of the sheet in the ink; its field must outlive this.
  void set_grain(const Grain& grain);
  /// Centre lines only, hair-thin.
  void set_outline_mode(bool on);
  /// New ink goes into this layer, below the ink of the layers above it; none: over all ink.
  void draw_below(std::optional<LayerId> layer);
  /// Paints what covers new ink over a picture of it whose corner is at this device pixel of the
  /// widget; only where it has ink itself, so that it can be painted over all that is there.
  void cover(QImage& ink, QPoint at);
  /// From mm to widget pixels, exactly as the ink is painted: as the view says but for a part of a
  /// device pixel, so that panning copies. What is to lie on the ink without a seam uses this.
  [[nodiscard]] QTransform transform() const;
  /// Paints the ink of this part of the widget over what the painter has.
  void paint(QPainter& painter, const QRect& part);
  /// Tiles of the view that are not there yet; others stand in for them.
  [[nodiscard]] int missing_tiles() const;
  /// All tiles of the view are as they should be.
  [[nodiscard]] bool is_up_to_date() const;
  /// Waits for that; for tests and pictures.
  void finish();

 Q_SIGNALS:
  /// This part of the widget is to be painted again.
  void changed(const QRect& part);

 private:
  void take_news();
  void take_over(TileNews& news);
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt::desktop
