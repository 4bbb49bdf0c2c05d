#include "desktop/trial/trial_start.h"

#include <QApplication>
#include <QDateTime>
#include <QEventLoop>
#include <QScreen>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "desktop/devices/homing_dialog.h"
#include "desktop/engine/driver_watch.h"
#include "desktop/engine/settings.h"
#include "desktop/engine/text_of.h"
#include "desktop/engine/wheel_guard.h"
#include "desktop/trial/session_steps.h"
#include "desktop/trial/trial_window.h"
#include "desktop/trial/unfinished_trials.h"
#include "felt/devices/drivers.h"
#include "felt/studies/trial_setup.h"

namespace felt::desktop {
namespace {

constexpr int kSearchMs = 10'000;  // the longest search for a device

Result<SessionKind> session_of(const TrialRequest& request) {
  const std::string name = request.session.toStdString();
  const auto at = std::find(kSessionKinds.begin(), kSessionKinds.end(), name);
  if (at != kSessionKinds.end()) return static_cast<SessionKind>(at - kSessionKinds.begin());
  return fail(ErrorCode::kInvalidArgument,
              "--session: '" + name + "' is not one of pre, train, post, retention, transfer");
}

tl::unexpected<Error> finished(const TrialRequest& request) {
  return fail(ErrorCode::kInvalidArgument, request.folder.toStdString() + ": participant " +
                                               std::to_string(request.participant) +
                                               " has already finished the session " +
                                               request.session.toStdString());
}

/// Searches for the connected devices.
void search_devices(DriverWatch& watch) {
  QEventLoop loop;
  QObject::connect(&watch, &DriverWatch::looked, &loop, &QEventLoop::quit);
  QTimer::singleShot(kSearchMs, &loop, &QEventLoop::quit);
  watch.look();
  loop.exec();
}

/// Returns the description of the device that the user has chosen in the settings.
Result<PenDeviceInfo> find_device(DriverWatch& watch) {
  const QString chosen = Settings::the().text(QString::fromLatin1(kPenDeviceKey),
                                              QString::fromLatin1(kPenDeviceDefault));
  if (watch.knows(chosen)) search_devices(watch);
  for (PenDeviceInfo& info : pen_devices()) {
    if (info.id == chosen) return std::move(info);
  }
  return fail(
      ErrorCode::kNotFound,
      "the pen device '" +
          Settings::the().text(QString::fromLatin1(kPenDeviceLabelKey), chosen).toStdString() +
          "' is not connected. Connect it, or choose another one in the preferences of "
          "feltline-desktop.");
}

int complain(const Error& error) {
  std::fprintf(stderr, "feltline-desktop: %s\n", error.message.c_str());
  return 1;
}

/// Shows the session until it ends.
int show_session(TrialSetup setup, std::unique_ptr<PenDevice> device) {
  Studio studio({.reads_forces = true});
  studio.loop().use_device(std::move(device));
  guard_values_from_wheel();
  TrialRun run(std::move(setup.folder), std::move(setup.session), studio);
  TrialWindow window(run, studio);
  QObject::connect(&window, &TrialWindow::ended, qApp, &QApplication::quit, Qt::QueuedConnection);
  window.setGeometry(window.screen()->geometry());  // for screens without a window manager
  window.showFullScreen();
  QApplication::exec();
  window.stop();  // if a signal ended the program
  studio.loop().set_forces(false);
  if (window.is_finished()) return 0;
  std::fprintf(stderr,
               "feltline-desktop: the session was stopped. The same command continues it.\n");
  return 0;
}

}  // namespace

Result<TrialSetup> prepare_trials(const TrialRequest& request, const QString& device_label,
                                  const Capabilities& device) {
  const Result<SessionKind> kind = session_of(request);
  if (!kind) return tl::unexpected(kind.error());
  const std::string study = request.study.toStdString();
  Result<StudyFiles> files = read_study_files(study);
  if (!files) return tl::unexpected(files.error());
  // Refuses a participant or a session that the study does not have before a folder is created.
  if (const auto plan = plan_trials(files->study, request.participant, *kind); !plan) {
    return tl::unexpected(with_context(plan.error(), study));
  }
  if (auto done = check_conditions(*files, Materials::built_in(), device, study); !done) {
    Error error = done.error();
    error.message += " (device: " + device_label.toStdString() + ")";
    return tl::unexpected(std::move(error));
  }
  Result<StudyFolder> folder =
      StudyFolder::open_or_create(request.folder.toStdString(), *std::move(files));
  if (!folder) return tl::unexpected(folder.error());
  Result<FolderLock> lock = FolderLock::take(folder->path());
  if (!lock) return tl::unexpected(lock.error());
  Result<StudySession> session = folder->begin_session(
      {.participant = request.participant,
       .session = *kind,
       .device = device_label.toStdString(),
       .program = "feltline-desktop " FELT_VERSION,
       .started = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()});
  if (!session) return tl::unexpected(session.error());
  if (auto done = recover_unfinished_trials(*folder, *session); !done) {
    return tl::unexpected(done.error());
  }
  if (std::holds_alternative<SessionEnd>(next_step(folder->files().study, *session))) {
    return finished(request);
  }
  return TrialSetup{*std::move(folder), *std::move(session), *std::move(lock)};
}

int run_trials(const TrialRequest& request) {
  DriverWatch watch(make_drivers());
  const Result<PenDeviceInfo> info = find_device(watch);
  if (!info) return complain(info.error());
  Result<TrialSetup> setup = prepare_trials(request, info->label, info->capabilities);
  if (!setup) return complain(setup.error());
  Result<std::unique_ptr<PenDevice>> device = open_pen_device(info->id);
  if (!device) return complain(device.error());
  if (!HomingDialog::bring_home(**device, nullptr)) {
    return complain({ErrorCode::kIo, info->label.toStdString() + ": has not found its home "
                                                                 "position, so it cannot be used"});
  }
  return show_session(*std::move(setup), *std::move(device));
}

}  // namespace felt::desktop
