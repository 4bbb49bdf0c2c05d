#include "desktop/pens/touch_tap.h"

#include <gtest/gtest.h>

#include <QTest>
#include <vector>

#include "felt/base/constants.h"

namespace felt::desktop::touch_tap_test {
namespace {

/// Taps with several fingers that land and are lifted one after the other, without a movement.
class TouchTapTest : public ::testing::Test {
 protected:
  /// Returns what the tap is recognised as.
  std::optional<int> tap(int fingers, std::int64_t duration_ns) {
    std::optional<int> found;
    for (int i = 0; i < fingers; ++i) take(i == 0 ? QEvent::TouchBegin : QEvent::TouchUpdate, i);
    now_ns_ += duration_ns;
    for (int i = 0; i < fingers; ++i) {
      const bool is_last = i == fingers - 1;
      found = take(is_last ? QEvent::TouchEnd : QEvent::TouchUpdate, i);
      EXPECT_TRUE(is_last || !found);
    }
    return found;
  }

 private:
  std::optional<int> take(QEvent::Type type, int finger) {
    static const QPointingDevice* screen = QTest::createTouchDevice();
    const QPointF at = QPointF(100.0 + 60.0 * finger, 100.0);
    const QTouchEvent event(type, screen, Qt::NoModifier,
                            {QEventPoint(finger, QEventPoint::Updated, at, at)});
    return tap_.take(event, now_ns_);
  }

  TouchTap tap_;
  std::int64_t now_ns_ = 0;
};

TEST_F(TouchTapTest, CountsTheFingers) {
  for (const int fingers : {1, 2, 3, 4}) EXPECT_EQ(tap(fingers, 100 * kMs), fingers);
}

TEST_F(TouchTapTest, ALongTouchIsNoTap) {
  EXPECT_EQ(tap(2, TouchTap::kMaxNs), 2);
  EXPECT_EQ(tap(2, TouchTap::kMaxNs + kMs), std::nullopt);
  EXPECT_EQ(tap(2, 0), 2) << "the next one counts";
}

}  // namespace
}  // namespace felt::desktop::touch_tap_test
