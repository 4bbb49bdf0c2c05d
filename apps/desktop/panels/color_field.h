#pragma once

#include <QColor>
#include <QWidget>

namespace felt::desktop {

/// A field with all shades of one hue: saturation increases to the right, brightness upwards.
/// Mouse or arrow keys choose a shade (Shift: larger steps).
class ShadeField : public QWidget {
  Q_OBJECT

 public:
  explicit ShadeField(QWidget* parent = nullptr);

  /// Sets the colour; each value is 0..1.
  void show_shade(double hue, double saturation, double brightness);
  [[nodiscard]] QSize sizeHint() const override { return {200, 140}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {80, 80}; }

 Q_SIGNALS:
  void chosen(double saturation, double brightness);
  /// The user has released the mouse, or has pressed a key.
  void settled();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void take(QPointF at);
  void choose(double saturation, double brightness);

  double hue_ = 0.0;
  double saturation_ = 0.0;
  double brightness_ = 0.0;
};

/// A strip with all hues from top to bottom. Mouse or arrow keys choose a hue, as in ShadeField.
class HueStrip : public QWidget {
  Q_OBJECT

 public:
  explicit HueStrip(QWidget* parent = nullptr);

  void show_hue(double hue);
  [[nodiscard]] QSize sizeHint() const override { return {20, 140}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {20, 80}; }

 Q_SIGNALS:
  void chosen(double hue);
  /// The user has released the mouse, or has pressed a key.
  void settled();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void choose(double hue);

  double hue_ = 0.0;
};

/// A ShadeField and a HueStrip side by side, with which the user can choose any colour. If the user
/// chooses grey or black, which have no hue, the HueStrip does not change.
class ColorField : public QWidget {
  Q_OBJECT

 public:
  explicit ColorField(QWidget* parent = nullptr);

  /// Sets the colour; ignores the alpha of the colour.
  void show_color(const QColor& color);
  [[nodiscard]] QColor color() const;

 Q_SIGNALS:
  void chosen(const QColor& color);
  /// The colour is chosen: the user has released the mouse, or has pressed a key.
  void settled();

 private:
  void show_all();

  ShadeField* shade_;
  HueStrip* strip_;
  double hue_ = 0.0;
  double saturation_ = 0.0;
  double brightness_ = 0.0;
};

}  // namespace felt::desktop
