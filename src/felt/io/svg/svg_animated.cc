#include "felt/io/svg/svg_animated.h"

#include <cstdint>

#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/svg/svg_compact.h"

namespace felt {
namespace {

/// A time of the film.
struct FilmTime {
  std::int64_t frame = 0, frames = 0;
};

/// Returns the time as a share of the film.
void append_share(std::string& out, const FilmTime& time) {
  append_number(out, static_cast<double>(time.frame) / static_cast<double>(time.frames));
}

/// Appends the element that shows its parent from `start` to `end`.
void append_turn(std::string& out, const FilmTime& start, const FilmTime& end, double seconds) {
  const bool is_first = start.frame == 0, is_last = end.frame == end.frames;
  if (is_first && is_last) return;
  out +=
      "<animate attributeName=\"visibility\" calcMode=\"discrete\" repeatCount=\"indefinite\" "
      "dur=\"";
  append_number(out, seconds);
  out += "s\" values=\"";
  out += is_first ? "visible;hidden" : is_last ? "hidden;visible" : "hidden;visible;hidden";
  out += "\" keyTimes=\"0";
  if (!is_first) {
    out += ';';
    append_share(out, start);
  }
  if (!is_last) {
    out += ';';
    append_share(out, end);
  }
  out += "\"/>\n";
}

}  // namespace

Result<std::string> svg_animated_text(std::span<const AnimatedPicture> pictures,
                                      const AnimatedSvgOptions& options) {
  std::int64_t frames = 0;
  for (const AnimatedPicture& picture : pictures) frames += picture.frames;
  if (frames <= 0) return fail(ErrorCode::kInvalidArgument, "a film needs at least one picture");
  std::string text;
  append_compact_head(text, options.area, options.paper);
  FilmTime start{0, frames};
  for (const AnimatedPicture& picture : pictures) {
    const FilmTime end{start.frame + picture.frames, frames};
    text += start.frame == 0 ? "<g>\n" : "<g visibility=\"hidden\">\n";
    append_turn(text, start, end, static_cast<double>(frames) / options.frames_per_second);
    if (Result<void> done = append_compact_ink(text, picture.drawing); !done) {
      return tl::unexpected(done.error());
    }
    text += "</g>\n";
    start = end;
  }
  text += "</svg>\n";
  return text;
}

}  // namespace felt
