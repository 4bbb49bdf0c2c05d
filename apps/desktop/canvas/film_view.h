#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <vector>

#include "desktop/canvas/canvas.h"
#include "felt/motion/key_film.h"
#include "felt/render/page_painter.h"

namespace felt::desktop {

/// Plays a film of key drawings over the canvas, again and again. The whole page is shown. While it
/// plays, it gets all input of the canvas, so that nothing is edited. Escape, a click, and every
/// change of the drawing stop it. Another thread makes the pictures; until one is ready, the film
/// waits.
class FilmView : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kFramesPerSecond = 24;
  /// Maximum size of all pictures of a film in memory. The pictures of a longer film are smaller.
  static constexpr double kMaxBytes = 256e6;

  explicit FilmView(Canvas& canvas);
  ~FilmView() override;

  /// Starts a film. Requires at least two key drawings with the same page.
  void play(std::vector<FilmKey> keys);
  /// Stops the film and hides the view.
  void stop();
  [[nodiscard]] bool is_playing() const noexcept { return work_ != nullptr; }
  /// Returns the number of pictures that are ready, and the frame that is shown.
  [[nodiscard]] std::size_t ready() const;
  [[nodiscard]] std::size_t frame() const noexcept { return frame_; }

 Q_SIGNALS:
  /// The film has stopped. `why` is empty unless it could not be made.
  void stopped(const QString& why);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Work;
  void advance();

  Canvas& canvas_;
  std::shared_ptr<Work> work_;         // shared with the thread that makes the pictures
  std::vector<std::size_t> pictures_;  // the picture of each frame
  std::size_t frame_ = 0;
  std::int64_t steps_ = 0;  // frames since the start for which the film did not wait
  QElapsedTimer clock_;
  QTimer tick_;
};

}  // namespace felt::desktop
