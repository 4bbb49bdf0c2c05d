#include "desktop/files/timelapse_file.h"

#include <string>
#include <utility>

#include "desktop/files/drawing_file.h"
#include "felt/base/read_file.h"
#include "felt/base/same_file.h"
#include "felt/devices/simulated/scripted_hand.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_grain.h"
#include "felt/formats/drawing_reader.h"
#include "felt/replay/guarded_imports.h"
#include "felt/store/felt_file.h"
#include "felt/timelapse/timelapse_input.h"

namespace felt::desktop {
namespace {

Result<VisibleInk> read_imported(const std::string& path) {
  return open_drawing(QString::fromStdString(path)).map([](const Imported& opened) {
    return visible_ink(opened.drawing.document);
  });
}

/// Reads a script or a drawing with a recording.
Result<void> read_recording_file(const std::string& name, const std::string& output,
                                 TimelapseInput& input) {
  const Result<std::string> bytes =
      read_regular_file(name, [&name](std::string_view head, std::uint64_t size) {
        return check_drawing_head(head, size, name);
      });
  if (!bytes) return tl::unexpected(bytes.error());
  const Result<FileFormat> format = readable_format(*bytes, name);
  if (!format) return tl::unexpected(with_context(format.error(), name));
  const std::string folder = name.substr(0, name.find_last_of('/') + 1);
  input.source.read_import = guarded_imports(folder, {output}, read_imported);
  if (*format == FileFormat::kFelt) {
    const Result<Imported> opened = parse_drawing(*bytes, name);
    if (!opened) return tl::unexpected(with_context(opened.error(), name));
    input.report = opened->report;
    return use_newest_recording(name, opened->drawing, input);
  }
  if (*format != FileFormat::kNdjson) {
    return fail(ErrorCode::kUnsupported,
                name + ": neither an event script (.ndjson) nor a .felt file");
  }
  // As in `feltline replay`, the pen and the hand that a script needs are those of the defaults.
  ReplaySettings pen =
      replay_settings(*find_stylus_preset("touch"), *find_hand("typical"), true, {}, {});
  pen.read_import = read_imported;
  const Result<bool> is_recorded = use_script({name, *bytes, folder, std::move(pen)}, input);
  if (!is_recorded) return tl::unexpected(is_recorded.error());
  if (!*is_recorded) input.source.read_import = guarded_imports("", {output}, read_imported);
  return {};
}

Result<TimelapseInput> read_input(const std::string& output, const TimelapseRequest& request) {
  const std::string name = request.recording.toStdString();
  if (!name.empty() && is_same_file(name, output)) {
    return fail(ErrorCode::kInvalidArgument,
                output +
                    ": is the recording, which the film would overwrite; nothing was "
                    "written. Choose another file");
  }
  TimelapseInput input;
  input.source.materials = request.materials;
  input.source.start = request.start;
  input.frame.page = request.start.page;
  input.frame.has_page = request.start.has_page;
  input.source.read_import = guarded_imports("", {output}, read_imported);
  const Result<void> done = request.drawing ? use_newest_recording(name, *request.drawing, input)
                                            : read_recording_file(name, output, input);
  if (!done) return tl::unexpected(done.error());
  if (Result<void> any = check_has_moments(name, input); !any) return tl::unexpected(any.error());
  return input;
}

}  // namespace

Result<void> make_timelapse(const QString& path, const TimelapseRequest& request,
                            TimelapseProgress& progress) {
  const std::string output = path.toStdString(), name = request.recording.toStdString();
  Result<TimelapseInput> input = read_input(output, request);
  if (!input) return tl::unexpected(input.error());
  progress.report = std::move(input->report);
  TimelapseSource& source = input->source;
  source.is_cancelled = [&progress] { return progress.is_cancelled.load(); };
  const Result<TimelapseSurvey> survey = survey_recording(source);
  if (!survey) return tl::unexpected(with_context(survey.error(), name));
  TimelapseFilm film;
  film.format = request.format;
  film.length.seconds = request.seconds;
  const Rect ink = survey->ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : survey->ink;
  film.area = input->frame.has_page ? input->frame.page.area() : ink.inflated(kFilmMarginMm);
  film.size = film_size(request.longer_px, film.area);
  if (input->frame.has_page) film.paper = input->frame.page.paper;
  if (film.format != TimelapseFormat::kSvg && film.paper.a != 255)
    film.paper = {255, 255, 255, 255};
  if (request.grain && film.format != TimelapseFormat::kSvg) {
    const Result<Grain> grain = grain_of(survey->end, source.materials);
    if (!grain) return tl::unexpected(with_context(grain.error(), name));
    film.grain = *grain;
  }
  film.program = request.program;
  film.on_frame = [&progress](std::int64_t done, std::int64_t all) {
    progress.all = all;
    progress.done = done;
  };
  return write_timelapse(output, name, source, *survey, film);
}

}  // namespace felt::desktop
