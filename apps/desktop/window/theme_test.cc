#include "desktop/window/theme.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionButton>
#include <cmath>
#include <string>

#include "desktop/engine/settings.h"
#include "desktop/engine/studio.h"
#include "desktop/window/color_well.h"
#include "desktop/window/window_setting_keys.h"

namespace felt::desktop::theme_test {
namespace {

/// Returns the relative luminance of a colour as defined by WCAG 2.1.
double luminance(const QColor& color) {
  const auto linear = [](float part) {
    const double c = double(part);
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

TEST(Theme, ContrastIsThatOfWcag) {
  EXPECT_NEAR(contrast(Qt::black, Qt::white), 21.0, 1e-9);
  EXPECT_NEAR(contrast(QColor(0x76, 0x76, 0x76), Qt::white), 4.54, 0.01);
}

TEST(Theme, EmptyBoxesAreSeenInBothThemes) {
  for (const Theme theme : {Theme::kLight, Theme::kDark}) {
    apply_theme(theme);
    for (const auto element : {QStyle::PE_IndicatorCheckBox, QStyle::PE_IndicatorRadioButton}) {
      QStyleOptionButton option;
      option.palette = palette_of(theme);
      option.rect = {4, 4, 14, 14};
      option.state = QStyle::State_Enabled | QStyle::State_Off;
      const QColor window = option.palette.color(QPalette::Window);
      QImage image(22, 22, QImage::Format_RGB32);
      image.fill(window);
      QPainter painter(&image);
      QApplication::style()->drawPrimitive(element, &option, &painter, nullptr);
      painter.end();
      double best = 1.0;
      for (int x = 3; x < 8; ++x) {
        best = std::max(best, contrast(image.pixelColor(x, 11), window));
      }
      EXPECT_GE(best, theme == Theme::kDark ? 3.0 : 1.2) << int(theme) << ", " << element;
    }
  }
  apply_theme(Theme::kSystem);
}

TEST(Theme, TextCanBeReadInBothThemes) {
  using P = QPalette;
  const std::pair<P::ColorRole, P::ColorRole> pairs[] = {{P::WindowText, P::Window},
                                                         {P::Text, P::Base},
                                                         {P::Text, P::AlternateBase},
                                                         {P::ButtonText, P::Button},
                                                         {P::HighlightedText, P::Highlight},
                                                         {P::ToolTipText, P::ToolTipBase},
                                                         {P::PlaceholderText, P::Base},
                                                         {P::PlaceholderText, P::Window},
                                                         {P::Link, P::Base},
                                                         {P::Link, P::Window},
                                                         {P::WindowText, P::Mid}};
  for (const Theme theme : {Theme::kLight, Theme::kDark, Theme::kSystem}) {
    const QPalette palette = palette_of(theme);
    for (const auto& [front, back] : pairs) {
      for (const P::ColorGroup group : {P::Active, P::Inactive}) {
        EXPECT_GE(contrast(palette.color(group, front), palette.color(group, back)), 4.5)
            << int(theme) << ": role " << front << " on " << back;
      }
    }
    // The focus must be visible: 3 : 1 (WCAG 2.1, 1.4.11).
    EXPECT_GE(contrast(palette.color(P::Highlight), palette.color(P::Window)), 3.0);
  }
}

TEST(ColorWell, ItsBorderIsSeenInBothThemes) {
  Studio studio({.live = false});
  for (const Theme theme : {Theme::kLight, Theme::kDark}) {
    ColorWell well(studio);
    well.setPalette(palette_of(theme));
    for (const char* ink : {"#000000", "#ffffff"}) {
      studio.apply(SetOption{"ink.color", std::string(ink)});
      const QImage picture = well.icon().pixmap(well.iconSize()).toImage();
      EXPECT_GE(contrast(picture.pixelColor(0, 0), well.palette().color(QPalette::Window)), 2.0)
          << int(theme) << ", " << ink;
    }
  }
}

TEST(Theme, TheSettingCountsAtOnce) {
  follow_theme_setting();
  Settings::the().set(window_keys::kTheme, QStringLiteral("dark"));
  EXPECT_LT(QApplication::palette().color(QPalette::Window).lightness(), 100);
  Settings::the().set(window_keys::kTheme, QStringLiteral("light"));
  EXPECT_GT(QApplication::palette().color(QPalette::Window).lightness(), 200);
  Settings::the().reset(window_keys::kTheme);
}

}  // namespace
}  // namespace felt::desktop::theme_test
