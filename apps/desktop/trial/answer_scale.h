#pragma once

#include <QWidget>
#include <optional>

namespace felt::desktop {

/// A scale with marks at equal distances, of which the user chooses one. Initially none is chosen,
/// because a preset answer would influence the user. Mouse or pen choose the nearest mark; the keys
/// Left, Right, Home and End move the choice.
class AnswerScale : public QWidget {
  Q_OBJECT

 public:
  /// How the marks look: lines on a line, or circles.
  enum class Look { kLines, kCircles };

  AnswerScale(int marks, Look look, QWidget* parent = nullptr);

  /// Returns the index of the chosen mark, from 0; nullopt if none is chosen.
  [[nodiscard]] std::optional<int> choice() const noexcept { return choice_; }
  void choose(int mark);
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  void chosen();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] double x_of(int mark) const;
  void choose_at(double x);

  int marks_;
  Look look_;
  std::optional<int> choice_;
};

}  // namespace felt::desktop
