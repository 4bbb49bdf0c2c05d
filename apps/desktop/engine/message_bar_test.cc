#include "desktop/engine/message_bar.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>
#include <QToolButton>

namespace felt::desktop::message_bar_test {
namespace {

struct Bar : MessageBar {
  Bar() : Bar(new QLabel) {}
  explicit Bar(QLabel* words)
      : MessageBar(words, QStringLiteral("More"), nullptr), details(words) {}
  using MessageBar::say;

  QLabel* details;
};

TEST(MessageBar, SaysAndKeepsDetailsForWhoAsks) {
  Bar bar;
  EXPECT_TRUE(bar.isHidden());
  bar.say(QStringLiteral("Something happened."), true);
  EXPECT_FALSE(bar.isHidden());
  EXPECT_EQ(bar.accessibleName(), QStringLiteral("Something happened."));
  EXPECT_TRUE(bar.details->isHidden());
  auto* more = bar.findChild<QToolButton*>();
  EXPECT_EQ(more->toolTip(), QStringLiteral("More"));
  more->click();
  EXPECT_FALSE(bar.details->isHidden());
  bar.say(QStringLiteral("Something else."), true);
  EXPECT_TRUE(bar.details->isHidden()) << "these are other details";
  bar.say(QStringLiteral("No more to say."), false);
  EXPECT_TRUE(more->isHidden());
}

TEST(MessageBar, TheCrossAndEscapeCloseItAndItTakesNoFocus) {
  Bar bar;
  bar.say(QStringLiteral("Something happened."), true);
  EXPECT_EQ(bar.focusPolicy(), Qt::NoFocus);
  QTest::keyClick(&bar, Qt::Key_A);
  EXPECT_FALSE(bar.isHidden());
  QTest::keyClick(&bar, Qt::Key_Escape);
  EXPECT_TRUE(bar.isHidden());
  bar.say(QStringLiteral("Again."), false);
  bar.findChildren<QToolButton*>().back()->click();
  EXPECT_TRUE(bar.isHidden());
}

}  // namespace
}  // namespace felt::desktop::message_bar_test
