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
    {"trial", "STUDY",
     QT_TRANSLATE_NOOP("Arguments",
                       "Run a session of a study with a participant, on the whole screen.")},
    {"output", "FOLDER",
     QT_TRANSLATE_NOOP("Arguments", "The folder for the results of --trial (also -o).")},
    {"participant", "NUMBER",
     QT_TRANSLATE_NOOP("Arguments", "The number of the participant, from 1 to 9999.")},
    {"session", "NAME",
     QT_TRANSLATE_NOOP("Arguments",
                       "The session: pre, train (if not given), post, retention or transfer.")},
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
    QStringList names{QString::fromLatin1(row.name)};
    if (names.front() == QStringLiteral("output")) names.push_front(QStringLiteral("o"));
    QCommandLineOption option(names, row.help ? option_text(row.help) : QString(),
                              QString::fromLatin1(row.value));
    if (!row.help) option.setFlags(QCommandLineOption::HiddenFromHelp);
    parser.addOption(option);
  }
  parser.addPositionalArgument(
      QStringLiteral("FILE"),
      option_text(QT_TRANSLATE_NOOP("Arguments", "Drawings to open: .felt, .svg, .ndjson.")),
      QStringLiteral("[FILE...]"));
}

/// Sets the request from the arguments. Returns an error message or nullopt.
std::optional<QString> read_trial(const QCommandLineParser& parser, TrialRequest& trial) {
  trial.study = parser.value(QStringLiteral("trial"));
  trial.folder = parser.value(QStringLiteral("output"));
  trial.participant = parser.value(QStringLiteral("participant")).toInt();
  if (parser.isSet(QStringLiteral("session"))) {
    trial.session = parser.value(QStringLiteral("session"));
  }
  const bool is_wanted = parser.isSet(QStringLiteral("trial"));
  for (const char* name : {"output", "participant", "session"}) {
    if (is_wanted || !parser.isSet(QString::fromLatin1(name))) continue;
    return option_text(QT_TRANSLATE_NOOP("Arguments", "--%1 needs --trial"))
        .arg(QString::fromLatin1(name));
  }
  if (!is_wanted) return std::nullopt;
  if (trial.study.isEmpty() || trial.folder.isEmpty() || trial.participant < 1) {
    return option_text(QT_TRANSLATE_NOOP(
        "Arguments", "--trial needs a study, -o FOLDER and --participant NUMBER (from 1)"));
  }
  if (!parser.positionalArguments().isEmpty()) {
    return option_text(QT_TRANSLATE_NOOP("Arguments", "--trial opens no drawings"));
  }
  return std::nullopt;
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
  picture.file = parser.positionalArguments().value(0);
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
  if (const auto wrong = read_trial(parser, options.trial)) return wrong;
  options.picture = picture_of(parser);
  if (!options.picture.path.isEmpty() && options.files.size() > 1) {
    return option_text(QT_TRANSLATE_NOOP("Arguments", "--screenshot shows one drawing only"));
  }
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
             "  feltline-desktop --record session.ndjson\n"
             "  feltline-desktop --trial study.toml -o results --participant 3\n");
}

}  // namespace felt::desktop
