#pragma once

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <atomic>
#include <memory>
#include <optional>

#include "desktop/engine/studio.h"
#include "desktop/files/file_worker.h"
#include "desktop/solid/body_tools.h"
#include "desktop/solid/solid_job.h"
#include "desktop/solid/solid_scene.h"

namespace felt::desktop {

/// The solid view: the closed lines of the drawing as bodies (inflate.h), with the controls for
/// making and showing them. While it is on, it follows every edit: the bodies are made on another
/// thread when the drawing has not changed for kWaitMs and the pen is up. Until then, the previous
/// bodies stay.
///
/// An edit that the user draws on a body (BodyTools) is first applied on that thread. If it fits,
/// it becomes part of the drawing, as one step of undo; otherwise, a sentence says why not.
class SolidPanel : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kWaitMs = 100;
  /// Bodies that take longer to make are announced.
  static constexpr int kAnnounceMs = 400;

  explicit SolidPanel(Studio& studio, QWidget* parent = nullptr);
  /// Waits for the step of the job that runs.
  ~SolidPanel() override;

  /// Starts or stops following the drawing.
  void set_on(bool on);
  /// Returns true if the bodies are those of the present drawing and options.
  [[nodiscard]] bool is_up_to_date() const noexcept { return !waits_ && !runs_; }
  [[nodiscard]] SolidScene& scene() noexcept { return *scene_; }
  /// Returns the bodies that are shown, or null. They never change: an edit replaces them.
  [[nodiscard]] const std::shared_ptr<const Solid>& solid() const noexcept {
    return scene_->solid();
  }
  /// Returns the ink on the bodies that are shown, or null.
  [[nodiscard]] const std::shared_ptr<const FrontPaint>& paint() const noexcept { return paint_; }
  /// Shows a pen that touches a body, or removes it (SolidScene::show_proxy).
  void show_proxy(const std::optional<SolidTouchMarks>& marks) { scene_->show_proxy(marks); }
  [[nodiscard]] BodyTools& tools() noexcept { return *tools_; }
  /// Adds a button for the action that lets the pen touch the bodies. Call it once.
  void set_touch_action(QAction* action);
  /// Sets the actions of the button "Export".
  void set_export_actions(const QList<QAction*>& actions);

 Q_SIGNALS:
  /// solid() is another one.
  void solid_changed();

 private:
  void make_controls();
  QWidget* gap_row();
  QWidget* look_rows();
  [[nodiscard]] SolidRequest request() const;
  void wait();
  void start();
  void take(const SolidAnswer& answer, int asked);
  void forget();
  void forget_edit();
  void follow();
  void show_answer(const SolidAnswer& answer);
  void try_edit(const BodyEdit& edit);
  void end_edit(const SolidAnswer& answer, bool is_current);
  void show_gap(double gap_mm);
  void set_gap(double gap_mm);

  Studio& studio_;
  std::shared_ptr<const FrontPaint> paint_;
  SolidScene* scene_;
  BodyTools* tools_;
  QLabel* summary_;
  QPushButton* offer_;
  QSlider* gap_;
  QLabel* gap_text_;
  QCheckBox* automatic_;
  QCheckBox* fill_holes_;
  QCheckBox* wireframe_;
  QCheckBox* section_;
  QSlider* section_at_;
  QHBoxLayout* buttons_;  // "Touch the solid", "Export"
  QToolButton* export_;
  QTimer delay_, announce_;
  bool is_on_ = false;
  int session_ = 0;     // a job from before the last change of this number is not shown
  bool waits_ = false;  // the drawing changed since the bodies were begun
  bool runs_ = false;
  double offered_mm_ = 0.0;
  std::optional<BodyEdit> new_edit_;       // drawn, and not yet part of the drawing
  bool adds_edit_ = false;                 // the edit that was tried becomes part of the drawing
  std::atomic<bool> is_cancelled_{false};  // must outlive worker_
  std::unique_ptr<FileWorker> worker_;     // null before the first bodies
};

}  // namespace felt::desktop
