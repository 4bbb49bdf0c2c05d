#include "felt/film/film_writer.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "felt/base/ascii.h"

namespace felt {
namespace {

/// The first picture in the stream has the colours of the palette and is not shown. A palette of
/// all frames would keep all frames in the memory of ffmpeg.
constexpr const char* kGifFilter =
    "[0:v]split[a][b];[a]trim=end_frame=1,palettegen=stats_mode=full[p];"
    "[b]trim=start_frame=1,setpts=PTS-STARTPTS[v];[v][p]paletteuse=dither=none";

/// The matrix of BT.709 in full, because players guess the matrix of small films differently.
constexpr const char* kWebmFilter = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";

void append(std::vector<std::string>& words, std::initializer_list<const char*> more) {
  words.insert(words.end(), more.begin(), more.end());
}

Result<void> check(const FilmOptions& options) {
  const auto fits = [](int px) {
    return px >= FilmOptions::kMinSidePx && px <= FilmOptions::kMaxSidePx;
  };
  if (!fits(options.width_px) || !fits(options.height_px)) {
    return fail(ErrorCode::kInvalidArgument,
                "a film must be " + std::to_string(FilmOptions::kMinSidePx) + " to " +
                    std::to_string(FilmOptions::kMaxSidePx) + " pixels wide and high");
  }
  if (options.frames_per_second < 1 ||
      options.frames_per_second > FilmOptions::kMaxFramesPerSecond) {
    return fail(ErrorCode::kInvalidArgument, "a film must have 1 to " +
                                                 std::to_string(FilmOptions::kMaxFramesPerSecond) +
                                                 " frames a second");
  }
  return {};
}

}  // namespace

std::optional<FilmFormat> film_format_of(const std::string& path) {
  const auto ends_with = [&path](std::string_view ending) {
    return path.size() > ending.size() &&
           std::equal(ending.rbegin(), ending.rend(), path.rbegin(),
                      [](char a, char b) { return a == ascii_lower(b); });
  };
  if (ends_with(".webm")) return FilmFormat::kWebm;
  if (ends_with(".gif")) return FilmFormat::kGif;
  return std::nullopt;
}

std::vector<std::string> encoder_command(const FilmOptions& options) {
  const std::string size =
      std::to_string(options.width_px) + "x" + std::to_string(options.height_px);
  std::vector<std::string> words{options.program,
                                 "-nostdin",
                                 "-hide_banner",
                                 "-loglevel",
                                 "error",
                                 "-y",
                                 "-f",
                                 "rawvideo",
                                 "-pixel_format",
                                 "rgb0",
                                 "-video_size",
                                 size,
                                 "-framerate",
                                 std::to_string(options.frames_per_second),
                                 "-i",
                                 "pipe:0",
                                 "-an"};
  if (options.format == FilmFormat::kGif) {
    append(words, {"-filter_complex", kGifFilter, "-loop", "0", "-f", "gif"});
  } else {
    append(words, {"-vf",         kWebmFilter,  "-c:v",
                   "libvpx-vp9",  "-crf",       "28",
                   "-b:v",        "0",          "-deadline",
                   "realtime",    "-cpu-used",  "7",
                   "-row-mt",     "1",          "-tile-columns",
                   "1",           "-threads",   "2",
                   "-colorspace", "bt709",      "-color_primaries",
                   "bt709",       "-color_trc", "iec61966-2-1",
                   "-f",          "webm"});
  }
  append(words, {"-fflags", "+bitexact", "-flags:v", "+bitexact"});
  // The file has no name yet. Opened under this path, ffmpeg can seek in it.
  words.push_back("file:/proc/self/fd/" + std::to_string(EncoderProcess::kOutputFd));
  return words;
}

Result<FilmWriter> FilmWriter::create(const std::string& path, const FilmOptions& options,
                                      const Image* colors) {
  const std::string name = path == "-" ? "stdout" : path;
  if (auto ok = check(options); !ok) return tl::unexpected(with_context(ok.error(), name));
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  Result<EncoderProcess> encoder =
      EncoderProcess::start(encoder_command(options), file->descriptor(), options.is_cancelled);
  if (!encoder && encoder.error().code == ErrorCode::kNotFound) {
    return fail(ErrorCode::kUnsupported,
                name + ": " + options.program +
                    " is not installed, and films are made with it. Install the package ffmpeg "
                    "(Debian, Ubuntu: sudo apt install ffmpeg), or write an .svg");
  }
  if (!encoder) {
    return tl::unexpected(with_context(encoder.error(), name + ": " + options.program));
  }
  FilmWriter film(name, options, *std::move(file), *std::move(encoder));
  if (options.format != FilmFormat::kGif) return film;
  if (colors == nullptr) {
    return fail(ErrorCode::kInvalidArgument, name + ": a GIF needs a picture with its colours");
  }
  if (auto ok = film.add(*colors); !ok) return tl::unexpected(ok.error());
  return film;
}

Result<void> FilmWriter::add(const Image& frame) {
  if (frame.width() != options_.width_px || frame.height() != options_.height_px) {
    return fail(ErrorCode::kInvalidArgument, name_ + ": a frame has another size than the film");
  }
  const Result<void> sent = encoder_.send(frame.bytes());
  if (sent) return sent;
  if (options_.is_cancelled && options_.is_cancelled()) {
    return tl::unexpected(with_context(sent.error(), name_));
  }
  // The encoder reads no more, so it has ended or is about to end. Its own reason is better.
  const Result<void> ended = encoder_.finish();
  return tl::unexpected(
      with_context(ended ? sent.error() : ended.error(), name_ + ": " + options_.program));
}

Result<void> FilmWriter::finish() {
  if (Result<void> done = encoder_.finish(); !done) {
    return tl::unexpected(with_context(done.error(), name_ + ": " + options_.program));
  }
  return file_.commit();
}

}  // namespace felt
