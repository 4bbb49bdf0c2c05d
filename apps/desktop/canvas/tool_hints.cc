#include "desktop/canvas/tool_hints.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <algorithm>
#include <array>

namespace felt::desktop {
namespace {

/// What src/felt/tools/ROOM/ROOM.md says of a tool, in a few hint_text.
struct ToolHint {
  std::string_view id;
  const char* does;
  const char* first;   // with kFirstModifier; null: nothing else
  const char* second;  // with kSecondModifier; likewise
};

constexpr std::array<ToolHint, 8> kHints{{
    {"pencil",
     QT_TRANSLATE_NOOP("ToolHint",
                       "Draw; press harder for a broader line. End on a line’s end to "
                       "join it."),
     nullptr, nullptr},
    {"pull", QT_TRANSLATE_NOOP("ToolHint", "Drag a line to bend it; it goes back as you go back."),
     QT_TRANSLATE_NOOP("ToolHint", "ends and corners go along, or stay"), nullptr},
    {"smooth",
     QT_TRANSLATE_NOOP("ToolHint",
                       "Rub along a line to iron the tremor out; press to "
                       "iron harder."),
     nullptr, nullptr},
    {"width", QT_TRANSLATE_NOOP("ToolHint", "Rub a line to make it broader or thinner."),
     QT_TRANSLATE_NOOP("ToolHint", "thinner"), QT_TRANSLATE_NOOP("ToolHint", "thicker")},
    {"eraser", QT_TRANSLATE_NOOP("ToolHint", "Rub out what the ring touches."),
     QT_TRANSLATE_NOOP("ToolHint", "up to the crossings"),
     QT_TRANSLATE_NOOP("ToolHint", "whole lines")},
    {"lasso", QT_TRANSLATE_NOOP("ToolHint", "Draw round what you mean, or click a line."),
     QT_TRANSLATE_NOOP("ToolHint", "adds"), QT_TRANSLATE_NOOP("ToolHint", "takes away")},
    {"transform",
     QT_TRANSLATE_NOOP("ToolHint", "Drag inside to move, a corner to scale, outside it to turn."),
     QT_TRANSLATE_NOOP("ToolHint", "along one axis, in steps of 15°"),
     QT_TRANSLATE_NOOP("ToolHint", "a copy")},
    {"connect", QT_TRANSLATE_NOOP("ToolHint", "Drag the end of a line to another end."),
     QT_TRANSLATE_NOOP("ToolHint", "the end stays where you let it go"), nullptr},
}};

QString hint_text(const char* text) {
  return QCoreApplication::translate("ToolHint", text);
}

/// "Shift", as this system calls the key.
QString key_name(Qt::KeyboardModifier modifier) {
  QString name = QKeySequence(static_cast<int>(modifier)).toString(QKeySequence::NativeText);
  while (name.endsWith(QLatin1Char('+'))) name.chop(1);
  return name;
}

}  // namespace

QString tool_hint(std::string_view tool_id, std::string_view help, std::string_view mode) {
  if (tool_id == "pull" && mode == "push") {
    return hint_text(QT_TRANSLATE_NOOP("ToolHint", "Push lines away from the side of the pen."));
  }
  const auto found = std::find_if(kHints.begin(), kHints.end(),
                                  [&](const ToolHint& hint) { return hint.id == tool_id; });
  if (found == kHints.end()) return QString::fromUtf8(help.data(), qsizetype(help.size()));
  QString hint = hint_text(found->does);
  const auto add = [&hint](Qt::KeyboardModifier modifier, const char* what) {
    //: a key that is held, and what it does: "Shift: thinner"
    if (what)
      hint += QStringLiteral("   ") + QCoreApplication::translate("ToolHint", "%1: %2")
                                          .arg(key_name(modifier), hint_text(what));
  };
  add(Qt::ShiftModifier, found->first);
  add(Qt::ControlModifier, found->second);
  return hint;
}

}  // namespace felt::desktop
