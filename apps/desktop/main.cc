#include <QApplication>
#include <QIcon>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <span>

#include "desktop/engine/driver_watch.h"
#include "desktop/engine/recording_file.h"
#include "desktop/files/instance.h"
#include "desktop/help/examples.h"
#include "desktop/trial/trial_start.h"
#include "desktop/window/language.h"
#include "desktop/window/picture.h"
#include "desktop/window/signal_watch.h"
#include "desktop/window/start_options.h"
#include "desktop/window/start_watch.h"
#include "desktop/window/theme.h"
#include "desktop/window/windows.h"
#include "felt/base/standard_streams.h"
#include "felt/devices/drivers.h"

namespace {

using namespace felt::desktop;

bool has(std::span<char*> arguments, std::initializer_list<const char*> names) {
  return std::any_of(arguments.begin(), arguments.end(), [&](const char* argument) {
    return std::any_of(names.begin(), names.end(),
                       [&](const char* name) { return std::strcmp(argument, name) == 0; });
  });
}

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value && *value;
}

bool has_display(std::span<char*> arguments) {
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY") || is_set("QT_QPA_PLATFORM") ||
         has(arguments, {"-platform", "--platform"});
}

/// Prints a message of Qt. After a fatal message, ends the program; Qt itself would abort with a
/// core file, for example if the display does not answer.
void say_and_leave(QtMsgType type, const QMessageLogContext&, const QString& text) {
  std::fprintf(stderr, "%s\n", qPrintable(text));
  if (type != QtFatalMsg) return;
  std::fputs("feltline-desktop: the display cannot be used.\n", stderr);
  std::_Exit(1);
}

/// Handles the options that need no display. Returns true if the program has nothing else to do.
bool answer(int argc, char** argv) {
  const std::span arguments(argv, std::size_t(argc));
  const bool wants_help = has(arguments, {"--help", "-h"});
  if (!wants_help && !has(arguments, {"--version", "-v"})) return false;
  const QCoreApplication app(argc, argv);
  StartOptions options;
  static_cast<void>(read_arguments(QCoreApplication::arguments(), options));
  use_language(options.language);
  const QString text =
      wants_help ? help_text() : QStringLiteral("feltline-desktop " FELT_VERSION "\n");
  std::fputs(qPrintable(text), stdout);
  return true;
}

void set_names() {
  QCoreApplication::setOrganizationName(QStringLiteral("feltline"));
  QCoreApplication::setApplicationName(QStringLiteral("feltline-desktop"));
  QCoreApplication::setApplicationVersion(QStringLiteral(FELT_VERSION));
}

/// Makes Qt deliver every motion of mouse, fingers and pen, however late the program reads them.
/// Must be called after the constructor of QApplication, because the plugin for X11 turns the
/// compression of events on while it is loaded.
void keep_every_motion() {
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
  QCoreApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
}

void dress() {
  QApplication::setApplicationDisplayName(QString());
  QGuiApplication::setDesktopFileName(QStringLiteral("org.feltline.Feltline"));
  const QIcon ours(QStringLiteral(":/icons/org.feltline.Feltline.svg"));
  QApplication::setWindowIcon(QIcon::fromTheme(QStringLiteral("org.feltline.Feltline"), ours));
}

/// Handles another start of the program, which passes files to open here, or only asks to show a
/// window.
void serve(Windows& windows, const QStringList& files) {
  for (const QString& file : files) {
    bring_forward(*windows.open_file(file));
  }
  if (!files.isEmpty()) return;
  const QWidgetList shown = QApplication::topLevelWidgets();
  for (QWidget* widget : shown) {
    if (auto* window = qobject_cast<MainWindow*>(widget)) return bring_forward(*window);
  }
}

int run(const StartOptions& options) {
  Instance instance;
  const bool is_apart = options.new_window || !options.record.isEmpty() || options.measure_start ||
                        !options.picture.example.isEmpty();
  if (!is_apart && instance.hand_over(options.files)) return 0;
  DriverWatch drivers(felt::make_drivers());
  StudioOptions studio;
  studio.device = chosen_pen_device();  // if a driver provides it, it is used once it is found
  const std::unique_ptr<RecordingFile> recording = record_into(options.record, studio);
  Windows windows(std::move(studio));
  QObject::connect(&instance, &Instance::wanted, &windows,
                   [&windows](const QStringList& files) { serve(windows, files); });
  QStringList files = options.files;
  if (files.isEmpty() && !options.new_window) files.push_back(Windows::last_file());
  if (files.isEmpty()) files.push_back(QString());
  MainWindow* first = nullptr;
  if (!options.picture.example.isEmpty()) {
    const QString& id = options.picture.example;
    first = windows.open_drawing(example_document(id), id, nullptr);
    files.clear();
  }
  for (const QString& file : files) {
    MainWindow* window = windows.open_file(file);
    if (!first) first = window;
  }
  if (recording && !recording->error().isEmpty()) {
    std::fprintf(stderr, "feltline-desktop: %s\n", qPrintable(recording->error()));
    return 1;
  }
  if (options.measure_start && first) new StartWatch(first->canvas());
  const SignalWatch signals;
  QObject::connect(&signals, &SignalWatch::asked, &windows, [&windows] {
    windows.release();
    QApplication::exit(0);  // also ends the event loops of dialogs
  });
  const int code = QApplication::exec();
  windows.end();
  return code;
}

/// Runs a session of a study. It looks the same for all participants, whatever theme was chosen.
int run_study(const TrialRequest& request) {
  apply_theme(Theme::kLight);
  const SignalWatch signals;
  QObject::connect(&signals, &SignalWatch::asked, qApp, [] { QApplication::exit(0); });
  return run_trials(request);
}

}  // namespace

int main(int argc, char** argv) {
  felt::open_standard_streams();
  set_names();
  if (answer(argc, argv)) return 0;
  const std::span arguments(argv, std::size_t(argc));
  const bool is_picture = has(arguments, {"--screenshot"});
  if (is_picture && !is_set("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  // For a picture, the settings are in an empty temporary folder, so that neither the user's
  // settings nor those of a previous picture are used.
  std::optional<QTemporaryDir> nobodys;
  if (is_picture) {
    if (nobodys.emplace().isValid()) qputenv("HOME", nobodys->path().toLocal8Bit());
    QStandardPaths::setTestModeEnabled(true);
  }
  if (!has_display(arguments)) {
    std::fputs(
        "feltline-desktop: there is no display: neither WAYLAND_DISPLAY nor DISPLAY is set. "
        "The program feltline draws and converts without one.\n",
        stderr);
    return 1;
  }
  qInstallMessageHandler(say_and_leave);
  const QApplication app(argc, argv);
  keep_every_motion();
  StartOptions options;
  if (const auto wrong = read_arguments(QCoreApplication::arguments(), options)) {
    std::fprintf(stderr, "feltline-desktop: %s\n", qPrintable(*wrong));
    return 2;
  }
  use_language(options.language);
  dress();
  if (!options.picture.path.isEmpty()) return make_picture(options.picture);
  if (!options.trial.study.isEmpty()) return run_study(options.trial);
  follow_theme_setting();
  return run(options);
}
