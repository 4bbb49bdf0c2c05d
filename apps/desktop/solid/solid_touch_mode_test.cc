#include "desktop/solid/solid_touch_mode.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <memory>
#include <vector>

#include "desktop/files/testing/studio_fixture.h"
#include "desktop/solid/testing/drawn_lines.h"

namespace felt::desktop::solid_touch_mode_test {
namespace {

constexpr std::int64_t kTickNs = 1'000'000;

StudioOptions recorded(std::vector<Event>& events) {
  StudioOptions options = testing::without_threads();
  options.connect_early = [&events](Studio& studio) {
    QObject::connect(&studio, &Studio::event_applied, &studio,
                     [&events](const Event& event) { events.push_back(event); });
  };
  return options;
}

class SolidTouchModeTest : public ::testing::Test {
 protected:
  void SetUp() override {
    testing::draw_square(studio_, {20, 20}, 60.0);
    panel_.set_on(true);
    ASSERT_TRUE(waits());
    strokes_ = studio_.session().document().stroke_count();
  }
  bool waits() {
    return QTest::qWaitFor([this] { return panel_.is_up_to_date(); }, 20000);
  }
  void hover(Point at) { point(at, false); }
  // Moves the hand with 100 mm/s.
  void point(Point to, bool down) {
    const Point from = at_;
    const int steps = 1 + static_cast<int>(distance(from, to));
    for (int i = 1; i <= steps; ++i) {
      const double share = 1.0 * i / steps;
      at_ = {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
      studio_.point({studio_.now_ns(), at_, down, 0.5});
      studio_.advance(10 * kTickNs);
    }
    studio_.advance(200 * kTickNs);
  }
  [[nodiscard]] double force() const { return norm(studio_.pen().sent); }
  [[nodiscard]] std::string tool() const { return std::string(studio_.session().tool().info().id); }
  [[nodiscard]] QString device() { return studio_.loop().device().info().id; }

  std::vector<Event> events_;
  StudioFixture fixture_{recorded(events_)};
  Studio& studio_ = fixture_.studio;
  SolidPanel panel_{studio_};
  SolidTouchMode touch_{studio_, panel_, fixture_.actions, nullptr};
  QAction* action_ = touch_.action();
  Point at_{5, 5};
  std::size_t strokes_ = 0;
};

TEST_F(SolidTouchModeTest, ThePenFeelsTheBodyAndDrawsNothing) {
  ASSERT_TRUE(action_->isEnabled());
  action_->setChecked(true);
  EXPECT_TRUE(touch_.is_on());
  EXPECT_EQ(device(), QLatin1String(SolidTouchMode::kTouchStylus))
      << "a mouse gets the simulated stylus";
  hover({50, 50});
  EXPECT_LT(force(), 1e-9);
  const double height =
      panel_.solid()->bodies[0].points.empty() ? 0.0 : studio_.pen().sample.position.z;
  EXPECT_GT(height, 10.0) << "the hand hovers above the body";
  point({50, 50}, true);
  EXPECT_GT(studio_.pen().sent.z, 0.2) << "the top pushes back";
  ASSERT_TRUE(studio_.proxy());
  EXPECT_GT(studio_.proxy()->z, studio_.pen().sample.position.z) << "the proxy is in front of it";
  // A flank pushes the pen away from the middle: the cursor lags behind the mouse (pseudo-haptic).
  point({72, 50}, true);
  EXPECT_GT(studio_.pen().sent.x, 0.1);
  EXPECT_GT(studio_.pen().sample.position.x, 72.1);
  hover({5, 5});
  EXPECT_EQ(studio_.session().document().stroke_count(), strokes_);
  for (const Event& event : events_) {
    const auto* pen = std::get_if<PenEvent>(&event.what);
    EXPECT_TRUE(!pen || !in_contact(sample_of(event.time_ns, *pen))) << "recordings draw nothing";
  }
}

TEST_F(SolidTouchModeTest, OffReturnsToTheToolTheDeviceAndTheInk) {
  const QString device_before = device();
  studio_.apply(SelectTool{"pencil"});
  action_->setChecked(true);
  point({50, 50}, true);
  action_->setChecked(false);
  EXPECT_FALSE(touch_.is_on());
  EXPECT_EQ(tool(), "pencil");
  EXPECT_EQ(device(), device_before);
  hover({100, 100});
  point({120, 100}, true);
  hover({120, 100});
  EXPECT_EQ(studio_.session().document().stroke_count(), strokes_ + 1) << "the pencil draws again";
}

TEST_F(SolidTouchModeTest, APenThatIsDownWhenItEndsDrawsOnlyAfterItWasUp) {
  studio_.use_device(QString::fromLatin1(SolidTouchMode::kTouchStylus));
  action_->setChecked(true);
  hover({100, 100});
  point({120, 100}, true);
  ASSERT_LT(studio_.pen().sample.position.z, 0.0) << "beside the body it goes below the page";
  double largest = 0.0;
  const auto shown = QObject::connect(
      &studio_, &Studio::shown, [&] { largest = std::max(largest, norm(studio_.pen().sent)); });
  action_->setChecked(false);
  EXPECT_TRUE(studio_.is_pen_elsewhere());
  point({140, 100}, true);
  QObject::disconnect(shown);
  EXPECT_LT(largest, 0.01) << "the page does not throw out a pen that is below it";
  hover({140, 100});
  EXPECT_FALSE(studio_.is_pen_elsewhere());
  EXPECT_EQ(studio_.session().document().stroke_count(), strokes_);
  EXPECT_EQ(device(), QLatin1String(SolidTouchMode::kTouchStylus)) << "the user's own choice stays";
}

TEST_F(SolidTouchModeTest, FollowsEditsWithoutAJolt) {
  action_->setChecked(true);
  hover({50, 50});
  point({50, 50}, true);
  studio_.advance(500 * kTickNs);
  const double before = force();
  ASSERT_GT(before, 0.2);
  double jolt = 0.0;
  Force last = studio_.pen().sent;
  const auto shown = QObject::connect(&studio_, &Studio::shown, [&] {
    jolt = std::max(jolt, norm(studio_.pen().sent - last));
    last = studio_.pen().sent;
  });
  testing::draw_square(studio_, {120, 20}, 60.0);
  ASSERT_TRUE(waits());
  studio_.advance(500 * kTickNs);
  QObject::disconnect(shown);
  EXPECT_TRUE(touch_.is_on());
  EXPECT_NEAR(force(), before, 0.05);
  EXPECT_LT(jolt, 0.05) << "per 4 ms";
  hover({50, 50});
  hover({150, 50});
  point({150, 50}, true);
  EXPECT_GT(studio_.pen().sent.z, 0.2) << "the new body is felt, too";
}

// The right button is the eraser by default.
TEST_F(SolidTouchModeTest, ABorrowedToolLeavesThePenOnTheBodies) {
  action_->setChecked(true);
  hover({50, 50});
  studio_.borrow_tool(QStringLiteral("eraser"));
  point({20, 50}, true);
  EXPECT_TRUE(touch_.is_on());
  hover({20, 50});
  studio_.give_back_tool();
  EXPECT_TRUE(touch_.is_on());
  EXPECT_EQ(studio_.session().document().stroke_count(), strokes_) << "nothing is erased";
}

TEST_F(SolidTouchModeTest, FollowsTheDevice) {
  action_->setChecked(true);
  EXPECT_TRUE(studio_.use_device(QStringLiteral("simulated:premium")));
  EXPECT_TRUE(touch_.is_on());
  hover({50, 50});
  point({50, 50}, true);
  EXPECT_GT(studio_.pen().sent.z, 0.2);
  hover({50, 50});
  EXPECT_TRUE(studio_.use_device(QStringLiteral("tablet")));
  EXPECT_FALSE(action_->isChecked()) << "the tablet pushes nobody";
  EXPECT_EQ(device(), QLatin1String("tablet")) << "the user's choice stays";
}

/// A device that moves only in the plane, with motors.
class PlanarDevice final : public DriverDevice {
 public:
  explicit PlanarDevice(const Capabilities& capabilities) {
    descriptor_.label = "Planar";
    descriptor_.capabilities = capabilities;
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override { return {}; }
  [[nodiscard]] std::string_view name() const noexcept override { return "planar"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    return PenSample{now_ns, {50, 50, 0.25}, {}, {}, 0};
  }
  tl::expected<void, DeviceFault> write(const Force&) noexcept override { return {}; }
  void stop() noexcept override {}

 private:
  DeviceDescriptor descriptor_;
};

TEST_F(SolidTouchModeTest, ADeviceWithTwoAxesIsRefusedWithASentence) {
  PenDeviceInfo info;
  info.id = QStringLiteral("planar:1");
  info.label = info.note = QStringLiteral("Planar");
  info.capabilities.sensed_axes = info.capabilities.actuated_axes = 2;
  info.capabilities.max_force_n = 3.0;
  const int driver = add_pen_driver(
      {[info] { return std::vector{info}; },
       [info](const QString&, const DeviceSetup& setup) -> Result<std::unique_ptr<OpenDevice>> {
         return std::make_unique<OpenDevice>(std::make_unique<PlanarDevice>(info.capabilities),
                                             PlaneCalibration(), setup);
       }});
  ASSERT_TRUE(studio_.use_device(info.id));
  QSignalSpy refused(&studio_, &Studio::refused);
  action_->setChecked(true);
  EXPECT_FALSE(touch_.is_on());
  EXPECT_FALSE(action_->isChecked());
  ASSERT_EQ(refused.count(), 1);
  EXPECT_TRUE(refused[0][0].toString().contains(QLatin1String("three directions")));
  ASSERT_TRUE(studio_.use_device(QString::fromLatin1(kPenDeviceDefault)));
  remove_pen_driver(driver);
}

TEST_F(SolidTouchModeTest, EndsWithTheLastBodyWithAnotherToolAndWithAnotherDrawing) {
  action_->setChecked(true);
  studio_.apply(SelectTool{"eraser"});
  EXPECT_FALSE(action_->isChecked());
  EXPECT_EQ(tool(), "eraser");
  action_->setChecked(true);
  studio_.apply(UndoEvent{});
  ASSERT_TRUE(waits());
  EXPECT_FALSE(touch_.is_on());
  QSignalSpy refused(&studio_, &Studio::refused);
  action_->setChecked(true);
  EXPECT_FALSE(action_->isChecked());
  EXPECT_EQ(refused.count(), 1) << "and says why";
  studio_.apply(RedoEvent{});
  ASSERT_TRUE(waits());
  action_->setChecked(true);
  EXPECT_TRUE(touch_.is_on());
  studio_.open(Document{}, Page{});
  EXPECT_FALSE(touch_.is_on());
  EXPECT_FALSE(studio_.is_pen_elsewhere());
}

}  // namespace
}  // namespace felt::desktop::solid_touch_mode_test
