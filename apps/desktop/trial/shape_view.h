#pragma once

#include <QPixmap>
#include <QWidget>

#include "desktop/canvas/canvas.h"
#include "felt/studies/study_files.h"
#include "felt/trial/study_order.h"

namespace felt::desktop {

/// Shows the task of a trial over a canvas: the line with its start and direction, the walls of a
/// tunnel, the model of a copy, or targets. Everything is multiplied with the colours of the
/// canvas, so that ink appears above it. Passes all events of the pointer to the canvas.
class ShapeView : public QWidget {
  Q_OBJECT

 public:
  explicit ShapeView(Canvas& canvas);

  /// Shows the task of a trial. `files` must outlive this object or the next call.
  void set_trial(const StudyFiles& files, const PlannedTrial& trial);
  /// Call it when the participant begins to draw: hides everything, including the ink, if the
  /// condition has no vision.
  void begin_drawing();

  bool eventFilter(QObject* watched, QEvent* event) override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void render();
  void paint_path(QPainter& painter, const StudyPath& path, double width_mm) const;
  void paint_erased(QPainter& painter) const;
  void paint_tunnel(QPainter& painter, const StudyPath& path, double width_mm) const;
  void paint_targets(QPainter& painter, const StudyPath& path, double width_mm) const;
  void paint_start(QPainter& painter, const StudyPath& path, bool has_arrow) const;
  [[nodiscard]] QPolygonF on_screen(const StudyPath& path) const;

  Canvas& canvas_;
  const StudyFiles* files_ = nullptr;
  PlannedTrial trial_;
  QPixmap picture_;
  bool is_blank_ = false;
};

}  // namespace felt::desktop
