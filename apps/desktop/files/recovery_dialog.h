#pragma once

#include <QDialog>
#include <vector>

#include "desktop/files/recovery.h"

class QVBoxLayout;

namespace felt::desktop {

/// Offers drawings that a crash left behind: a small picture, when it was and how many lines, and
/// for each Recover and Discard. Closing it is "later": the next start asks again.
class RecoveryDialog : public QDialog {
  Q_OBJECT

 public:
  struct Offer {
    AbandonedFolder folder;
    Recovered recovered;
  };

  RecoveryDialog(std::vector<Offer> offers, QWidget* parent);

  /// The one that was asked for; its folder is the caller's then.
  [[nodiscard]] Offer& chosen() noexcept { return offers_[chosen_]; }

 Q_SIGNALS:
  /// Recover: chosen() has it.
  void recover_wanted();

 private:
  void add_row(std::size_t i, QVBoxLayout& rows);
  void discard(std::size_t i, QWidget* row);

  std::vector<Offer> offers_;
  std::size_t chosen_ = 0;
  std::size_t left_ = 0;
};

}  // namespace felt::desktop
