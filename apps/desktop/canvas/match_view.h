#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "desktop/canvas/canvas.h"
#include "felt/motion/inbetween.h"

namespace felt::desktop {

/// Shows over the canvas which lines of the current key drawing become which lines of the next one,
/// and lets the user correct it: a drag from one line to the other makes a pair, and a click on a
/// line says that it has no partner, or takes a correction of this line back. Each correction is an
/// event, and a step of undo. Escape and another drawing end it.
///
/// Lines go from the middle of one stroke to the middle of the other. Corrected matches have
/// another colour, and strokes without a partner have a circle.
class MatchView : public QWidget {
  Q_OBJECT

 public:
  /// If a key drawing has more strokes, only corrections are shown, because it would take too long
  /// to find the other matches.
  static constexpr std::size_t kMaxShown = 200;

  explicit MatchView(Canvas& canvas);

  /// Starts to show and correct matches. Returns false if the current layer is not a key drawing
  /// that has a next one.
  bool start();
  void stop();

  /// A match that is shown.
  struct Shown {
    std::optional<Point> from, to;  ///< the middle of each stroke, in mm
    bool is_given = false;
  };
  /// Returns the matches. Finds them first if the drawing has changed, which takes up to a second.
  [[nodiscard]] const std::vector<Shown>& shown();
  /// Returns how often the matches were searched.
  [[nodiscard]] int searches() const noexcept { return searches_; }

 Q_SIGNALS:
  void stopped();

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Reads the key drawings. Returns false if the current one is the last.
  bool read_keys();
  void find_matches();
  void press(QPointF at);
  void move(QPointF at);
  void release(QPointF at);
  /// Makes a pair, instead of the pairs that its strokes are in.
  void correct(const KeyPair& pair);
  /// Says that the stroke at this point has no partner, or takes its correction back.
  void toggle_at(Point at, double reach_mm);
  [[nodiscard]] std::vector<KeyPair> pairs() const;
  void send(std::vector<KeyPair> pairs);

  Canvas& canvas_;
  LayerId key_;
  KeyStrokes from_, to_;
  std::vector<Shown> shown_;
  int searches_ = 0;
  bool is_stale_ = true;            // shown_ is that of an earlier drawing
  std::optional<QPointF> pressed_;  // in pixels
  QPointF pen_;
};

}  // namespace felt::desktop
