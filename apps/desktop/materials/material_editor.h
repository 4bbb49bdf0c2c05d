#pragma once

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QToolBar>
#include <QWidget>

#include "desktop/feel/force_graph.h"
#include "desktop/feel/force_history.h"
#include "desktop/materials/force_probe.h"
#include "desktop/materials/material_editor_model.h"
#include "desktop/materials/material_fields_view.h"
#include "desktop/materials/material_list.h"
#include "desktop/materials/pair_table.h"
#include "desktop/materials/probe_plot.h"
#include "desktop/materials/shape_row.h"
#include "desktop/materials/stability_sign.h"
#include "desktop/materials/stroke_preview.h"

namespace felt::desktop {

/// The editor of user-defined surfaces and media. It has a list of all materials, and a slider and
/// a number for every value of the selected material. Beside these controls, the editor immediately
/// shows the result of a change: strokes, a plot of the predicted force, whether the device in use
/// can render the material, and the present force. The drawing's window stays usable and draws with
/// the edited material.
class MaterialEditor : public QWidget {
  Q_OBJECT

 public:
  /// Makes a separate window above `parent`. `studio` and `model` must outlive the editor.
  MaterialEditor(Studio& studio, MaterialEditorModel& model, QWidget* parent);

  [[nodiscard]] MaterialList& list() noexcept { return *list_; }
  [[nodiscard]] MaterialFieldsView& fields() noexcept { return *fields_; }
  [[nodiscard]] StabilitySign& stability() noexcept { return *sign_; }
  [[nodiscard]] StrokePreview& preview() noexcept { return *preview_; }
  [[nodiscard]] ForceProbe& probe() noexcept { return probe_; }
  /// Returns the action of "undo", "redo", "revert", "flip", "copy_to_other", "save", "save_as",
  /// "rename", "delete", "import" or "export"; null for any other name.
  [[nodiscard]] QAction* action(const char* name) const;
  /// Returns the text of the line at the bottom: the last error or result.
  [[nodiscard]] QString notice() const { return notice_->text(); }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_actions();
  QAction* add_action(const char* name, const QString& text, const QString& tip,
                      const QList<QKeySequence>& keys, const char* icon, std::function<void()> run);
  QToolBar* make_bar();
  QWidget* make_figures();
  QWidget* make_relief_button();
  QWidget* make_looks();
  void watch();
  void follow_list();
  void follow_desk();
  void tell_names();
  void report_slots();
  [[nodiscard]] QString state_words() const;
  void fill_presets();
  void ask_probe();
  void take_tick(const TickReport& tick);
  [[nodiscard]] ProbeRequest request() const;
  void report(const Result<void>& done, const QString& success);
  void report(const QString& words);
  void ask_relief();
  void ask_save_as();
  void ask_rename();
  void ask_import();
  void ask_export();
  void draw_icons();

  Studio& studio_;
  MaterialEditorModel& model_;
  QList<QAction*> actions_;
  MaterialList* list_;
  QLabel* name_;
  QLabel* state_;
  QComboBox* presets_;
  MaterialFieldsView* fields_;
  PairTable* pairs_;
  ShapeRow* shape_;
  StrokePreview* preview_;
  ProbePlot* plot_;
  StabilitySign* sign_;
  ForceHistory history_;
  ForceGraph* graph_;
  QLabel* notice_;
  QSplitter* parts_;
  QTimer frame_;
  ForceProbe probe_;
};

}  // namespace felt::desktop
