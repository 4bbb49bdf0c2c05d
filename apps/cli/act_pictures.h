#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/render/image.h"
#include "overlay_picture.h"

namespace felt::cli {

/// Watches one act of the demonstration and makes its picture. The picture has three panels that
/// show the changed part of the page: before, in progress with the tool's overlay, and after.
///
/// "Before" shows the moment at which the pen first touches the surface with the act's tool; "in
/// progress" shows the last moment of the gesture that begins with this touch.
class ActPictures {
 public:
  /// `act` is a name like "2-pull" or "13-pencil-gestures", for an act with the tool "pull" or
  /// "pencil".
  explicit ActPictures(std::string_view act);

  /// Call it every few milliseconds while the act is played.
  void see(const Session& session, const PenSample& pen);

  /// Draws the picture, about `width_px` wide. `after` is the session at the end of the act. Fails
  /// if the pen never touched the surface with the act's tool, or if the picture is too large.
  [[nodiscard]] Result<Image> draw(const Session& after, int width_px) const;

 private:
  std::string tool_;
  std::optional<SessionView> before_;
  std::optional<SessionView> in_progress_;
  bool is_over_ = false;  // the gesture that the picture shows is over
};

}  // namespace felt::cli
