#pragma once

#include <QButtonGroup>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "desktop/solid/body_tool.h"
#include "desktop/solid/solid_scene.h"
#include "felt/document/body_edit.h"
#include "felt/solid/body_edits.h"

namespace felt::desktop {

/// The tools of the solid view: a row of exclusive buttons (Turn, Cut, Extrude, Paint, Smooth), the
/// width of the brush, and a hint below. Strokes that the user draws over the scene become edits of
/// the body. An extrusion takes two strokes: after the closed line, the user turns the body and
/// draws the profile.
class BodyTools : public QWidget {
  Q_OBJECT

 public:
  /// `color` returns the colour of the paint. `scene` must outlive this widget.
  BodyTools(SolidScene& scene, std::function<Rgba()> color, QWidget* parent = nullptr);

  [[nodiscard]] BodyTool tool() const noexcept { return tool_; }
  void set_tool(BodyTool tool);
  /// Removes the strokes that are shown, and ends an extrusion that has no profile yet.
  void forget_strokes();
  /// Refuses new strokes with this sentence, while an edit is tried; an empty one accepts them.
  void refuse_strokes(const QString& why) { refusal_ = why; }
  /// Shows why an edit was refused, until the next stroke or tool.
  void show_refusal(const QString& why);

 Q_SIGNALS:
  /// The user has drawn an edit. Its strokes stay visible until forget_strokes().
  void edit_wanted(const felt::BodyEdit& edit);

 private:
  void make_buttons();
  void show_hint();
  void stroke_drawn(const std::vector<QPointF>& px);
  void begin_extrusion(BodyEdit edit, const std::vector<QPointF>& px);
  void end_extrusion(const std::vector<QPointF>& px);

  /// A closed line that waits for its profile.
  struct Extrusion {
    BodyEdit edit;
    ExtrusionRing ring;
  };

  SolidScene& scene_;
  std::function<Rgba()> color_;
  QButtonGroup* group_;
  QDoubleSpinBox* width_;
  QLabel* hint_;
  BodyTool tool_ = BodyTool::kTurn;
  double paint_mm_ = 2.0, smooth_mm_ = 15.0;
  std::optional<Extrusion> extrusion_;
  QString refusal_;  // of new strokes
};

}  // namespace felt::desktop
