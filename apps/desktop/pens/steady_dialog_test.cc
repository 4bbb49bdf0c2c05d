#include "desktop/pens/steady_dialog.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QPushButton>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "desktop/pens/steady_group.h"
#include "desktop/testing/accessible_names.h"

namespace felt::desktop::steady_dialog_test {
namespace {

/// Draws with the mouse in the area: a spiral of this many seconds, shaken by some pixels. If
/// `gap_every_ms` is set, 300 ms are missing at the end of each such time.
void draw_spiral(SpiralArea& area, double seconds, double shake_px, int step_ms = 8,
                 std::optional<int> gap_every_ms = {}) {
  const QPointF middle = QRectF(area.rect()).center();
  const auto send = [&](QEvent::Type type, QPointF at, Qt::MouseButtons buttons, int ms) {
    QMouseEvent event(type, at, area.mapToGlobal(at), Qt::LeftButton, buttons, Qt::NoModifier);
    event.setTimestamp(static_cast<std::uint64_t>(1000 + ms));
    QApplication::sendEvent(&area, &event);
  };
  QPointF at = middle;
  const int end_ms = static_cast<int>(1e3 * seconds);
  for (int ms = 0; ms < end_ms; ms += step_ms) {
    if (gap_every_ms && ms % *gap_every_ms >= *gap_every_ms - 300) continue;
    const double s = 1e-3 * ms, a = 2.0 * std::numbers::pi * 0.5 * s;
    at = middle + 12.0 * s * QPointF(std::cos(a), std::sin(a)) +
         QPointF(shake_px * std::sin(2.0 * std::numbers::pi * 5.0 * s), 0.0);
    send(ms == 0 ? QEvent::MouseButtonPress : QEvent::MouseMove, at, Qt::LeftButton, ms);
  }
  send(QEvent::MouseButtonRelease, at, Qt::NoButton, end_ms);
}

/// A device that a user holds and with which they trace a spiral for 10.5 s from the start, with a
/// hand that shakes by 1 mm, five times a second. Then the device hovers.
class SpiralPen final : public DriverDevice {
 public:
  SpiralPen() { descriptor_.label = "Spiral"; }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override { return {}; }
  [[nodiscard]] std::string_view name() const noexcept override { return "spiral"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    const double s = 1e-9 * static_cast<double>(now_ns), turn = std::numbers::pi * s;
    const double x_mm = 150.0 + 3.0 * s * std::cos(turn) + std::sin(10.0 * std::numbers::pi * s);
    const double y_mm = 100.0 + 3.0 * s * std::sin(turn);
    return PenSample{now_ns, {x_mm, y_mm, s < 10.5 ? -0.25 : 5.0}, {}, {}, 0};
  }
  tl::expected<void, DeviceFault> write(const Force&) noexcept override { return {}; }
  void stop() noexcept override {}

 private:
  DeviceDescriptor descriptor_;
};

QPushButton* button(QWidget& widget, const QString& text) {
  for (QPushButton* b : widget.findChildren<QPushButton*>()) {
    if (b->text().remove(QLatin1Char('&')) == text) return b;
  }
  return nullptr;
}

TEST(SteadyDialog, ASpiralSetsTheSteadyHand) {
  Studio studio({});
  SteadyDialog dialog(studio);
  dialog.resize(500, 600);
  dialog.show();
  ASSERT_FALSE(button(dialog, QStringLiteral("Use"))->isEnabled());
  draw_spiral(dialog.area(), 10.0, 5.0);
  ASSERT_TRUE(dialog.found()) << dialog.sentence().toStdString();
  EXPECT_NEAR(dialog.found()->hz, 5.0, 0.4);
  EXPECT_EQ(studio.session().option("pencil.steady"), OptionValue(false)) << "nothing is set yet";
  button(dialog, QStringLiteral("Use"))->click();
  EXPECT_EQ(studio.session().option("pencil.steady"), OptionValue(true));
  EXPECT_EQ(shake_of(studio.session()), *dialog.found());
}

TEST(SteadyDialog, ADeviceThatIsHeldTracesTheSpiralAndDoesNotDraw) {
  PenDeviceInfo info;
  info.id = QStringLiteral("spiral:1");
  info.label = info.note = QStringLiteral("Spiral");
  const int driver = add_pen_driver(
      {[info] { return std::vector{info}; },
       [](const QString&, const DeviceSetup& setup) -> Result<std::unique_ptr<OpenDevice>> {
         return std::make_unique<OpenDevice>(std::make_unique<SpiralPen>(), PlaneCalibration(),
                                             setup);
       }});
  StudioOptions options;
  options.live = false;
  Studio studio(options);
  ASSERT_TRUE(studio.use_device(info.id));
  constexpr std::int64_t kSecondNs = 1'000'000'000;
  {
    SteadyDialog dialog(studio);
    dialog.resize(500, 600);
    dialog.show();
    studio.advance(5 * kSecondNs);
    EXPECT_FALSE(dialog.area().samples().empty());
    EXPECT_FALSE(dialog.found()) << "the pen is still down";
    studio.advance(7 * kSecondNs);
    ASSERT_TRUE(dialog.found()) << dialog.sentence().toStdString();
    EXPECT_NEAR(dialog.found()->hz, 5.0, 0.4);
    EXPECT_NEAR(dialog.found()->amplitude_mm, 1.0, 0.3);
  }
  EXPECT_EQ(studio.session().document().stroke_count(), 0U);
  ASSERT_TRUE(studio.use_device(QString::fromLatin1(kPenDeviceDefault)));
  remove_pen_driver(driver);
}

/// A touch that began in the dialog draws nothing after the dialog was closed, until it ends.
TEST(SteadyDialog, ATouchThatBeganInTheDialogDrawsNothingAfterIt) {
  StudioOptions options;
  options.live = false;
  Studio studio(options);
  const auto draw = [&studio](bool lifts) {
    for (int i = 0; i < 50; ++i) {
      studio.point({studio.now_ns(), {30.0 + i, 40.0}, true, 0.5});
      studio.advance(10'000'000);
    }
    if (!lifts) return;
    studio.point({studio.now_ns(), {80.0, 40.0}, false, 0.0});
    studio.advance(50'000'000);
  };
  draw(false);
  {
    SteadyDialog dialog(studio);
    EXPECT_EQ(studio.session().document().stroke_count(), 1U) << "the line so far stays";
    draw(false);
  }
  draw(true);
  EXPECT_EQ(studio.session().document().stroke_count(), 1U);
  draw(true);
  EXPECT_EQ(studio.session().document().stroke_count(), 2U);
}

TEST(SteadyDialog, SaysWhyItFindsNothing) {
  Studio studio({});
  SteadyDialog dialog(studio);
  dialog.resize(500, 600);
  dialog.show();
  draw_spiral(dialog.area(), 2.0, 5.0);
  EXPECT_TRUE(dialog.sentence().startsWith(QStringLiteral("That was too short")));
  button(dialog, QStringLiteral("Start again"))->click();
  EXPECT_TRUE(dialog.sentence().isEmpty());
  draw_spiral(dialog.area(), 10.0, 0.0);
  EXPECT_TRUE(dialog.sentence().startsWith(QStringLiteral("No shaking")));
  button(dialog, QStringLiteral("Start again"))->click();
  draw_spiral(dialog.area(), 10.0, 5.0, 60);
  EXPECT_TRUE(dialog.sentence().startsWith(QStringLiteral("This pen reports")));
  EXPECT_FALSE(dialog.found());
  EXPECT_FALSE(button(dialog, QStringLiteral("Use"))->isEnabled());
}

// Traced for ten seconds without lifting, while the computer was late again and again.
TEST(SteadyDialog, SaysThatTheComputerWasBusyIfThereAreGaps) {
  Studio studio({});
  SteadyDialog dialog(studio);
  dialog.resize(500, 600);
  dialog.show();
  draw_spiral(dialog.area(), 10.0, 5.0, 8, 1500);
  EXPECT_TRUE(dialog.sentence().startsWith(QStringLiteral("The computer was too busy")))
      << dialog.sentence().toStdString();
  EXPECT_FALSE(dialog.found());
  button(dialog, QStringLiteral("Start again"))->click();
  draw_spiral(dialog.area(), 2.0, 5.0, 8, 1500);
  EXPECT_TRUE(dialog.sentence().startsWith(QStringLiteral("That was too short")));
  button(dialog, QStringLiteral("Start again"))->click();
  draw_spiral(dialog.area(), 12.0, 5.0, 8, 5000);
  EXPECT_TRUE(dialog.found()) << "two gaps leave enough";
}

TEST(SteadyDialog, EveryControlHasAName) {
  Studio studio({});
  SteadyDialog dialog(studio);
  SteadyGroup group(studio);
  EXPECT_EQ(nameless_controls(dialog), QStringList());
  EXPECT_EQ(nameless_controls(group), QStringList());
}

TEST(SteadyGroup, ShowsAndSetsTheOption) {
  Studio studio({});
  SteadyGroup group(studio);
  auto* box = group.findChild<QCheckBox*>();
  ASSERT_TRUE(box);
  EXPECT_FALSE(box->isChecked());
  box->click();
  EXPECT_EQ(studio.session().option("pencil.steady"), OptionValue(true));
  studio.apply(SetOption{"pencil.steady", false});
  EXPECT_FALSE(box->isChecked());
}

}  // namespace
}  // namespace felt::desktop::steady_dialog_test
