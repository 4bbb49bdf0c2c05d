#pragma once

#include <cstddef>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/motion/ease.h"
#include "felt/motion/inbetween.h"

namespace felt {

/// How key drawings become a film.
struct KeyFilmOptions {
  int between = 12;  ///< number of in-betweens from one key drawing to the next, >= 0
  int hold = 1;      ///< number of frames for which each key drawing is shown, >= 1
  Ease ease{};       ///< speed from one key drawing to the next
  LoneStroke lone = LoneStroke::kFade;
};

/// The pictures of a film of key drawings, in their order: each key drawing, followed by the
/// in-betweens to the next one.
///
///   KeyFilm film(options);
///   for (Drawing& key : keys) film.add(std::move(key));
///   for (std::size_t i = 0; i < film.size(); ++i) show(film.picture(i), film.frames(i));
///
/// Keeps all key drawings. After the last add(), several threads may use it.
class KeyFilm {
 public:
  /// Requires that the options are in their ranges.
  explicit KeyFilm(KeyFilmOptions options) : options_(std::move(options)) {}

  /// Appends a key drawing. `pairs` are those of the step from the key drawing before it
  /// (InbetweenOptions). Fails like Inbetween::create, and then the film is unchanged.
  Result<void> add(Drawing key, std::vector<GivenPair> pairs = {});

  /// Returns the number of pictures.
  [[nodiscard]] std::size_t size() const noexcept;
  /// Returns true if a picture is a key drawing. Requires picture < size().
  [[nodiscard]] bool is_key(std::size_t picture) const noexcept { return picture % stride() == 0; }
  /// Returns the number of frames for which a picture is shown. Requires picture < size().
  [[nodiscard]] int frames(std::size_t picture) const noexcept {
    return is_key(picture) ? options_.hold : 1;
  }
  /// Returns a picture. Key drawings are returned unchanged. Requires picture < size().
  [[nodiscard]] Drawing picture(std::size_t picture) const;
  /// Returns which strokes belong together in the step from one key drawing to the next. Requires
  /// that `step` + 1 is less than the number of key drawings.
  [[nodiscard]] const Correspondence& correspondence(std::size_t step) const noexcept {
    return steps_[step].correspondence();
  }

 private:
  /// Returns the number of pictures from one key drawing to the next.
  [[nodiscard]] std::size_t stride() const noexcept {
    return static_cast<std::size_t>(options_.between) + 1;
  }

  KeyFilmOptions options_;
  std::vector<Drawing> keys_;
  std::vector<Inbetween> steps_;
};

}  // namespace felt
