#include "desktop/window/theme.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <algorithm>

#include "desktop/engine/settings.h"
#include "desktop/window/window_setting_keys.h"

namespace felt::desktop {
namespace {

constexpr int kRowPx = 6;
constexpr int kGripDots = 5;

/// The Fusion style with a clearly visible focus ring.
class DeskStyle final : public QProxyStyle {
 public:
  /// Returns true if the panel is one of several tabs. Its tab then shows its name.
  static bool is_tabbed(const QWidget* widget) {
    const auto* dock = qobject_cast<const QDockWidget*>(widget);
    const auto* window = dock ? qobject_cast<const QMainWindow*>(dock->parentWidget()) : nullptr;
    if (!window || dock->isFloating()) return false;
    const auto others = window->tabifiedDockWidgets(const_cast<QDockWidget*>(dock));
    return std::any_of(others.begin(), others.end(),
                       [](const QDockWidget* other) { return !other->isHidden(); });
  }

  /// Draws the grip for dragging.
  static void draw_grip(const QStyleOption& option, QPainter& painter) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(option.palette.color(QPalette::PlaceholderText));
    for (int i = 0; i < kGripDots; ++i) {
      painter.drawEllipse(QPointF(option.rect.left() + 8 + 5 * i, option.rect.center().y() + 1), 1,
                          1);
    }
    painter.restore();
  }

  static bool is_dark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < 128;
  }

  /// Draws the border of a check box or radio button. Fusion's own border is darker than the
  /// window, so that an empty box cannot be seen on a dark one.
  static void draw_indicator_border(PrimitiveElement element, const QStyleOption& option,
                                    QPainter& painter) {
    const bool is_round = element == PE_IndicatorRadioButton;
    if (element != PE_IndicatorCheckBox && !is_round) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(option.palette.color(QPalette::PlaceholderText), 1.0));
    painter.setBrush(Qt::NoBrush);
    const QRectF box = QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5);
    const double radius = is_round ? 0.5 * box.width() : 2.0;
    painter.drawRoundedRect(box, radius, radius);
    painter.restore();
  }

  DeskStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    if (element != PE_FrameFocusRect) {
      QProxyStyle::drawPrimitive(element, option, painter, widget);
      if (is_dark(option->palette)) draw_indicator_border(element, *option, *painter);
      return;
    }
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(option->palette.color(QPalette::Highlight), 2.0));
    painter->setBrush(Qt::NoBrush);
    painter->drawRoundedRect(QRectF(option->rect).adjusted(1, 1, -1, -1), 3, 3);
    painter->restore();
  }

  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override {
    if (element == CE_DockWidgetTitle && is_tabbed(widget)) return draw_grip(*option, *painter);
    if (element != CE_ToolBar) return QProxyStyle::drawControl(element, option, painter, widget);
    painter->fillRect(option->rect, option->palette.color(QPalette::Window));
  }

  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override {
    QSize needed = QProxyStyle::sizeFromContents(type, option, size, widget);
    // Rows are high enough to hit with a pen.
    if (type == CT_ItemViewItem) needed.rheight() += kRowPx;
    return needed;
  }

  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    // A tool tip that appears whenever the pen rests would hide the drawing.
    if (hint == SH_ToolTip_WakeUpDelay) return 900;
    return QProxyStyle::styleHint(hint, option, widget, data);
  }
};

struct Colors {
  QRgb window, base, alternate, button, text, dim, accent, on_accent, link, tip, tip_text, mid;
};

constexpr Colors kLight{0xfff3f3f1, 0xffffffff, 0xfff7f7f5, 0xfffafaf8, 0xff23262d, 0xff666a72,
                        0xff2a62a8, 0xffffffff, 0xff1f559b, 0xff2b2e35, 0xfff5f5f3, 0xffcfcfcb};
constexpr Colors kDark{0xff2a2c30, 0xff1f2124, 0xff25272b, 0xff35383d, 0xffe6e6e3, 0xffa3a7ae,
                       0xff4f8fd8, 0xff10141a, 0xff86b6f0, 0xffe6e6e3, 0xff23262d, 0xff17181b};

QPalette make_palette(const Colors& c) {
  QPalette p;
  const auto set = [&p](QPalette::ColorRole role, QRgb color) { p.setColor(role, QColor(color)); };
  set(QPalette::Window, c.window);
  set(QPalette::WindowText, c.text);
  set(QPalette::Base, c.base);
  set(QPalette::AlternateBase, c.alternate);
  set(QPalette::Text, c.text);
  set(QPalette::PlaceholderText, c.dim);
  set(QPalette::Button, c.button);
  set(QPalette::ButtonText, c.text);
  set(QPalette::BrightText, c.on_accent);
  set(QPalette::Highlight, c.accent);
  set(QPalette::HighlightedText, c.on_accent);
  set(QPalette::Link, c.link);
  set(QPalette::LinkVisited, c.link);
  set(QPalette::ToolTipBase, c.tip);
  set(QPalette::ToolTipText, c.tip_text);
  set(QPalette::Mid, c.mid);
  const QColor button(c.button);
  p.setColor(QPalette::Light, button.lighter(120));
  p.setColor(QPalette::Midlight, button.lighter(108));
  p.setColor(QPalette::Dark, button.darker(160));
  p.setColor(QPalette::Shadow, QColor(0, 0, 0, 120));
  const QColor off =
      QColor::fromRgb((qRed(c.text) + qRed(c.window)) / 2, (qGreen(c.text) + qGreen(c.window)) / 2,
                      (qBlue(c.text) + qBlue(c.window)) / 2);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    p.setColor(QPalette::Disabled, role, off);
  }
  p.setColor(QPalette::Disabled, QPalette::Highlight, QColor(c.mid));
  p.setColor(QPalette::Disabled, QPalette::HighlightedText, off);
  return p;
}

/// Returns whether the desktop was dark before the program set a palette.
bool desktop_is_dark() {
  static const bool is_dark = QApplication::palette().color(QPalette::Window).lightness() < 128;
  return is_dark;
}

}  // namespace

Theme theme_of(const QString& name) {
  if (name == QStringLiteral("light")) return Theme::kLight;
  if (name == QStringLiteral("dark")) return Theme::kDark;
  return Theme::kSystem;
}

QPalette palette_of(Theme theme) {
  const bool is_dark = theme == Theme::kDark || (theme == Theme::kSystem && desktop_is_dark());
  return make_palette(is_dark ? kDark : kLight);
}

void apply_theme(Theme theme) {
  static_cast<void>(desktop_is_dark());
  if (!dynamic_cast<DeskStyle*>(QApplication::style())) QApplication::setStyle(new DeskStyle);
  QApplication::setPalette(palette_of(theme));
}

void follow_theme_setting() {
  const auto apply = [] { apply_theme(theme_of(Settings::the().text(window_keys::kTheme))); };
  apply();
  QObject::connect(&Settings::the(), &Settings::changed, qApp, [apply](const QString& key) {
    if (key == window_keys::kTheme) apply();
  });
}

}  // namespace felt::desktop
