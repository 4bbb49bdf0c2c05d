#include "desktop/devices/device_page.h"

#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QTest>
#include <cmath>

#include "desktop/devices/calibration_dialog.h"
#include "desktop/devices/testing/by_hand.h"
#include "desktop/engine/settings.h"
#include "desktop/feel/feel_actions.h"
#include "desktop/feel/feel_panel.h"
#include "felt/driver/testing/scripted_driver.h"

namespace felt::desktop::device_page_test {
namespace {

/// A user's device with its own frame that any studio can use immediately.
struct FakeDriver {
  FakeDriver() {
    arm->descriptor.id = "fake:1";
    arm->descriptor.label = "Fake stylus";
    arm->descriptor.serial.clear();
    arm->at.position.z = 30;
    QFile::remove(profile_path(id));
  }
  FakeDriver(const FakeDriver&) = delete;
  FakeDriver& operator=(const FakeDriver&) = delete;
  ~FakeDriver() {
    remove_pen_driver(number);
    QFile::remove(profile_path(id));
    Settings::the().set(QString::fromLatin1(kPenDeviceKey), {});
  }
  [[nodiscard]] std::vector<PenDeviceInfo> find() const {
    PenDeviceInfo info;
    info.id = id;
    info.label = label;
    info.moves_hand = true;
    info.has_own_frame = arm->descriptor.has_own_frame;
    info.capabilities = arm->descriptor.capabilities;
    return {info};
  }

  const QString id = QStringLiteral("fake:1"), label = QStringLiteral("Fake stylus");
  std::shared_ptr<ScriptedArm> arm = std::make_shared<ScriptedArm>();
  ScriptedDriver driver{arm};
  int number = add_pen_driver({[this] { return find(); },
                               [this](const QString&, DeviceSetup setup) {
                                 return OpenDevice::open(driver, arm->descriptor, setup);
                               }});
};

// Returns a page tilted by 40 degrees in front of a device whose y axis points up and whose z axis
// points to the user.
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

void write_profile(const QString& id, const QByteArray& text) {
  QFile file(profile_path(id));
  QDir().mkpath(QFileInfo(file).path());
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
}

TEST(PenDevices, APlaneIsKeptToTheLastBitAndNonsenseIsNone) {
  const FakeDriver driver;
  EXPECT_FALSE(plane_of(driver.id).has_value());
  ASSERT_TRUE(keep_plane_of(driver.id, leaning()).has_value());
  EXPECT_EQ(plane_of(driver.id), leaning());
  write_profile(driver.id, "device = fake:1\nplane_x = 2 0 0\n");
  EXPECT_FALSE(plane_of(driver.id).has_value());
}

TEST(PenDevices, WhatIsKeptAndCannotBeReadIsToldInTheStatusLineAndNothingOpens) {
  const FakeDriver driver;
  write_profile(driver.id, "device = fake:1\nforce_limit_n = much\n");
  const auto opened = open_pen_device(driver.id);
  ASSERT_FALSE(opened.has_value());
  EXPECT_NE(opened.error().message.find("fake+1.conf:2: force_limit_n: is not a number"),
            std::string::npos)
      << opened.error().message;
  Studio studio(by_hand());
  QString reported;
  QObject::connect(&studio, &Studio::refused, &studio, [&](const QString& why) { reported = why; });
  EXPECT_FALSE(studio.use_device(driver.id));
  EXPECT_TRUE(reported.contains(QStringLiteral("fake+1.conf:2")));
}

TEST(PenDevices, APersonsNameAndLimitsAreTheDevices) {
  const FakeDriver driver;
  write_profile(driver.id,
                "device = fake:1\nname = Old friend\nforce_limit_n = 0.7\nplane_x = 1 0 0\n"
                "plane_y = 0 1 0\nplane_z = 0 0 1\nplane_origin_mm = 0 0 0\nplane_scale = 2\n");
  const auto opened = open_pen_device(driver.id);
  ASSERT_TRUE(opened.has_value()) << opened.error().message;
  EXPECT_EQ((*opened)->info().label, QStringLiteral("Old friend"));
  const Capabilities& can = (*opened)->device().capabilities();
  EXPECT_EQ(limits_for(can).peak_force_n, 0.7);
  EXPECT_EQ(can.page_scale, 2.0);
  EXPECT_EQ(can.max_stiffness_n_per_m,
            0.5 * driver.arm->descriptor.capabilities.max_stiffness_n_per_m);
}

TEST(PenDevices, APersonsDeviceIsSeenThroughItsPlaneAndStaysOffUntilItIsSwitchedOn) {
  const FakeDriver driver;
  ASSERT_TRUE(keep_plane_of(driver.id, leaning()).has_value());
  Studio studio(by_hand());
  ASSERT_TRUE(studio.use_device(driver.id));
  EXPECT_FALSE(studio.loop().forces_are_on());
  driver.arm->at.position = leaning().to_device(Vec3{20, 30, 4});
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
  QStringList reported;
  QObject::connect(&studio, &Studio::refused, &window,
                   [&](const QString& why) { reported << why; });
  ASSERT_TRUE(studio.use_device(driver.id));
  actions.find(QStringLiteral("feel.forces"))->trigger();
  studio.advance(1'000'000'000);
  ASSERT_EQ(studio.loop().tick().safety.state, SafetyState::kActive);
  driver.arm->is_plugged_in = false;
  studio.advance(20'000'000);
  EXPECT_EQ(studio.loop().tick().safety.state, SafetyState::kLatched);
  EXPECT_FALSE(studio.loop().forces_are_on());
  EXPECT_EQ(actions.find(QStringLiteral("feel.forces"))->text().remove(QLatin1Char('&')),
            QStringLiteral("Switch forces on"));
  ASSERT_EQ(reported.size(), 1);
  EXPECT_TRUE(reported.front().contains(QStringLiteral("Check the cable")));
  QString text;
  for (const auto* label : panel.findChildren<QLabel*>()) text += label->text();
  EXPECT_TRUE(text.contains(QStringLiteral("Check the cable"))) << text.toStdString();
  driver.arm->is_plugged_in = true;
  actions.find(QStringLiteral("feel.forces"))->trigger();
  studio.advance(1'000'000'000);
  EXPECT_EQ(studio.loop().tick().safety.state, SafetyState::kActive);
}

TEST(PenDevices, AnotherForceLimitDoesNotSwitchForcesOnAgainAfterAFault) {
  const FakeDriver driver;
  Studio studio(by_hand());
  ASSERT_TRUE(studio.use_device(driver.id));
  studio.loop().set_forces(true);
  studio.advance(1'000'000'000);
  ASSERT_EQ(studio.loop().tick().safety.state, SafetyState::kActive);
  studio.loop().set_force_limit(1.0);
  EXPECT_TRUE(studio.loop().forces_are_on()) << "no fault occurred, and the user switched them on";
  studio.advance(1'000'000'000);
  ASSERT_EQ(studio.loop().tick().safety.state, SafetyState::kActive);
  driver.arm->is_plugged_in = false;
  studio.advance(20'000'000);
  ASSERT_EQ(studio.loop().tick().safety.state, SafetyState::kLatched);
  driver.arm->is_plugged_in = true;
  studio.loop().set_force_limit(2.0);
  EXPECT_FALSE(studio.loop().forces_are_on());
  studio.advance(1'000'000'000);
  EXPECT_EQ(studio.loop().tick().safety.state, SafetyState::kOff);
  EXPECT_EQ(studio.loop().tick().sent, Force{});
}

void touch(FakeDriver& driver, CalibrationDialog& dialog, const Vec3& page_mm) {
  driver.arm->at.position = leaning().to_device(page_mm);
  dialog.take();
}

TEST(CalibrationDialog, ThreeCornersFindTheLeaningPlane) {
  FakeDriver driver;
  CalibrationDialog dialog(*open_pen_device(driver.id), {148.5, 105});
  dialog.show();
  touch(driver, dialog, {50, 40, 0});
  touch(driver, dialog, {200, 40, 0});
  EXPECT_FALSE(dialog.found().has_value());
  touch(driver, dialog, {50, 140, 0});
  ASSERT_TRUE(dialog.found().has_value());
  const PlaneCalibration& map = dialog.found()->calibration;
  // The plane and the directions of its axes do not change; the drawing area lies around the
  // requested centre.
  const Vec3 p{77, 66, 5};
  EXPECT_NEAR(norm(map.to_page(leaning().to_device(p)) - (p + Vec3{23.5, 15, 0})), 0.0, 1e-6);
  EXPECT_LT(dialog.found()->worst_mm, 1e-6);
  EXPECT_EQ(driver.arm->sent, Force{});
}

TEST(CalibrationDialog, AnOlderPlaneDoesNotBendTheNewOne) {
  FakeDriver driver;
  ASSERT_TRUE(
      keep_plane_of(driver.id, *PlaneCalibration::from(
                                   {Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}, {9, 9, 9}, 1.5))
          .has_value());
  CalibrationDialog dialog(*open_pen_device(driver.id), {125, 90});
  dialog.show();
  touch(driver, dialog, {50, 40, 0});
  touch(driver, dialog, {200, 40, 0});
  touch(driver, dialog, {50, 140, 0});
  ASSERT_TRUE(dialog.found().has_value());
  EXPECT_NEAR(norm(dialog.found()->calibration.to_page(leaning().to_device(Vec3{60, 60, 1})) -
                   Vec3{60, 60, 1}),
              0.0, 1e-6);
}

TEST(CalibrationDialog, CornersOnOneLineBeginAgain) {
  FakeDriver driver;
  CalibrationDialog dialog(*open_pen_device(driver.id), {125, 90});
  dialog.show();
  touch(driver, dialog, {50, 40, 0});
  touch(driver, dialog, {200, 40, 0});
  touch(driver, dialog, {120, 40, 0});
  EXPECT_FALSE(dialog.found().has_value());
  touch(driver, dialog, {50, 40, 0});
  touch(driver, dialog, {200, 40, 0});
  touch(driver, dialog, {50, 150, 0});
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
  EXPECT_EQ(page.chosen(), QStringLiteral("tablet"));
  EXPECT_TRUE(list->item(0)->text().startsWith(driver.label)) << "real ones come first";
  for (const PenDeviceInfo& info : pen_devices()) {
    if (info.moves_hand) continue;
    ASSERT_TRUE(page.choose(info.id));
    EXPECT_EQ(studio.loop().device().info().id, info.id);
    EXPECT_EQ(chosen_pen_device(), info.id);
  }
}

TEST(DevicePage, ARealDeviceIsUsedWhenItsButtonIsPressed) {
  FakeDriver driver;
  Studio studio(by_hand());
  DevicePage page(studio);
  page.show();
  ASSERT_TRUE(page.choose(driver.id));
  EXPECT_EQ(studio.loop().device().info().id, QStringLiteral("tablet"))
      << "looking at it does nothing";
  driver.arm->open_error = "it is unplugged";
  page.use();
  EXPECT_EQ(studio.loop().device().info().id, QStringLiteral("tablet")) << "the one in use stays";
  driver.arm->open_error.clear();
  page.use();
  EXPECT_EQ(studio.loop().device().info().id, driver.id);
  EXPECT_EQ(chosen_pen_device(), driver.id);
  EXPECT_FALSE(studio.loop().forces_are_on());
  auto* settings = page.findChild<DeviceSettings*>();
  EXPECT_TRUE(settings->isVisible());
  ASSERT_TRUE(page.choose(QStringLiteral("tablet")));
  EXPECT_FALSE(settings->isVisible());
}

TEST(DevicePage, WhatIsSetForADeviceIsKeptAndTakesEffectAtOnceWithForcesOff) {
  FakeDriver driver;
  Studio studio(by_hand());
  ASSERT_TRUE(studio.use_device(driver.id));
  DevicePage page(studio);
  page.show();
  auto* settings = page.findChild<DeviceSettings*>();
  const auto child = [settings](const char* name) {
    for (auto* widget : settings->findChildren<QAbstractSpinBox*>()) {
      if (widget->accessibleName() == QLatin1String(name)) return widget;
    }
    return static_cast<QAbstractSpinBox*>(nullptr);
  };
  studio.loop().set_forces(true);
  qobject_cast<QDoubleSpinBox*>(child("Largest force"))->setValue(1.2);
  EXPECT_FALSE(studio.loop().forces_are_on()) << "a new loop begins from no force";
  qobject_cast<QSpinBox*>(child("Stiffest surface"))->setValue(250);
  qobject_cast<QSpinBox*>(child("Size of a movement on the page"))->setValue(150);
  auto* name = settings->findChild<QLineEdit*>();
  name->setText(QStringLiteral("  My  arm "));
  Q_EMIT name->editingFinished();
  const DeviceProfile kept = profile_of(driver.id).value();
  EXPECT_EQ(kept.name, "My arm");
  EXPECT_EQ(kept.force_limit_n, 1.2);
  EXPECT_EQ(kept.stiffness_cap_n_per_m, 250.0);
  ASSERT_TRUE(kept.plane.has_value());
  EXPECT_EQ(kept.plane->scale(), 1.5);
  EXPECT_EQ(studio.loop().device().info().label, QStringLiteral("My arm"));
  EXPECT_EQ(limits_for(studio.loop().device().device().capabilities()).peak_force_n, 1.2);
  EXPECT_EQ(studio.loop().device().device().capabilities().page_scale, 1.5);
  // A limit that is raised to the maximum of the device is not stored in the profile.
  auto* limit = qobject_cast<QDoubleSpinBox*>(child("Largest force"));
  limit->setValue(99.0);
  EXPECT_LE(limit->value(), limits_for(driver.arm->descriptor.capabilities).peak_force_n + 1e-9);
  EXPECT_FALSE(profile_of(driver.id)->force_limit_n.has_value());
  // A Touch reaches 160 mm of the page's 210 or 297 mm.
  settings->fit();
  EXPECT_GT(studio.loop().device().device().capabilities().page_scale, 1.5);
  const Rect page_area = studio.page().area();
  const Capabilities& can = studio.loop().device().device().capabilities();
  EXPECT_NEAR(0.5 * (can.workspace_min.x + can.workspace_max.x),
              0.5 * (page_area.x0 + page_area.x1), 1e-6);
}

// The general limit may be too low for the field to show. Changing another field must not raise
// it.
TEST(DevicePage, TheStiffestPageLeavesTheForceLimitsAlone) {
  FakeDriver driver;
  Studio studio(by_hand());
  ASSERT_TRUE(studio.use_device(driver.id));
  studio.loop().set_force_limit(0.0);
  DevicePage page(studio);
  page.show();
  auto* settings = page.findChild<DeviceSettings*>();
  for (auto* box : settings->findChildren<QSpinBox*>()) {
    if (box->accessibleName() == QLatin1String("Stiffest surface")) box->setValue(250);
  }
  const DeviceProfile kept = profile_of(driver.id).value();
  EXPECT_EQ(kept.stiffness_cap_n_per_m, 250.0);
  EXPECT_FALSE(kept.force_limit_n.has_value());
  EXPECT_EQ(studio.loop().force_limit(), 0.0);
}

// A joystick or a wheel has no plane to calibrate, but like any other device it pushes the user's
// hand.
TEST(DevicePage, APersonsLimitsHoldForADeviceWithoutAPlane) {
  FakeDriver driver;
  driver.arm->descriptor.has_own_frame = false;
  write_profile(driver.id,
                "device = fake:1\nname = Old friend\nforce_limit_n = 0.7\n"
                "stiffness_cap_n_per_m = 200\nplane_x = 0 1 0\nplane_y = 1 0 0\n"
                "plane_z = 0 0 1\nplane_origin_mm = 9 9 9\nplane_scale = 2\n");
  Studio studio(by_hand());
  ASSERT_TRUE(studio.use_device(driver.id));
  const auto can = [&studio]() -> const Capabilities& {
    return studio.loop().device().device().capabilities();
  };
  EXPECT_EQ(limits_for(can()).peak_force_n, 0.7);
  EXPECT_EQ(can().max_stiffness_n_per_m, 200.0);
  EXPECT_EQ(studio.loop().device().device().plane(), PlaneCalibration{})
      << "where it says it is, it is";
  EXPECT_EQ(studio.loop().device().info().label, QStringLiteral("Old friend"));
  DevicePage page(studio);
  page.show();
  ASSERT_TRUE(page.choose(driver.id));
  auto* settings = page.findChild<DeviceSettings*>();
  ASSERT_TRUE(settings->isVisible());
  auto* limit = settings->findChild<QDoubleSpinBox*>();
  EXPECT_TRUE(limit->isVisible());
  EXPECT_EQ(limit->value(), 0.7);
  EXPECT_FALSE(settings->findChild<QComboBox*>()->isVisible()) << "a hand is of a plane";
  EXPECT_FALSE(settings->findChild<QPushButton*>()->isVisible()) << "a plane cannot be set";
  limit->setValue(1.2);
  EXPECT_EQ(profile_of(driver.id)->force_limit_n, 1.2);
  EXPECT_EQ(limits_for(can()).peak_force_n, 1.2);
}

TEST(CalibrationDialog, ADeviceThatMovesInThePlaneOnlyIsInIt) {
  FakeDriver driver;
  driver.arm->descriptor.capabilities.sensed_axes =
      driver.arm->descriptor.capabilities.actuated_axes = 2;
  CalibrationDialog dialog(*open_pen_device(driver.id), {125, 90});
  dialog.show();
  for (const Vec3& corner : {Vec3{50, 140, 0.25}, Vec3{200, 140, 0.25}, Vec3{50, 40, 0.25}}) {
    driver.arm->at.position = corner;  // the pen is up because no key is held
    dialog.take();
  }
  ASSERT_TRUE(dialog.found().has_value());
  const PlaneCalibration& plane = dialog.found()->calibration;
  EXPECT_NEAR(plane.to_page(Vec3{60, 60, 0.25}).z, 0.25, 1e-9);
  EXPECT_NEAR(plane.to_page(Vec3{60, 60, -0.25}).z, -0.25, 1e-9);
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
}  // namespace felt::desktop::device_page_test
