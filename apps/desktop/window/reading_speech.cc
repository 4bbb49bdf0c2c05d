#include "desktop/window/reading_speech.h"

#include <QAccessible>
#include <QColor>
#include <QLocale>
#include <array>
#include <cmath>

#include "desktop/engine/text_of.h"
#include "felt/document/fill.h"

namespace felt::desktop {
namespace {

/// The end of a range of hues, in degrees, and its name.
struct HueName {
  int until;
  const char* name;
};

constexpr std::array kHues{
    HueName{15, QT_TRANSLATE_NOOP("felt::desktop::ReadingSpeech", "red")},
    HueName{45, QT_TRANSLATE_NOOP("felt::desktop::ReadingSpeech", "orange")},
    HueName{70, QT_TRANSLATE_NOOP("felt::desktop::ReadingSpeech", "yellow")},
    HueName{165, QT_TRANSLATE_NOOP("felt::desktop::ReadingSpeech", "green")},
    HueName{200, QT_TRANSLATE_NOOP("felt::desktop::ReadingSpeech", "turquoise")},
    HueName{255, QT_TRANSLATE_NOOP("felt::desktop::ReadingSpeech", "blue")},
    HueName{290, QT_TRANSLATE_NOOP("felt::desktop::ReadingSpeech", "violet")},
    HueName{345, QT_TRANSLATE_NOOP("felt::desktop::ReadingSpeech", "pink")},
    HueName{361, QT_TRANSLATE_NOOP("felt::desktop::ReadingSpeech", "red")}};

}  // namespace

QString color_word(Rgba color) {
  const QColor shown(color.r, color.g, color.b);
  const int value = shown.value();
  if (value < 50) return ReadingSpeech::tr("black");
  if (shown.hsvSaturation() < 45) {
    if (value > 225) return ReadingSpeech::tr("white");
    return value < 120 ? ReadingSpeech::tr("dark grey") : ReadingSpeech::tr("grey");
  }
  const int hue = shown.hsvHue();
  if (hue >= 15 && hue < 50 && value < 170) return ReadingSpeech::tr("brown");
  for (const HueName& row : kHues) {
    if (hue < row.until) return ReadingSpeech::tr(row.name);
  }
  return {};
}

QString reading_words(const Reading& reading, const Document& document) {
  switch (reading.kind) {
    case Reading::Kind::kNothing:
      return {};
    case Reading::Kind::kLine: {
      const StrokePtr line = document.find(reading.stroke);
      const QString color = line ? color_word(line->color()) : QString();
      return ReadingSpeech::tr("line, %1, %2 mm")
          .arg(color, QLocale().toString(std::round(reading.length_mm), 'f', 0));
    }
    case Reading::Kind::kEnd:
      return ReadingSpeech::tr("end");
    case Reading::Kind::kCrossing:
      return ReadingSpeech::tr("crossing of %1 lines").arg(reading.lines);
    case Reading::Kind::kFill: {
      const FillPtr fill = document.find_fill(reading.fill);
      return ReadingSpeech::tr("fill, %1").arg(fill ? color_word(fill->color) : QString());
    }
  }
  return {};
}

ReadingSpeech::ReadingSpeech(Studio& studio, Canvas& canvas)
    : QObject(&canvas), studio_(studio), canvas_(canvas) {
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseMs);
  connect(&pause_, &QTimer::timeout, this, &ReadingSpeech::speak);
  connect(&studio, &Studio::shown, this, &ReadingSpeech::follow);
  connect(&studio, &Studio::layer_changed, this, &ReadingSpeech::say_layer);
  connect(&studio, &Studio::tool_changed, this, [this] {
    if (!studio_.session().tool().reading()) say({});
  });
}

void ReadingSpeech::follow() {
  const Reading* reading = studio_.session().tool().reading();
  if (!reading || reading->news == news_) return;
  news_ = reading->news;
  say(reading_words(*reading, studio_.session().seen()));
}

void ReadingSpeech::say_layer() {
  const Layer* layer = studio_.session().document().layer(studio_.session().layer());
  if (studio_.session().tool().reading() && layer) say(tr("layer %1").arg(text_of(layer->name)));
}

void ReadingSpeech::say(const QString& words) {
  next_ = words;
  pause_.start();
}

void ReadingSpeech::speak() {
  words_ = next_;
  const QString area = Canvas::tr("Drawing area");
  canvas_.setAccessibleName(words_.isEmpty() ? area : tr("%1: %2").arg(area, words_));
  Q_EMIT spoken(words_);
  if (words_.isEmpty()) return;
  QAccessibleEvent alert(&canvas_, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

}  // namespace felt::desktop
