#pragma once

#include <QObject>
#include <QTimer>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/studio.h"
#include "felt/tools/reading.h"

namespace felt::desktop {

/// Returns what is under the pen in words: "line, black, 120 mm", "end", "crossing of 3 lines",
/// "fill, red"; empty for empty paper.
QString reading_words(const Reading& reading, const Document& document);
/// Returns the usual name of a colour: "black", "dark grey", "red" ...
QString color_word(Rgba color);

/// Announces what the tool Read finds under the pen to screen readers and in the status line, and
/// the name of the layer when another one is chosen.
///
/// The words become a part of the accessible name of the drawing area, and an alert tells screen
/// readers to speak it. (Qt 6.8 has an event for announcements; earlier versions do not.) If the
/// pen moves on quickly, only the last words are spoken, after kPauseMs.
class ReadingSpeech : public QObject {
  Q_OBJECT

 public:
  static constexpr int kPauseMs = 150;

  ReadingSpeech(Studio& studio, Canvas& canvas);
  /// Returns the last words.
  [[nodiscard]] const QString& words() const noexcept { return words_; }

 Q_SIGNALS:
  void spoken(const QString& words);

 private:
  void follow();
  void say_layer();
  void say(const QString& words);
  void speak();

  Studio& studio_;
  Canvas& canvas_;
  std::uint32_t news_ = 0;
  QString next_, words_;
  QTimer pause_;
};

}  // namespace felt::desktop
