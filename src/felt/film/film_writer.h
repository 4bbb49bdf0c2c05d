#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "felt/base/atomic_file.h"
#include "felt/base/result.h"
#include "felt/film/encoder_process.h"
#include "felt/render/image.h"

namespace felt {

/// The formats of films.
enum class FilmFormat : std::uint8_t {
  kWebm,  ///< VP9 in WebM: small, plays in browsers and in most programs
  kGif,   ///< at most 256 colours, repeats; plays everywhere that shows pictures
};

/// The size, the speed and the format of a film.
struct FilmOptions {
  static constexpr int kMinSidePx = 16;
  static constexpr int kMaxSidePx = 8192;
  static constexpr int kMaxFramesPerSecond = 100;  ///< the shortest delay of a GIF is 0.01 s

  FilmFormat format = FilmFormat::kWebm;
  int width_px = 0;            ///< kMinSidePx..kMaxSidePx; odd sizes are allowed
  int height_px = 0;           ///< as for the width
  int frames_per_second = 24;  ///< 1..kMaxFramesPerSecond
  /// The encoder. Tests use another program.
  std::string program = "ffmpeg";
  /// If set and it returns true, a call that waits for the encoder fails with "cancelled".
  std::function<bool()> is_cancelled{};
};

/// Writes a film frame by frame. The program ffmpeg encodes it in a process of its own:
///
///   Result<FilmWriter> film = FilmWriter::create("out.webm", options, nullptr);
///   for (...) film->add(frame);
///   film->finish();
///
/// The file gets its name when finish() succeeds (AtomicFile); until then, and after an error or
/// the destructor, the previous file of that name stays and nothing is left behind. Memory does not
/// depend on the number of frames. Equal frames give equal files with the same version of ffmpeg.
/// Messages begin with the name of the file. Not thread-safe.
class FilmWriter {
 public:
  /// Starts the encoder. A GIF needs `colors`: a picture with the size of a frame whose colours are
  /// those of the film, for example its last frame; other formats ignore it.
  ///
  /// Fails if an option is out of range, if the file cannot be written, or if ffmpeg is not
  /// installed (kUnsupported; the message says how to install it).
  static Result<FilmWriter> create(const std::string& path, const FilmOptions& options,
                                   const Image* colors);

  /// Appends a frame. Its transparency is ignored. Waits while the encoder is slower. Fails if the
  /// frame has another size than the film, or if the encoder fails; the message has its reason.
  Result<void> add(const Image& frame);
  /// Completes the film. Fails if the encoder fails, or if the file cannot be written. Call it
  /// once, after at least one frame.
  Result<void> finish();

 private:
  FilmWriter(std::string name, const FilmOptions& options, AtomicFile file, EncoderProcess encoder)
      : name_(std::move(name)),
        options_(options),
        file_(std::move(file)),
        encoder_(std::move(encoder)) {}

  std::string name_;
  FilmOptions options_;
  AtomicFile file_;
  EncoderProcess encoder_;
};

/// Returns the format of a film by the ending of its name, in any case; nullopt if it is no film.
std::optional<FilmFormat> film_format_of(const std::string& path);

/// Returns the command line that encodes a film: raw frames from stdin, the film to the descriptor
/// EncoderProcess::kOutputFd.
std::vector<std::string> encoder_command(const FilmOptions& options);

}  // namespace felt
