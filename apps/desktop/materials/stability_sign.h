#pragma once

#include <QLabel>
#include <QWidget>

#include "desktop/materials/stability_words.h"

namespace felt::desktop {

/// Whether the device in use can give what the material wishes: a sign that is told by its shape (a
/// check mark, a triangle, a stop sign) as well as by its colour, a word, a number, and what is not
/// as wished.
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
