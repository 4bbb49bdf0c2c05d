#pragma once

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QPolygonF>
#include <QRect>
#include <QString>
#include <cstdint>
#include <vector>

#include "desktop/canvas/canvas_view.h"
#include "felt/tools/overlay.h"

namespace felt::desktop {

/// A shape that is drawn over the ink, in widget pixels. Marks that compare equal look the same.
/// Therefore only marks that differ between two lists have to be painted again.
struct Mark {
  enum class Kind : std::uint8_t {
    kLines,   ///< joined lines
    kArrow,   ///< from points[0] to points[1]
    kRing,    ///< points[0], size: radius
    kDot,     ///< points[0]
    kLabel,   ///< text in a box from points[0] to points[1]
    kNib,     ///< the point where ink would begin: points[0], size: radius
    kHand,    ///< the line from the hand to the nib if forces hold the nib back
    kForce,   ///< the force as an arrow at the nib
    kNormal,  ///< a bar for the force out of the surface: points[0], size: height
  };
  Kind kind = Kind::kLines;
  Overlay::Role role = Overlay::Role::kGuide;
  QPolygonF points = {};
  double size = 0.0;
  double phase = 0.0;  ///< length of the line before this part, so that dashes continue without a
                       ///< jump
  QString text = {};
  QRect box = {};  ///< bounds of everything that is painted

  friend bool operator==(const Mark&, const Mark&) = default;
};

using Marks = std::vector<Mark>;

/// Position of the pen and the force on it, in widget pixels.
struct PenMark {
  QPointF hand;         ///< position of mouse or tablet
  QPointF nib;          ///< position at which the nib is shown
  double radius = 0.0;  ///< radius of the dot that the pen would draw; if 0, no ring is drawn
                        ///< around the nib
  QPointF force_n{};    ///< force in the plane, in screen directions, N; if 0, no arrow is drawn
  double out_n = 0.0;   ///< force out of the surface, N; if 0, no bar is drawn
};

/// Adds the marks of a tool, except wet ink and bands. Skips marks outside of the widget.
void list_overlay(const Overlay& overlay, const CanvasView& view, const QFont& font, Marks& marks);
/// Adds the marks for the nib, the hand and the force.
void list_pen(const PenMark& pen, Marks& marks);
/// Skips the marks at the start and at the end that are equal in both lists, and adds the areas of
/// all other marks to `region`. If a list has many such marks, adds one rectangle around all of
/// them instead.
void add_difference(const Marks& before, const Marks& after, QRegion& region);

/// Returns the opaque mixture of two colours: `a` if share_of_b is 0, `b` if it is 1.
QColor mixed(QColor a, QColor b, double share_of_b);

/// The colours of marks on paper. People with any kind of colour vision can distinguish these
/// colours. Lighter colours are used on dark paper. A halo separates every mark from the ink below.
class MarkLook {
 public:
  explicit MarkLook(QColor paper);
  [[nodiscard]] QColor color(Overlay::Role role) const;
  /// Returns an opaque colour for a band on the paper.
  [[nodiscard]] QColor band(Overlay::Role role) const;
  [[nodiscard]] QColor force() const;
  [[nodiscard]] QColor halo() const noexcept { return halo_; }
  [[nodiscard]] QColor plate() const noexcept { return plate_; }
  [[nodiscard]] QColor text() const noexcept { return text_; }
  [[nodiscard]] bool is_on_dark() const noexcept { return on_dark_; }

 private:
  [[nodiscard]] QColor seen(std::size_t palette_index) const;

  QColor paper_, halo_, plate_, text_;
  bool on_dark_ = false;
};

void paint_mark(QPainter& painter, const Mark& mark, const MarkLook& look, const QFont& font);

}  // namespace felt::desktop
