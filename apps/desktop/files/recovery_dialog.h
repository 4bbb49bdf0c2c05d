#pragma once

#include <QDialog>
#include <vector>

#include "desktop/files/recovery_offer.h"

class QVBoxLayout;

namespace felt::desktop {

/// Offers drawings that a crash left behind, each beside the person's file as it is: a picture of
/// both, when they were changed last, how many lines they have. For each: recover it as a new
/// drawing, open the saved one, or discard it, which asks. Closing the dialog is "later": the next
/// start asks again.
class RecoveryDialog : public QDialog {
  Q_OBJECT

 public:
  RecoveryDialog(std::vector<RecoveryOffer> offers, QWidget* parent);

  /// The one that was asked for; its store is the caller's then.
  [[nodiscard]] RecoveryOffer& chosen() noexcept { return offers_[chosen_]; }

 Q_SIGNALS:
  /// Recover: chosen() has it.
  void recover_wanted();
  /// Open the person's file, and leave the other where it is.
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
