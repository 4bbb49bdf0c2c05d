#pragma once

#include <QDialog>
#include <optional>

#include "desktop/files/export_file.h"
#include "felt/document/edit.h"
#include "felt/render/grain.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace felt::desktop {

/// Asks how to export the drawing, and shows a small preview and the size of the result. The
/// choices are stored in the settings.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// If lines are selected, the dialog offers to export only these.
  ExportDialog(const Drawing& drawing, const Selection& selection, QWidget* parent);

  [[nodiscard]] ExportOptions options() const;
  void accept() override;

 private:
  void build();
  QWidget* resolution_row();
  void follow_choices();
  void show_result();
  void enable_options(const ExportOptions& chosen);
  void show_size(const ExportOptions& chosen, const Rect& area);
  const Document& shown_document(const ExportOptions& chosen);

  Document document_;  // with the newest strokes, for the preview
  Document selected_;
  std::optional<Result<Document>> swell_document_, swell_selected_;  // the same for swell paper
  Page page_;
  bool has_pictures_ = false;
  Grain solid_grain_;                   // with the styles of the drawing's media
  std::optional<Grain> surface_grain_;  // grain of the drawing's surface; nullopt if the surface is
                                        // unknown
  QComboBox* format_;
  QComboBox* area_;
  QDoubleSpinBox* dpi_;
  QComboBox* scale_;  // the resolution as a factor
  QCheckBox* background_;
  QCheckBox* grain_;
  QCheckBox* compact_;
  QCheckBox* pictures_;
  QCheckBox* swell_;
  QPushButton* go_ = nullptr;
  QLabel* picture_;
  QLabel* size_;
  QLabel* kept_;
  QFormLayout* form_;
};

}  // namespace felt::desktop
