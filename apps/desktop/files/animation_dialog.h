#pragma once

#include <QDialog>

#include "desktop/files/animation_file.h"

class QComboBox;
class QSpinBox;

namespace felt::desktop {

/// Asks how to export the film of the key drawings. The choices are stored in the settings.
class AnimationDialog : public QDialog {
  Q_OBJECT

 public:
  explicit AnimationDialog(QWidget* parent);

  /// Returns a request with the choices, without key drawings and film options.
  [[nodiscard]] AnimationRequest request() const;
  void accept() override;

 private:
  QComboBox* format_;
  QSpinBox* size_;
};

/// Returns the file extension of the format: ".svg".
QString suffix_of(AnimationFormat format);
/// Returns the filter of the format for file dialogs.
QString filter_of(AnimationFormat format);

}  // namespace felt::desktop
