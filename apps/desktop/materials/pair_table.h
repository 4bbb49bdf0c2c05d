#pragma once

#include <QTableWidget>
#include <QToolButton>
#include <QWidget>
#include <optional>
#include <string>

#include "felt/material/materials.h"

namespace felt::desktop {

/// Shows the friction of a medium on each surface. By default it is the product of the medium's and
/// the surface's friction; a separate number for a pair is shown in bold. The user sets a separate
/// number by typing it, and removes it with the button.
class PairTable : public QWidget {
  Q_OBJECT

 public:
  explicit PairTable(QWidget* parent = nullptr);

  void show_pairs(const Medium& medium, const Materials& known);

 Q_SIGNALS:
  void chosen(const std::string& surface, std::optional<double> friction);

 private:
  void report_button();
  [[nodiscard]] std::string surface_of(int row) const;

  QTableWidget* table_;
  QToolButton* rule_;
};

}  // namespace felt::desktop
