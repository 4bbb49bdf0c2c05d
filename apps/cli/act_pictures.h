#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/render/image.h"
#include "overlay_picture.h"

namespace felt::cli {

/// Watches one act of the demonstration and makes its picture: before | in work, with what the tool
/// shows | after, of the part of the sheet where something happened.
///
/// "Before" is when the act's tool first touches, "in work" the last moment of that gesture.
class ActPictures {
 public:
  /// An act "2-pull" is about the tool "pull".
  explicit ActPictures(std::string_view act);

  /// Call it each few milliseconds while the act is played.
  void see(const Session& session, const PenSample& pen);

  /// The picture, about `width_px` wide. `after` is the session when the act is over. Error: the
  /// act's tool never touched, or the picture is too large.
  [[nodiscard]] Result<Image> draw(const Session& after, int width_px) const;

 private:
  std::string tool_;
  std::optional<SessionView> before_;
  std::optional<SessionView> in_work_;
  bool is_over_ = false;  // the first gesture is
};

}  // namespace felt::cli
