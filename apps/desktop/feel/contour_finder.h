#pragma once

#include <QObject>
#include <QThreadPool>
#include <cstddef>
#include <memory>
#include <vector>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Finds the contours of the pictures in visible, locked layers. The search runs on a thread of its
/// own, once for each picture and size.
class ContourFinder : public QObject {
  Q_OBJECT

 public:
  /// True if the program was built with the layer contour; otherwise nothing is ever found.
  static bool is_built_in() noexcept;

  ContourFinder(Studio& studio, QObject* parent);
  /// Waits for the search that is running.
  ~ContourFinder() override { pool_.clear(); }

  /// Returns polylines on the page, mm, as many as UseEdges allows; none while it is off.
  [[nodiscard]] std::vector<std::vector<Point>> contours() const;
  /// Switches the search on or off; at first it is off.
  void set_on(bool on);

 Q_SIGNALS:
  /// Emitted when contours() changes.
  void changed();

 private:
  using Contours = std::shared_ptr<const std::vector<std::vector<Point>>>;

  /// A picture on the page.
  struct Place {
    std::shared_ptr<const PictureData> data;
    Affine place;
    Contours contours = {};  ///< in pixels; null until they are found

    [[nodiscard]] double mm_per_px() const noexcept;
  };

  void update_layers();
  [[nodiscard]] Contours known_contours(const Place& place) const;
  void search(const Place& place);
  void set_contours(const std::shared_ptr<const PictureData>& data, double mm_per_px,
                    const Contours& found);

  Studio& studio_;
  bool is_on_ = false;
  std::vector<Place> places_;
  QThreadPool pool_;  // destroyed first
};

}  // namespace felt::desktop
