#include "desktop/feel/device_page.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QMainWindow>
#include <QTest>
#include <cmath>

#include "desktop/engine/settings.h"
#include "desktop/feel/calibration_dialog.h"
#include "desktop/feel/feel_actions.h"
#include "desktop/feel/feel_panel.h"
#include "felt/devices/simulated/simulated_stylus.h"

namespace felt::desktop {
namespace {

/// A person's device, with a frame of its own: says where the test has put it.
class FakePen final : public PenDevice, public Device {
 public:
  explicit FakePen(PenDeviceInfo info) : info_(std::move(info)) {}

  [[nodiscard]] const PenDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] Device& device() noexcept override { return *this; }
  [[nodiscard]] HandInput* hand() noexcept override { return nullptr; }
  [[nodiscard]] const HandScriptOptions& hand_options() const noexcept override { return options_; }

  [[nodiscard]] std::string_view name() const noexcept override { return "fake"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return info_.capabilities;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    if (is_unplugged) return tl::unexpected(DeviceFault::kDisconnected);
    PenSample sample = at;
    sample.time_ns = now_ns;
    return sample;
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    sent = force;
    return {};
  }
  void stop() noexcept override { sent = {}; }

  static inline PenSample at;
  static inline Force sent;
  static inline bool is_unplugged = false;

 private:
  PenDeviceInfo info_;
  HandScriptOptions options_;
};

struct FakeDriver {
  FakeDriver() {
    info.id = QStringLiteral("fake:1");
    info.label = QStringLiteral("Fake stylus");
    info.moves_hand = true;
    info.has_own_frame = true;
    info.capabilities = find_stylus_preset("touch")->capabilities;
    number = add_pen_driver({[this] { return std::vector<PenDeviceInfo>{info}; },
                             [this](const QString&) -> Result<std::unique_ptr<PenDevice>> {
                               if (is_broken) return fail(ErrorCode::kIo, "it is unplugged");
                               return std::make_unique<FakePen>(info);
                             }});
    Settings::the().set(QStringLiteral("devices/plane/fake:1"), {});
    FakePen::at = {};
    FakePen::is_unplugged = false;
    FakePen::at.position.z = 30;
  }
  ~FakeDriver() {
    remove_pen_driver(number);
    Settings::the().set(QStringLiteral("devices/plane/fake:1"), {});
    Settings::the().set(QString::fromLatin1(kPenDeviceKey), {});
  }

  PenDeviceInfo info;
  bool is_broken = false;
  int number = 0;
};

StudioOptions by_hand() {
  StudioOptions options;
  options.live = false;
  return options;
}

// A sheet that leans by 40 degrees before a device whose y is up and whose z comes to the person.
PlaneCalibration leaning() {
  const double c = std::cos(0.698), s = std::sin(0.698);
  return *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -c, s}, Vec3{0, s, c}}, {100, 80, 12});
}

TEST(PenDevices, TheFirstIsExactAndAlwaysThereAndAllOpen) {
  const std::vector<PenDeviceInfo> devices = pen_devices();
  ASSERT_FALSE(devices.empty());
  EXPECT_EQ(devices.front().id, QString::fromLatin1(kPenDeviceDefault));
  EXPECT_EQ(devices.back().id, QStringLiteral("simulated:worst"));
  QStringList ids, labels;
  for (const PenDeviceInfo& info : devices) {
    EXPECT_FALSE(info.moves_hand) << info.id.toStdString();
    EXPECT_FALSE(info.note.isEmpty());
    EXPECT_FALSE(ids.contains(info.id) || labels.contains(info.label));
    ids << info.id;
    labels << info.label;
    const auto opened = open_pen_device(info.id);
    ASSERT_TRUE(opened.has_value()) << info.id.toStdString();
    EXPECT_EQ((*opened)->info().id, info.id);
  }
  EXPECT_FALSE(open_pen_device(QStringLiteral("simulated:nothing")).has_value());
}

TEST(PenDevices, ADriverAddsItsOwnAndAChoiceThatIsGoneFallsBack) {
  auto driver = std::make_unique<FakeDriver>();
  Settings::the().set(QString::fromLatin1(kPenDeviceKey), QStringLiteral("fake:1"));
  EXPECT_EQ(chosen_pen_device(), QStringLiteral("fake:1"));
  driver.reset();
  Settings::the().set(QString::fromLatin1(kPenDeviceKey), QStringLiteral("fake:1"));
  EXPECT_EQ(chosen_pen_device(), QString::fromLatin1(kPenDeviceDefault));
  Settings::the().set(QString::fromLatin1(kPenDeviceKey), {});
}

TEST(PenDevices, APlaneIsKeptToTheLastBitAndNonsenseIsNone) {
  const FakeDriver driver;
  EXPECT_FALSE(plane_of(driver.info.id).has_value());
  keep_plane_of(driver.info.id, leaning());
  EXPECT_EQ(plane_of(driver.info.id), leaning());
  for (const char* bad : {"1 2 3", "a b c d e f g h i j k l", "1 0 0 0 1 0 0 0 1 nan 0 0",
                          "2 0 0 0 1 0 0 0 1 0 0 0", "1 0 0 0 1 0 0 0 1 0 0"}) {
    Settings::the().set(QStringLiteral("devices/plane/fake:1"), QString::fromLatin1(bad));
    EXPECT_FALSE(plane_of(driver.info.id).has_value()) << bad;
  }
}

TEST(PenDevices, APersonsDeviceIsSeenThroughItsPlaneAndStaysOffUntilItIsSwitchedOn) {
  const FakeDriver driver;
  keep_plane_of(driver.info.id, leaning());
  Studio studio(by_hand());
  ASSERT_TRUE(studio.use_device(driver.info.id));
  EXPECT_FALSE(studio.forces_are_on());
  FakePen::at.position = leaning().to_device(Vec3{20, 30, 4});
  studio.advance(50'000'000);
  EXPECT_NEAR(norm(studio.pen().sample.position - Vec3{20, 30, 4}), 0.0, 1e-9);
}

TEST(PenDevices, AFaultThatNeedsAPersonIsToldWithWhatToDoAndForcesStayOff) {
  const FakeDriver driver;
  QMainWindow window;
  Studio studio(by_hand());
  Actions actions(&window);
  add_feel_actions(actions, studio, &window);
  FeelPanel panel(studio);
  QStringList told;
  QObject::connect(&studio, &Studio::refused, &window, [&](const QString& why) { told << why; });
  ASSERT_TRUE(studio.use_device(driver.info.id));
  actions.find(QStringLiteral("feel.forces"))->trigger();
  studio.advance(1'000'000'000);
  ASSERT_EQ(studio.tick().safety.state, SafetyState::kActive);
  FakePen::is_unplugged = true;
  studio.advance(20'000'000);
  EXPECT_EQ(studio.tick().safety.state, SafetyState::kLatched);
  EXPECT_FALSE(studio.forces_are_on());
  EXPECT_EQ(actions.find(QStringLiteral("feel.forces"))->text().remove(QLatin1Char('&')),
            QStringLiteral("Switch forces on"));
  ASSERT_EQ(told.size(), 1);
  EXPECT_TRUE(told.front().contains(QStringLiteral("Check the cable")));
  QString text;
  for (const auto* label : panel.findChildren<QLabel*>()) text += label->text();
  EXPECT_TRUE(text.contains(QStringLiteral("Check the cable"))) << text.toStdString();
  FakePen::is_unplugged = false;
  actions.find(QStringLiteral("feel.forces"))->trigger();
  studio.advance(1'000'000'000);
  EXPECT_EQ(studio.tick().safety.state, SafetyState::kActive);
}

TEST(PenDevices, AnotherForceLimitDoesNotSwitchForcesOnAgainAfterAFault) {
  const FakeDriver driver;
  Studio studio(by_hand());
  ASSERT_TRUE(studio.use_device(driver.info.id));
  studio.set_forces(true);
  studio.advance(1'000'000'000);
  ASSERT_EQ(studio.tick().safety.state, SafetyState::kActive);
  studio.set_force_limit(1.0);
  EXPECT_TRUE(studio.forces_are_on()) << "there is no fault, and a person switched them on";
  studio.advance(1'000'000'000);
  ASSERT_EQ(studio.tick().safety.state, SafetyState::kActive);
  FakePen::is_unplugged = true;
  studio.advance(20'000'000);
  ASSERT_EQ(studio.tick().safety.state, SafetyState::kLatched);
  FakePen::is_unplugged = false;
  studio.set_force_limit(2.0);
  EXPECT_FALSE(studio.forces_are_on());
  studio.advance(1'000'000'000);
  EXPECT_EQ(studio.tick().safety.state, SafetyState::kOff);
  EXPECT_EQ(studio.tick().sent, Force{});
}

struct Corners {
  static void touch(CalibrationDialog& dialog, const Vec3& sheet_mm) {
    FakePen::at.position = leaning().to_device(sheet_mm);
    dialog.take();
  }
};

TEST(CalibrationDialog, ThreeCornersFindTheLeaningPlane) {
  FakeDriver driver;
  CalibrationDialog dialog(*open_pen_device(driver.info.id), {148.5, 105});
  dialog.show();
  Corners::touch(dialog, {50, 40, 0});
  Corners::touch(dialog, {200, 40, 0});
  EXPECT_FALSE(dialog.found().has_value());
  Corners::touch(dialog, {50, 140, 0});
  ASSERT_TRUE(dialog.found().has_value());
  const PlaneCalibration& map = dialog.found()->calibration;
  // The same plane and directions; the area lies around the middle that was asked for.
  const Vec3 p{77, 66, 5};
  EXPECT_NEAR(norm(map.to_sheet(leaning().to_device(p)) - (p + Vec3{23.5, 15, 0})), 0.0, 1e-6);
  EXPECT_LT(dialog.found()->worst_mm, 1e-6);
  EXPECT_EQ(FakePen::sent, Force{});
}

TEST(CalibrationDialog, AnOlderPlaneDoesNotBendTheNewOne) {
  FakeDriver driver;
  keep_plane_of(driver.info.id,
                *PlaneCalibration::from({Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}, {9, 9, 9}));
  CalibrationDialog dialog(*open_pen_device(driver.info.id), {125, 90});
  dialog.show();
  Corners::touch(dialog, {50, 40, 0});
  Corners::touch(dialog, {200, 40, 0});
  Corners::touch(dialog, {50, 140, 0});
  ASSERT_TRUE(dialog.found().has_value());
  EXPECT_NEAR(norm(dialog.found()->calibration.to_sheet(leaning().to_device(Vec3{60, 60, 1})) -
                   Vec3{60, 60, 1}),
              0.0, 1e-6);
}

TEST(CalibrationDialog, CornersOnOneLineBeginAgain) {
  FakeDriver driver;
  CalibrationDialog dialog(*open_pen_device(driver.info.id), {125, 90});
  dialog.show();
  Corners::touch(dialog, {50, 40, 0});
  Corners::touch(dialog, {200, 40, 0});
  Corners::touch(dialog, {120, 40, 0});
  EXPECT_FALSE(dialog.found().has_value());
  Corners::touch(dialog, {50, 40, 0});
  Corners::touch(dialog, {200, 40, 0});
  Corners::touch(dialog, {50, 150, 0});
  EXPECT_TRUE(dialog.found().has_value());
  dialog.start_again();
  EXPECT_FALSE(dialog.found().has_value());
}

TEST(DevicePage, AChoiceTakesEffectAtOnceAndIsKept) {
  FakeDriver driver;
  Studio studio(by_hand());
  DevicePage page(studio);
  page.show();
  auto* list = page.findChild<QListWidget*>();
  ASSERT_EQ(list->count(), static_cast<int>(pen_devices().size()));
  for (int row = 0; row < list->count(); ++row) {
    list->setCurrentRow(row);
    EXPECT_EQ(studio.device().info().label, list->item(row)->text());
    EXPECT_EQ(chosen_pen_device(), studio.device().info().id);
  }
  driver.is_broken = true;
  list->setCurrentRow(0);
  list->setCurrentRow(1);  // the fake one
  EXPECT_EQ(studio.device().info().id, QStringLiteral("tablet")) << "the one in use stays";
  EXPECT_EQ(list->currentRow(), 0);
}

TEST(DevicePage, TheTestPadLeavesTheDrawingAlone) {
  Studio studio(by_hand());
  DevicePage page(studio);
  page.show();
  auto* pad = page.findChild<TestPad*>();
  ASSERT_NE(pad->studio(), nullptr);
  QTest::mousePress(pad, Qt::LeftButton, {}, {20, 20});
  QTest::mouseMove(pad, {60, 30});
  QTest::mouseRelease(pad, Qt::LeftButton, {}, {60, 30});
  EXPECT_FALSE(studio.is_modified());
  page.hide();
  EXPECT_EQ(pad->studio(), nullptr) << "no loop runs that nobody sees";
}

}  // namespace
}  // namespace felt::desktop
