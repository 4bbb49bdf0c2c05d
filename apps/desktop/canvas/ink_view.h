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
/// that painting only copies and the pen never waits (docs/design/rendering.md#tiles).
///
///   view.set_document(document);        // once; then
///   view.apply(edit);                   // for every edit that the document applied
///   view.show(session.preview());       // the preview of a gesture
///   view.set_view(canvas_view, dpr);
///   view.paint(painter, dirty);         // copies the tiles; old ones stand in for missing ones
///
/// Qt's main thread; the worker is inside.
class InkView : public QObject {
  Q_OBJECT

 public:
  explicit InkView(QObject* parent = nullptr);
  ~InkView() override;

  void set_document(const Document& document);
  void apply(const Edit& edit);
  /// Shows `preview` applied to the document, replacing any previous preview. Cheap if the previews
  /// of a gesture change the same strokes, as they usually do.
  void show(const std::optional<Edit>& preview);
  /// Sets the view. `dpr`: device pixels per widget pixel.
  void set_view(const CanvasView& view, double dpr);
  /// Sets the relief of the surface for the ink; its field must outlive this.
  void set_grain(const Grain& grain);
  /// Shows only centre lines, hair-thin.
  void set_outline_mode(bool on);
  /// New ink goes into this layer, below the ink of the layers above it; none: above all ink.
  void draw_below(std::optional<LayerId> layer);
  /// Paints what covers new ink over `ink`, a picture of it whose corner is at the device pixel
  /// `at` of the widget. Paints only where `ink` has ink, so that the result can be painted over
  /// the canvas.
  void cover(QImage& ink, QPoint at);
  /// Returns the transform from mm to widget pixels exactly as the ink is painted: that of the
  /// view, shifted by less than a device pixel so that panning copies. Use it for anything that
  /// must lie on the ink without a seam.
  [[nodiscard]] QTransform transform() const;
  /// Paints the ink of this part of the widget over the painter's present content.
  void paint(QPainter& painter, const QRect& part);
  /// Returns the number of the view's tiles that are missing; others stand in for them.
  [[nodiscard]] int missing_tiles() const;
  /// Returns true if all tiles of the view are up to date.
  [[nodiscard]] bool is_up_to_date() const;
  /// Waits until is_up_to_date(); for tests and pictures.
  void finish();

 Q_SIGNALS:
  /// This part of the widget has to be painted again.
  void changed(const QRect& part);

 private:
  void take_news();
  void take_over(TileNews& news);
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt::desktop
