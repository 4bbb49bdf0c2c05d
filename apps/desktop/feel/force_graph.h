#pragma once

#include <QColor>
#include <QPixmap>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "desktop/feel/force_history.h"

namespace felt::desktop {

/// A limit to plot: a dashed line, drawn only if it lies within the axes.
struct ForceBound {
  QString label;
  double newton = 0.0;
};

/// The look of one track of the history: a colour that is visible on this palette, a mark that
/// distinguishes the track without colour, and a width.
struct TrackStyle {
  QColor color;
  int mark = 0;  ///< number of the mark's shape; 0 means no mark
  qreal width = 1.0;
};
TrackStyle track_style(std::size_t track, const QPalette& palette);
/// Draws the mark of a style; `radius` in pixels.
void draw_mark(QPainter& painter, int mark, QPointF at, qreal radius);

/// The plot of a ForceHistory. The owner must call update() when the history has changed. Axes and
/// lines are cached as pictures: each frame shifts the picture of the lines and draws only the new
/// parts at its end.
class ForceGraph : public QWidget {
  Q_OBJECT

 public:
  /// `history` must outlive this object.
  explicit ForceGraph(const ForceHistory& history, QWidget* parent = nullptr);
  /// Shows another history, which must outlive this object.
  void show_history(const ForceHistory& history);

  void set_bounds(std::vector<ForceBound> bounds);
  /// Sets whether sent forces are drawn. Pass false if no device receives forces; then only the
  /// requested forces are drawn.
  void set_shows_sent(bool shown);
  /// Returns the largest force on the axis, in N. It grows immediately when a larger force occurs,
  /// and shrinks when the larger force has left the plot.
  [[nodiscard]] double top_n() const noexcept { return top_n_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] QRectF axes() const;
  [[nodiscard]] double wanted_top() const;
  [[nodiscard]] QPixmap blank(QSizeF size) const;
  void forget() { ground_ = {}; }
  void draw_ground(const QRectF& in);
  void draw_grid(QPainter& painter, const QRectF& in) const;
  void draw_bounds(QPainter& painter, const QRectF& in) const;
  void bring_lines_up(QSizeF size);
  void draw_lines(std::int64_t from, std::int64_t to);
  void draw_track(QPainter& painter, std::size_t track, std::int64_t from, std::int64_t to) const;
  /// Returns the pixel column at which a bin of the history ends; columns are counted from time 0.
  [[nodiscard]] std::int64_t column_of(std::int64_t bin) const;

  const ForceHistory* history_;
  std::vector<ForceBound> bounds_;
  bool shows_sent_ = true;
  double top_n_ = 1.0;
  QPixmap ground_;  // null if everything must be drawn again
  QPixmap lines_;
  std::int64_t drawn_to_ = -1;  // the last bin that is in lines_
};

}  // namespace felt::desktop
