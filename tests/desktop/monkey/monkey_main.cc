// desktop_monkey --events N --seed S: exits with 0 if no failure occurred. The message of a failure
// contains its seed.
#include <QApplication>
#include <QCommandLineParser>
#include <QStandardPaths>
#include <cstdio>

#include "monkey.h"

int main(int argc, char** argv) {
  using namespace felt::desktop;
  QStandardPaths::setTestModeEnabled(true);
  QCoreApplication::setOrganizationName(QStringLiteral("feltline"));
  QCoreApplication::setApplicationName(QStringLiteral("feltline-monkey"));
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  // All files of the program go into a temporary folder.
  const QTemporaryDir home;
  for (const char* name :
       {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"}) {
    qputenv(name, home.path().toLocal8Bit());
  }
  const QApplication app(argc, argv);
  QCommandLineParser arguments;
  arguments.addHelpOption();
  arguments.addOption({QStringLiteral("events"), QStringLiteral("how many"), QStringLiteral("N"),
                       QStringLiteral("2000")});
  arguments.addOption({QStringLiteral("seed"), QStringLiteral("which ones"), QStringLiteral("S"),
                       QStringLiteral("1")});
  arguments.addOption({QStringLiteral("hang-ms"),
                       QStringLiteral("CPU time of an event that counts as a hang"),
                       QStringLiteral("MS"), QStringLiteral("200")});
  arguments.addOption({QStringLiteral("verbose"), QStringLiteral("names each event")});
  arguments.process(app);

  MonkeyOptions options;
  options.events = arguments.value(QStringLiteral("events")).toULongLong();
  options.seed = arguments.value(QStringLiteral("seed")).toULongLong();
  options.verbose = arguments.isSet(QStringLiteral("verbose"));
  options.hang_ms = arguments.value(QStringLiteral("hang-ms")).toDouble();
  MainWindow window({});
  window.resize(1200, 800);
  window.show();
  Monkey monkey(window, options);
  // Calls exit() because quit() would ask whether to save.
  QObject::connect(&monkey, &Monkey::finished, &app, [] { QCoreApplication::exit(0); });
  QApplication::setQuitOnLastWindowClosed(false);
  monkey.start();
  QApplication::exec();
  std::printf("%s\n", monkey.report().c_str());
  if (monkey.failure().empty()) return 0;
  std::fprintf(stderr, "desktop_monkey --events %llu --seed %llu: %s\n",
               static_cast<unsigned long long>(options.events),
               static_cast<unsigned long long>(options.seed), monkey.failure().c_str());
  return 1;
}
