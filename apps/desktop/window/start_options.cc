#include "desktop/window/start_options.h"

#include <QCommandLineParser>
#include <QCoreApplication>

namespace felt::desktop {
namespace {

struct Row {
  const char* name;
  const char* value;  // "" if the option is a switch
  const char* help;   // null if the option is hidden, because only the documents' tools use it
};

constexpr Row kRows[] = {
    {"new-window", "",
     QT_TRANSLATE_NOOP("Arguments", "Open a separate window with an empty drawing.")},
    {"language", "LANGUAGE",
     QT_TRANSLATE_NOOP("Arguments", "Use this UI language (en, de, nl) instead of the system's.")},
    {"record", "FILE",
     QT_TRANSLATE_NOOP(
         "Arguments",
         "Record everything that happens to the drawing, for feltline replay --as-recorded.")},
    {"measure-start", "", nullptr},
    {"screenshot", "PNG", nullptr},
    {"size", "WxH", nullptr},
    {"theme", "THEME", nullptr},
    {"panel", "NAME", nullptr},
    {"tool", "ID", nullptr},
    {"script", "EVENTS", nullptr},
    {"until-ms", "TIME", nullptr},
    {"example", "ID", nullptr},
    {"dialog", "NAME", nullptr},
};

QString option_text(const char* text) {
  return QCoreApplication::translate("Arguments", text);
}

void add_options(QCommandLineParser& parser) {
  parser.setApplicationDescription(
      option_text(QT_TRANSLATE_NOOP("Arguments", "Feltline: draw, and feel what you draw.")));
  parser.addHelpOption();
  parser.addVersionOption();
  for (const Row& row : kRows) {
    QCommandLineOption option(QString::fromLatin1(row.name),
                              row.help ? option_text(row.help) : QString(),
                              QString::fromLatin1(row.value));
    if (!row.help) option.setFlags(QCommandLineOption::HiddenFromHelp);
    parser.addOption(option);
  }
  parser.addPositionalArgument(
      QStringLiteral("FILE"),
      option_text(QT_TRANSLATE_NOOP("Arguments", "Drawings to open: .felt, .svg, .ndjson.")),
      QStringLiteral("[FILE...]"));
}

PictureRequest picture_of(const QCommandLineParser& parser) {
  PictureRequest picture;
  const auto value = [&parser](const char* name) {
    return parser.value(QString::fromLatin1(name));
  };
  picture.path = value("screenshot");
  const QStringList size = value("size").split(QLatin1Char('x'));
  if (size.size() == 2) picture.size = QSize(size[0].toInt(), size[1].toInt());
  if (parser.isSet(QStringLiteral("theme"))) picture.theme = value("theme");
  picture.panels = parser.values(QStringLiteral("panel"));
  picture.tool = value("tool");
  picture.script = value("script");
  if (parser.isSet(QStringLiteral("until-ms"))) picture.until_ms = value("until-ms").toLongLong();
  picture.example = value("example");
  picture.dialog = value("dialog");
  return picture;
}

}  // namespace

std::optional<QString> read_arguments(const QStringList& arguments, StartOptions& options) {
  QCommandLineParser parser;
  add_options(parser);
  if (!parser.parse(arguments)) return parser.errorText();
  options.files = parser.positionalArguments();
  options.new_window = parser.isSet(QStringLiteral("new-window"));
  options.measure_start = parser.isSet(QStringLiteral("measure-start"));
  options.language = parser.value(QStringLiteral("language"));
  options.record = parser.value(QStringLiteral("record"));
  options.picture = picture_of(parser);
  const QSize size = options.picture.size;
  if (size.width() < 100 || size.height() < 100 || size.width() > 8000 || size.height() > 8000) {
    return option_text(
        QT_TRANSLATE_NOOP("Arguments", "--size must be WIDTHxHEIGHT, each from 100 to 8000"));
  }
  return std::nullopt;
}

QString help_text() {
  QCommandLineParser parser;
  add_options(parser);
  return parser.helpText() + QLatin1Char('\n') +
         option_text(QT_TRANSLATE_NOOP("Arguments", "Examples:")) +
         QStringLiteral(
             "\n"
             "  feltline-desktop\n"
             "  feltline-desktop cat.felt\n"
             "  feltline-desktop --language nl drawing.svg\n"
             "  feltline-desktop --record session.ndjson\n");
}

}  // namespace felt::desktop
