#pragma once

#include <QDialog>
#include <vector>

#include "desktop/files/recovery_offer.h"

class QVBoxLayout;

namespace felt::desktop {

/// Offers drawings that a crash left behind. Shows each drawing next to the user's saved file. For
/// both it shows a picture, the time of the last change and the number of lines. The user can
/// recover a drawing as a new drawing, open the saved file instead, or discard the drawing after a
/// confirmation. If the user closes the dialog, the next start asks again.
class RecoveryDialog : public QDialog {
  Q_OBJECT

 public:
  RecoveryDialog(std::vector<RecoveryOffer> offers, QWidget* parent);

  /// Returns the drawing that the user chose. The caller may move the autosave out of the returned
  /// object.
  [[nodiscard]] RecoveryOffer& chosen() noexcept { return offers_[chosen_]; }

 Q_SIGNALS:
  /// Emitted when the user wants to recover chosen().
  void recover_wanted();
  /// Emitted when the user wants to open the saved file; the autosave is kept.
  void open_wanted(const QString& path);

 private:
  QWidget* make_row(std::size_t i);
  QWidget* make_keys(std::size_t i, QWidget* row);
  void discard(std::size_t i, QWidget* row);

  std::vector<RecoveryOffer> offers_;
  std::size_t chosen_ = 0;
  std::size_t left_ = 0;
};

}  // namespace felt::desktop
