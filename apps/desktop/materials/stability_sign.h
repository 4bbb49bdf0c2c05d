#pragma once

#include <QLabel>
#include <QWidget>

#include "desktop/materials/stability_words.h"

namespace felt::desktop {

/// Shows whether the device in use can render the material. It shows a sign with a different shape
/// and colour for each level (a check mark, a triangle, a stop sign), a word, a number, and the
/// deviations.
class StabilitySign : public QWidget {
  Q_OBJECT

 public:
  explicit StabilitySign(QWidget* parent = nullptr);

  void show_words(const StabilityWords& words);
  [[nodiscard]] StabilityLevel level() const noexcept { return words_.level; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void draw_sign();

  StabilityWords words_;
  QLabel* sign_;
  QLabel* state_;
  QLabel* number_;
  QLabel* detail_;
};

}  // namespace felt::desktop
