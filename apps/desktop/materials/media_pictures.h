#pragma once

#include <QImage>
#include <QObject>
#include <QThreadPool>
#include <QWidget>
#include <atomic>
#include <cstdint>
#include <map>
#include <string>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// A picture of each medium that draws: a stroke from light to hard on the sheet that is chosen.
/// Made anew, beside Qt's thread, whenever sheet or media are others; until then the old ones stay.
class MediaPictures : public QObject {
  Q_OBJECT

 public:
  static constexpr QSize kSize{64, 26};  ///< device-independent pixels

  /// For widgets in this window.
  MediaPictures(Studio& studio, QWidget* window);
  ~MediaPictures() override;

  /// Null while there is none yet.
  [[nodiscard]] QImage of(const std::string& id) const;

 Q_SIGNALS:
  void changed();

 private:
  using Pictures = std::map<std::string, QImage>;

  void make();
  void take(std::uint64_t round, Pictures pictures);

  Studio& studio_;
  QWidget* window_;
  Pictures pictures_;
  std::atomic<std::uint64_t> round_{0};  // an older one is given up
  QThreadPool maker_;                    // last, so that it has ended before the rest goes
};

}  // namespace felt::desktop
