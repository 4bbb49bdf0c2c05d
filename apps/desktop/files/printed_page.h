#pragma once

#include <QImage>
#include <QRectF>
#include <map>
#include <optional>
#include <utility>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/render/grain.h"

class QPainter;
class QPrinter;

namespace felt::desktop {

/// A page that is ready to be printed.
///
/// Strokes and fills are painted as vector shapes. Some content cannot be: a layer whose opacity
/// applies to several strokes together becomes a picture of this layer. If the drawing has a blend
/// mode or a translucent group, the whole page becomes one picture. These pictures have at most 400
/// dots per inch.
///
/// Everything that can fail happens in create(), so that no page is printed if something is wrong.
class PrintedPage {
 public:
  /// Prepares a page for a resolution of `dpi`. If `grain` is given, strokes that show grain are
  /// painted as pictures with 300 dots per inch, or with a lower resolution if `dpi` is lower or
  /// all pictures together would be too large. Fails if a picture is damaged or does not fit into
  /// memory; the message names its layer.
  static Result<PrintedPage> create(Drawing drawing, double dpi,
                                    const std::optional<Grain>& grain = {});

  /// Paints the page. One unit of the painter must be 1/dpi inch; the page then has its true size.
  /// The corner of the page is at the origin.
  void paint(QPainter& painter, double dpi) const;

 private:
  /// A part of the page that is painted as a picture. If `image` is null, the part is empty.
  struct Part {
    QImage image;
    QRectF area_mm;
  };

  explicit PrintedPage(Drawing drawing) : drawing_(std::move(drawing)) {}
  static Result<Part> whole_page(const Drawing& drawing, double dpi, const Grain& grain);
  static Result<Part> whole_layer(const Document& document, const Layer& layer, const Rect& area,
                                  double px_per_mm, const Grain& grain);
  Result<void> make_parts(double dpi);
  [[nodiscard]] Result<void> check_pictures() const;
  void paint_layers(QPainter& painter) const;

  Drawing drawing_;
  std::optional<Grain> grain_;
  double grain_dpi_ = 0.0;
  std::optional<Part> page_;       // set if the whole page is one picture
  std::map<LayerId, Part> parts_;  // the layers that are pictures
};

/// Prints the drawing, with the grain if the screen shows it. Pictures have at most `max_dpi` dots
/// per inch: a preview that shows the page smaller would leave out pixels of finer ones. Fails like
/// PrintedPage::create, or if the printer cannot be used; nothing is printed then.
Result<void> print_drawing(QPrinter& printer, const Drawing& drawing, double max_dpi = 1e9);

}  // namespace felt::desktop
