#include "desktop/devices/device_care.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>

#include "desktop/devices/device_page.h"
#include "desktop/devices/doctor_dialog.h"
#include "desktop/devices/homing_dialog.h"
#include "desktop/devices/testing/by_hand.h"
#include "desktop/engine/settings.h"
#include "desktop/feel/feel_panel.h"
#include "felt/base/constants.h"
#include "felt/driver/testing/scripted_driver.h"

namespace felt::desktop::device_care_test {
namespace {

const QString kArm = QStringLiteral("scripted:1");
const QString kTablet = QStringLiteral("tablet");

std::vector<std::unique_ptr<Driver>> drivers_of(const std::shared_ptr<ScriptedArm>& arm) {
  std::vector<std::unique_ptr<Driver>> drivers;
  drivers.push_back(std::make_unique<ScriptedDriver>(arm));
  return drivers;
}

/// A fixture: a window's studio with a device that the test connects and disconnects, in virtual
/// time.
struct Fixture {
  Fixture() {
    QFile::remove(profile_path(kArm));
    Settings::the().reset(QString::fromLatin1(kPenDeviceKey));
    // The device's frame is that of the page, so the pen is at the positions that the test sets.
    DeviceProfile profile;
    profile.device_id = kArm.toStdString();
    profile.plane = PlaneCalibration{};
    EXPECT_TRUE(keep_profile(profile).has_value());
    look();
  }
  ~Fixture() {
    QFile::remove(profile_path(kArm));
    Settings::the().reset(QString::fromLatin1(kPenDeviceKey));
  }

  /// Waits until the connected devices are found.
  void look() {
    // Waits for two searches, because the first may already have been running.
    for (int i = 0; i < 2; ++i) {
      QSignalSpy looked(&watch, &DriverWatch::looked);
      watch.look();
      EXPECT_TRUE(looked.wait(5000));
    }
  }
  void pen_at(double x, double y, double z) { arm->at.position = {x, y, z}; }
  /// Advances the time, and delivers the signals.
  void go_on(std::int64_t ms) {
    studio.advance(ms * kMs);
    QCoreApplication::processEvents();
  }
  /// Moves at a constant speed, because jumps of a real device are rejected.
  void move_to(double x, double y, double z) {
    const Vec3 from = arm->at.position;
    constexpr int kSteps = 100;
    for (int i = 1; i <= kSteps; ++i) {
      arm->at.position = from + (double(i) / kSteps) * (Vec3{x, y, z} - from);
      studio.advance(kMs);
    }
  }
  void draw_to(double x, double y) {
    move_to(arm->at.position.x, arm->at.position.y, -1.5);
    move_to(x, y, -1.5);
  }
  void lift() {
    move_to(arm->at.position.x, arm->at.position.y, 20);
    studio.advance(40 * kMs);
  }
  /// Waits as long as the timers need after the pen was lifted.
  void calm() { QTest::qWait(2 * DeviceCare::kCalmMs + 100); }
  [[nodiscard]] std::string device() { return studio.loop().device().info().id.toStdString(); }
  [[nodiscard]] std::size_t strokes() const { return studio.session().document().stroke_count(); }
  [[nodiscard]] std::string said() const { return notice->message().text.toStdString(); }

  std::shared_ptr<ScriptedArm> arm = std::make_shared<ScriptedArm>();
  DriverWatch watch{drivers_of(arm)};
  QMainWindow window;
  DeviceNotice* notice = new DeviceNotice(&window);
  Studio studio{by_hand()};
  DeviceCare* care = new DeviceCare(studio, *notice, &window);
};

/// Presses a button of the next dialog that opens.
void answer_next(const char* button) {
  QTimer::singleShot(20, qApp, [button] {
    QWidget* dialog = QApplication::activeModalWidget();
    ASSERT_NE(dialog, nullptr);
    for (QPushButton* each : dialog->findChildren<QPushButton*>()) {
      if (each->text().remove(QLatin1Char('&')) == QLatin1String(button)) return each->click();
    }
    ADD_FAILURE() << "no button " << button;
    static_cast<QDialog*>(dialog)->reject();
  });
}

/// Returns the complete data of the newest stroke, for an exact comparison.
StrokeData newest_stroke(const Session& session) {
  const Document& document = session.document();
  return document.find(document.layers().front().strokes.back())->data();
}

TEST(DeviceCare, APersonDrawsUnplugsMidLineAndDrawsOn) {
  Fixture fixture;
  fixture.pen_at(30, 30, 20);
  ASSERT_TRUE(fixture.care->use(kArm, nullptr));
  EXPECT_EQ(fixture.device(), "scripted:1");
  EXPECT_FALSE(fixture.studio.loop().forces_are_on());
  EXPECT_EQ(fixture.said(), "Scripted arm is in use. Its forces are off until you switch them on.");
  fixture.notice->press(0);
  EXPECT_TRUE(fixture.studio.loop().forces_are_on());
  fixture.go_on(1000);
  fixture.draw_to(60, 50);
  ASSERT_TRUE(fixture.studio.session().gesture_in_progress());
  EXPECT_GT(norm(fixture.arm->sent), 0.0);
  fixture.arm->vendor_words = "HD_COMM_ERROR: no answer from the arm";
  fixture.arm->is_plugged_in = false;
  fixture.go_on(40);
  // The drawn part is a stroke, forces are off, and the mouse can draw.
  EXPECT_EQ(fixture.strokes(), 1u);
  EXPECT_EQ(fixture.device(), "tablet");
  EXPECT_EQ(fixture.arm->sent, Force{});
  EXPECT_EQ(fixture.arm->closed, 1);
  EXPECT_EQ(fixture.care->waits_for(), kArm);
  EXPECT_NE(fixture.said().find("Scripted arm is no longer connected."), std::string::npos);
  EXPECT_EQ(fixture.notice->message().details.toStdString(),
            "HD_COMM_ERROR: no answer from the arm (7)");
  const auto point = [&fixture](double x, bool touches) {
    fixture.studio.point({fixture.studio.now_ns(), {x, 80}, touches, 0.5});
    fixture.studio.advance(20 * kMs);
  };
  point(20, false);
  for (double x = 20; x < 60; x += 5) point(x, true);
  point(60, false);
  fixture.go_on(100);
  EXPECT_EQ(fixture.strokes(), 2u);
  // When the device is plugged in again, it is used as soon as the pen is lifted, without forces.
  fixture.arm->is_plugged_in = true;
  fixture.pen_at(120, 20, 20);  // away from the end of the first line, which it would otherwise
                                // continue
  fixture.look();
  fixture.calm();
  EXPECT_EQ(fixture.device(), "scripted:1");
  EXPECT_FALSE(fixture.studio.loop().forces_are_on());
  EXPECT_TRUE(fixture.care->waits_for().isEmpty());
  fixture.go_on(500);
  EXPECT_EQ(fixture.arm->sent, Force{});
  fixture.draw_to(150, 40);
  fixture.lift();
  EXPECT_EQ(fixture.strokes(), 3u);
  EXPECT_EQ(fixture.arm->sent, Force{}) << "nobody has switched them on";
  fixture.draw_to(160, 60);
  fixture.studio.loop().set_forces(true);
  fixture.arm->largest_n = 0.0;
  fixture.draw_to(170, 70);
  EXPECT_EQ(fixture.arm->largest_n, 0.0) << "a pen that presses feels nothing until it is lifted";
}

TEST(DeviceCare, InkUpToTheFaultIsKeptByteForByte) {
  const auto drawn = [](bool unplugs) {
    Fixture fixture;
    fixture.pen_at(30, 30, 20);
    EXPECT_TRUE(fixture.care->use(kArm, nullptr));
    fixture.go_on(500);
    fixture.draw_to(60, 50);
    fixture.draw_to(40, 70);
    if (unplugs) {
      fixture.arm->is_plugged_in = false;
      fixture.go_on(40);
    } else {
      fixture.studio.finish_gesture();
    }
    EXPECT_EQ(fixture.strokes(), 1u);
    return newest_stroke(fixture.studio.session());
  };
  const StrokeData whole = drawn(false);
  EXPECT_GT(whole.points.size(), 3u);
  EXPECT_EQ(drawn(true), whole);
}

TEST(DeviceCare, NothingIsChangedWhileAPersonDraws) {
  Fixture fixture;
  ASSERT_TRUE(fixture.care->use(kArm, nullptr));
  fixture.arm->is_plugged_in = false;
  fixture.go_on(40);
  ASSERT_EQ(fixture.device(), "tablet");
  for (int i = 0; i < 10; ++i) {
    fixture.studio.point({fixture.studio.now_ns(), {20.0 + 3 * i, 80}, true, 0.5});
    fixture.studio.advance(20 * kMs);
  }
  ASSERT_TRUE(fixture.studio.session().gesture_in_progress());
  fixture.arm->is_plugged_in = true;
  fixture.look();
  fixture.calm();
  EXPECT_EQ(fixture.device(), "tablet");
  fixture.studio.point({fixture.studio.now_ns(), {50, 80}, false, 0.0});
  fixture.go_on(100);
  fixture.calm();
  EXPECT_EQ(fixture.device(), "scripted:1");
  EXPECT_EQ(fixture.strokes(), 1u);
}

TEST(DeviceCare, ForcesThatTheDeviceSwitchesOffDoNotEndTheDrawing) {
  for (const DeviceFault fault : {DeviceFault::kForcesOff, DeviceFault::kOverheated}) {
    Fixture fixture;
    FeelPanel panel(fixture.studio);
    fixture.pen_at(30, 30, 20);
    ASSERT_TRUE(fixture.care->use(kArm, nullptr));
    fixture.notice->press(0);
    fixture.go_on(1000);
    fixture.draw_to(60, 50);
    fixture.arm->write_fault = fault;
    fixture.arm->vendor_words = "HD_FORCE_ERROR";
    fixture.go_on(40);
    EXPECT_EQ(fixture.device(), "scripted:1");
    EXPECT_TRUE(fixture.studio.session().gesture_in_progress()) << "the line goes on";
    EXPECT_EQ(fixture.studio.loop().tick().safety.state, SafetyState::kLatched);
    const bool is_off = fault == DeviceFault::kForcesOff;
    EXPECT_NE(fixture.said().find(is_off ? "has switched its forces off" : "are too warm"),
              std::string::npos)
        << fixture.said();
    QString text;
    for (const auto* label : panel.findChildren<QLabel*>()) text += label->text();
    EXPECT_TRUE(text.contains(is_off ? QStringLiteral("Switch the forces on at the device")
                                     : QStringLiteral("rest for a few minutes")))
        << text.toStdString();
    fixture.draw_to(80, 50);
    fixture.lift();
    EXPECT_EQ(fixture.strokes(), 1u);
    // The device works again, and the user confirms.
    fixture.arm->write_fault.reset();
    fixture.notice->press(0);
    fixture.go_on(1000);
    EXPECT_EQ(fixture.studio.loop().tick().safety.state, SafetyState::kActive);
  }
}

TEST(DeviceCare, ShowsTheNoticesOfTheDevice) {
  Fixture fixture;
  fixture.arm->notice = "It has no watchdog.";
  fixture.pen_at(30, 30, 20);
  ASSERT_TRUE(fixture.care->use(kArm, nullptr));
  EXPECT_NE(fixture.said().find("is in use"), std::string::npos) << fixture.said();
  EXPECT_EQ(fixture.notice->message().details.toStdString(), fixture.arm->notice);
  fixture.go_on(100);
  EXPECT_NE(fixture.said().find("is in use"), std::string::npos)
      << "shown already: " << fixture.said();
  fixture.arm->notice = "The service stopped sending events.";
  fixture.go_on(100);
  EXPECT_NE(fixture.said().find(fixture.arm->notice), std::string::npos) << fixture.said();
  EXPECT_FALSE(fixture.notice->message().is_fault);
  ASSERT_EQ(fixture.notice->message().buttons.size(), 1u) << "forces are still off";
  fixture.notice->press(0);
  EXPECT_TRUE(fixture.studio.loop().forces_are_on());
  fixture.go_on(1000);
  EXPECT_FALSE(fixture.notice->isVisibleTo(&fixture.window)) << "each notice is shown once";
}

/// Lets the arm work again and expects that only the button of the notice opens it.
void expect_opened_by_its_button_only(Fixture& fixture) {
  fixture.arm->read_fault.reset();
  fixture.look();
  fixture.calm();
  EXPECT_EQ(fixture.device(), "tablet");
  ASSERT_EQ(fixture.notice->message().buttons.size(), 1u);
  fixture.notice->press(0);
  EXPECT_EQ(fixture.device(), "scripted:1");
}

TEST(DeviceCare, AFaultThatPassesIsWaitedOutAndOneThatStaysLetsGo) {
  Fixture fixture;
  fixture.pen_at(30, 30, 20);
  ASSERT_TRUE(fixture.care->use(kArm, nullptr));
  fixture.arm->read_fault = DeviceFault::kBadData;
  fixture.go_on(40);
  EXPECT_EQ(fixture.device(), "scripted:1");
  fixture.arm->read_fault.reset();
  fixture.go_on(40);
  QTest::qWait(DeviceCare::kPatienceMs + 100);
  EXPECT_EQ(fixture.device(), "scripted:1");
  fixture.arm->read_fault = DeviceFault::kBadData;
  fixture.go_on(40);
  QTest::qWait(DeviceCare::kPatienceMs + 100);
  EXPECT_EQ(fixture.device(), "tablet");
  // The device is still plugged in: only the user can try again.
  expect_opened_by_its_button_only(fixture);
}

// It may be switching itself off, and can say whether it has only while it is read.
TEST(DeviceCare, AMachineThatIsNotReadyAnyMoreIsReadUntilItHasSaidWhy) {
  Fixture fixture;
  ASSERT_TRUE(fixture.care->use(kArm, nullptr));
  fixture.arm->read_fault = DeviceFault::kNotCalibrated;
  fixture.arm->vendor_words = "It was late.";
  fixture.go_on(40);
  EXPECT_EQ(fixture.device(), "scripted:1");
  fixture.arm->vendor_words = "Press its emergency button!";
  fixture.go_on(40);
  QTest::qWait(DeviceCare::kPatienceMs + 100);
  EXPECT_EQ(fixture.device(), "tablet");
  EXPECT_TRUE(
      fixture.notice->message().text.contains(QStringLiteral("Press its emergency button!")));
}

TEST(DeviceCare, ADeviceThatCannotBeLookedForIsOpenedByAPersonOnly) {
  Fixture fixture;
  fixture.arm->descriptor.is_connected = false;
  fixture.look();
  ASSERT_TRUE(fixture.care->use(kArm, nullptr));
  fixture.arm->read_fault = DeviceFault::kDisconnected;
  fixture.go_on(40);
  ASSERT_EQ(fixture.device(), "tablet");
  expect_opened_by_its_button_only(fixture);
}

TEST(DeviceCare, OneThatFailsAgainAtOnceIsNotOpenedForEver) {
  Fixture fixture;
  ASSERT_TRUE(fixture.care->use(kArm, nullptr));
  fixture.arm->read_fault = DeviceFault::kDisconnected;
  fixture.go_on(40);
  fixture.look();
  fixture.calm();
  ASSERT_EQ(fixture.device(), "scripted:1") << "it is still listed: one try by itself";
  fixture.go_on(40);
  ASSERT_EQ(fixture.device(), "tablet");
  fixture.look();
  fixture.calm();
  EXPECT_EQ(fixture.device(), "tablet");
  EXPECT_EQ(fixture.arm->opened, 2);
  EXPECT_EQ(fixture.notice->message().buttons.size(), 1u);
}

TEST(DeviceCare, TheChosenOneIsUsedWhenItComes) {
  Fixture first;  // sets the profile
  Settings::the().set(QString::fromLatin1(kPenDeviceKey), kArm);
  Studio studio(by_hand());
  QMainWindow window;
  auto* notice = new DeviceNotice(&window);
  const DeviceCare care(studio, *notice, &window);
  EXPECT_EQ(care.waits_for(), kArm);
  EXPECT_FALSE(notice->isVisibleTo(&window)) << "nothing has gone wrong";
  first.look();
  QTest::qWait(2 * DeviceCare::kCalmMs + 100);
  EXPECT_EQ(studio.loop().device().info().id, kArm);
  EXPECT_FALSE(studio.loop().forces_are_on());
  // Another window cannot open the device.
  EXPECT_FALSE(first.care->use(kArm, nullptr));
  EXPECT_NE(first.said().find("in another window"), std::string::npos);
}

TEST(DeviceCare, AnArmThatMovesByItselfNeedsAYes) {
  Fixture fixture;
  fixture.arm->homing = Homing::kByItself;
  answer_next("Not now");
  EXPECT_FALSE(fixture.care->use(kArm, nullptr));
  EXPECT_EQ(fixture.arm->homed, 0);
  EXPECT_EQ(fixture.device(), "tablet");
  EXPECT_EQ(fixture.arm->closed, 1) << "nothing stays open";
  answer_next("Let it move");
  EXPECT_TRUE(fixture.care->use(kArm, nullptr));
  EXPECT_EQ(fixture.arm->homed, 1);
  EXPECT_EQ(fixture.device(), "scripted:1");
  // When the device is unplugged and plugged in again, it needs homing again, by a button and
  // never automatically.
  fixture.arm->is_plugged_in = false;
  fixture.go_on(40);
  fixture.look();
  fixture.arm->homing = Homing::kByItself;
  fixture.arm->is_plugged_in = true;
  fixture.look();
  fixture.calm();
  EXPECT_EQ(fixture.device(), "tablet");
  EXPECT_EQ(fixture.arm->homed, 1);
  EXPECT_NE(fixture.said().find("must find its home"), std::string::npos) << fixture.said();
  answer_next("Let it move");
  fixture.notice->press(0);
  EXPECT_EQ(fixture.device(), "scripted:1");
}

TEST(HomingDialog, EnterNeverMovesAnArmAndAFailureIsToldAndCanBeTriedAgain) {
  Fixture fixture;
  fixture.arm->homing = Homing::kByItself;
  fixture.arm->home_is_found = false;
  const auto pen = open_pen_device(kArm);
  ASSERT_TRUE(pen.has_value());
  HomingDialog dialog(**pen);
  dialog.show();
  QTest::keyClick(&dialog, Qt::Key_Return);
  EXPECT_EQ(dialog.result(), QDialog::Rejected);
  EXPECT_EQ(fixture.arm->homed, 0);
  dialog.show();
  dialog.begin();
  EXPECT_TRUE(dialog.is_under_way());
  dialog.reject();
  EXPECT_TRUE(dialog.isVisible()) << "not while it moves";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.is_under_way(); }));
  QString text;
  for (const auto* label : dialog.findChildren<QLabel*>()) text += label->text();
  EXPECT_TRUE(text.contains(QStringLiteral("axis 2 is blocked"))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("brass hole")));
  fixture.arm->home_is_found = true;
  dialog.begin();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.isVisible(); }));
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
}

TEST(HomingDialog, AHandThatHoldsItPressesEnter) {
  for (const Homing homing : {Homing::kInkwell, Homing::kRestPose}) {
    Fixture fixture;
    fixture.arm->homing = homing;
    const auto pen = open_pen_device(kArm);
    HomingDialog dialog(**pen);
    dialog.show();
    QTest::keyClick(&dialog, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.isVisible(); }));
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    EXPECT_EQ(fixture.arm->homed, 1);
    EXPECT_TRUE(HomingDialog::bring_home(**pen, nullptr)) << "it is at home: nothing is asked";
  }
}

TEST(DoctorDialog, SaysWhatIsMissingAndWhatToDoAndCopiesIt) {
  Fixture fixture;
  fixture.arm->findings = {{FindingLevel::kProblem,
                            "The library <libHD> was not found.",
                            "libHD.so: cannot open shared object file",
                            {"Install the maker's software.", "Start Feltline again."},
                            {}},
                           {FindingLevel::kOk, "The port may be used.", {}, {}, {}}};
  DoctorDialog dialog;
  EXPECT_TRUE(dialog.is_looking());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.is_looking(); }));
  const QString text = dialog.findChild<QTextBrowser*>()->toPlainText();
  for (const char* part : {"Scripted arms", "The library <libHD> was not found.",
                           "cannot open shared object file", "Start Feltline again."}) {
    EXPECT_TRUE(text.contains(QLatin1String(part))) << part << "\n" << text.toStdString();
  }
  const QString copied = dialog.plain_text();
  EXPECT_TRUE(copied.contains(QStringLiteral("    2. Start Feltline again.\n")))
      << copied.toStdString();
  for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
    if (button->text() == QStringLiteral("&Copy all")) button->click();
  }
  EXPECT_EQ(QGuiApplication::clipboard()->text(), copied);
}

TEST(DevicePage, RowsSayHowRealDevicesAre) {
  Fixture fixture;
  DevicePage page(fixture.studio, fixture.care);
  page.show();
  fixture.look();
  const auto row = [&page](int i) {
    return page.findChild<QListWidget*>()->item(i)->text().toStdString();
  };
  EXPECT_EQ(row(0), "Scripted arm\nConnected");
  EXPECT_NE(row(1).find("step by step"), std::string::npos) << row(1);
  ASSERT_TRUE(page.choose(kArm));
  page.use();
  EXPECT_EQ(row(0), "Scripted arm\nIn use, forces off");
  fixture.studio.loop().set_forces(true);
  page.refresh();
  EXPECT_EQ(row(0), "Scripted arm\nIn use");
  fixture.arm->is_plugged_in = false;
  fixture.go_on(40);
  fixture.look();
  EXPECT_EQ(row(0), "Scripted arm\nNot connected; used again once it is");
  fixture.arm->is_plugged_in = true;
  QFile::remove(profile_path(kArm));
  fixture.care->use(QStringLiteral("simulated:touch"), nullptr);
  fixture.look();
  EXPECT_EQ(row(0), "Scripted arm\nConnected; its drawing plane is not set yet");
  QFile file(profile_path(kArm));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("device = scripted:1\nhand = third\n");
  file.close();
  page.refresh();
  EXPECT_EQ(row(0), "Scripted arm\nConnected; its settings cannot be read");
  ASSERT_TRUE(page.choose(kArm));
  page.use();
  EXPECT_EQ(fixture.device(), "simulated:touch");
  EXPECT_NE(fixture.notice->message().details.toStdString().find("hand: must be"),
            std::string::npos);
}

TEST(DevicePage, EachHandHasItsPlane) {
  Fixture fixture;
  ASSERT_TRUE(fixture.care->use(kArm, nullptr));
  DevicePage page(fixture.studio, fixture.care);
  page.show();
  auto* settings = page.findChild<DeviceSettings*>();
  const auto choose_hand = [settings](int index) {
    auto* hand = settings->findChild<QComboBox*>();
    hand->setCurrentIndex(index);
    Q_EMIT hand->activated(index);
  };
  const auto right =
      PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}, {100, 80, 12});
  DeviceProfile profile = profile_of(kArm).value();
  profile.plane = right;
  ASSERT_TRUE(keep_profile(profile).has_value());
  fixture.studio.loop().set_profile(profile);
  fixture.studio.loop().set_forces(true);
  choose_hand(1);
  EXPECT_FALSE(fixture.studio.loop().forces_are_on()) << "the page is somewhere else now";
  EXPECT_TRUE(profile_of(kArm)->left_handed);
  EXPECT_FALSE(plane_of(kArm).has_value()) << "nobody has shown it for this hand";
  EXPECT_NE(fixture.studio.loop().device().device().plane(), *right);
  settings->fit();
  const auto left = plane_of(kArm);
  ASSERT_TRUE(left.has_value());
  EXPECT_NE(left, right);
  EXPECT_EQ(fixture.studio.loop().device().device().plane(), *left);
  choose_hand(0);
  EXPECT_EQ(plane_of(kArm), right);
  EXPECT_EQ(fixture.studio.loop().device().device().plane(), *right);
  choose_hand(1);
  EXPECT_EQ(fixture.studio.loop().device().device().plane(), *left);
  EXPECT_EQ(fixture.arm->opened, 1) << "the device itself has nothing to do with it";
}

}  // namespace
}  // namespace felt::desktop::device_care_test
