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

/// Makes a picture of each medium for drawing: a stroke from light to strong pressure on the
/// current surface, in the colour of the ink. When one of these or a medium changes, another thread
/// makes new pictures; the old pictures are used until the new ones are ready.
class MediaPictures : public QObject {
  Q_OBJECT

 public:
  static constexpr QSize kSize{64, 26};  ///< device-independent pixels

  /// Makes pictures for the screen of this window.
  MediaPictures(Studio& studio, QWidget* window);
  ~MediaPictures() override;

  /// Returns the picture of a medium; null if it was not made yet.
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
  std::atomic<std::uint64_t> round_{0};  // number of the newest request for pictures; work for
                                         // older requests is abandoned
  QThreadPool maker_;                    // the last member, so that its work ends before the other
                                         // members are destroyed
};

}  // namespace felt::desktop
