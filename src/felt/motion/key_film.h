#pragma once

#include <cstddef>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/document/key_timing.h"
#include "felt/motion/ease.h"
#include "felt/motion/inbetween.h"

namespace felt {

/// How a film shows a key drawing, and how it goes on to the next one.
struct KeySettings {
  int between = 12;  ///< number of in-betweens to the next key drawing, >= 0
  int hold = 1;      ///< number of frames for which the key drawing is shown, >= 1
  Ease ease{};       ///< speed from this key drawing to the next one
};

/// Returns the settings of a timing, without its pairs.
KeySettings settings_of(const KeyTiming& timing);

/// Returns the pairs of a timing as those of an in-between. Leaves out those that name strokes
/// which these key drawings do not have.
std::vector<GivenPair> given_pairs(const KeyTiming& timing, const KeyStrokes& from,
                                   const KeyStrokes& to);

/// A key drawing of a film.
struct FilmKey {
  Drawing drawing;
  KeyTiming timing{};
};

/// The pictures of a film of key drawings, in their order: each key drawing, followed by the
/// in-betweens to the next one.
///
///   KeyFilm film;
///   for (FilmKey& key : keys) film.add(std::move(key));
///   for (std::size_t i = 0; i < film.size(); ++i) show(film.picture(i), film.frames(i));
///
/// Keeps all key drawings. After the last add(), several threads may use it.
class KeyFilm {
 public:
  explicit KeyFilm(LoneStroke lone = LoneStroke::kFade) : lone_(lone) {}

  /// Appends a key drawing. `pairs` are those of the step from the key drawing before it
  /// (InbetweenOptions). Requires settings in their ranges. Fails like Inbetween::create, and then
  /// the film is unchanged.
  Result<void> add(Drawing key, KeySettings settings, std::vector<GivenPair> pairs = {});
  /// Appends a key drawing with its timing. The pairs of the timing before it apply.
  Result<void> add(FilmKey key);

  /// Returns the number of pictures.
  [[nodiscard]] std::size_t size() const noexcept {
    return keys_.empty() ? 0 : keys_.back().first_picture + 1;
  }
  /// Returns true if a picture is a key drawing. Requires picture < size().
  [[nodiscard]] bool is_key(std::size_t picture) const noexcept {
    return key_of(picture).first_picture == picture;
  }
  /// Returns the number of frames for which a picture is shown. Requires picture < size().
  [[nodiscard]] int frames(std::size_t picture) const noexcept {
    return is_key(picture) ? key_of(picture).settings.hold : 1;
  }
  /// Returns a picture. Key drawings are returned unchanged. Requires picture < size().
  [[nodiscard]] Drawing picture(std::size_t picture) const;
  /// Returns which strokes belong together in the step from one key drawing to the next. Requires
  /// that `step` + 1 is less than the number of key drawings.
  [[nodiscard]] const Correspondence& correspondence(std::size_t step) const noexcept {
    return steps_[step].correspondence();
  }

 private:
  struct Key {
    Drawing drawing;
    KeySettings settings;
    std::size_t first_picture = 0;
  };
  /// Returns the key drawing at or before a picture.
  [[nodiscard]] const Key& key_of(std::size_t picture) const noexcept;

  LoneStroke lone_;
  std::vector<Key> keys_;
  std::vector<Inbetween> steps_;
  KeyTiming last_timing_;  // of the key drawing that was added last
};

}  // namespace felt
