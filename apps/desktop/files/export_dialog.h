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

namespace felt::desktop {

/// How the drawing is exported, with a small picture and the size of what comes out. Remembers
/// what was chosen.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  ExportDialog(const Drawing& drawing, QWidget* parent);

  [[nodiscard]] ExportOptions options() const;
  void accept() override;

 private:
  void follow_choices();
  void show_result();

  std::vector<StrokePtr> strokes_;
  SheetPage page_;
  std::optional<Grain> sheet_grain_;  // none: the sheet is not known here
  QComboBox* format_;
  QComboBox* area_;
  QDoubleSpinBox* dpi_;
  QCheckBox* background_;
  QCheckBox* grain_;
  QLabel* picture_;
  QLabel* size_;
  QLabel* kept_;
  QFormLayout* form_;
};

}  // namespace felt::desktop
