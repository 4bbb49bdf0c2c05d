#include "timelapse_input.h"

#include <array>
#include <utility>

#include "felt/formats/drawing_materials.h"
#include "felt/formats/drawing_reader.h"
#include "felt/store/felt_file.h"
#include "input.h"
#include "known_materials.h"
#include "replay_arguments.h"
#include "replay_input.h"
#include "sketch_input.h"

namespace felt::cli {
namespace {

Result<std::string> read_text_of(const Input& input) {
  std::string text;
  const ReadBytes read = input.reader();
  std::array<char, std::size_t{1} << 16> block{};
  std::size_t max_bytes = 0;
  for (;;) {
    const Result<std::size_t> count = read(block);
    if (!count) return tl::unexpected(with_context(count.error(), input.name()));
    if (*count == 0) return text;
    text.append(block.data(), *count);
    if (max_bytes == 0) max_bytes = format_of_bytes(text) ? kMaxFeltBytes : kMaxUnrecognisedBytes;
    if (text.size() > max_bytes) {
      return fail(ErrorCode::kLimitExceeded,
                  input.name() + ": is larger than " + std::to_string(max_bytes) + " bytes");
    }
  }
}

Result<void> read_script_input(const Input& input, const TimelapseFiles& files,
                               TimelapseInput& timelapse) {
  const Result<std::string> text = read_text_of(input);
  if (!text) return tl::unexpected(text.error());
  const ReplayArguments pen;
  const Result<bool> is_recorded =
      use_script({input.name(), *text, folder_of(input.name()), pen.settings()}, timelapse);
  if (!is_recorded) return tl::unexpected(is_recorded.error());
  // A script that a hand has drawn names its imports with their folder.
  timelapse.source.read_import = reads_imports(*is_recorded ? files.input : "", {files.output});
  return {};
}

Result<void> read_drawing_input(const Input& input, const TimelapseFiles& files,
                                TimelapseInput& timelapse) {
  const Result<Imported> opened = input.read_drawing({});
  if (!opened) return tl::unexpected(with_context(opened.error(), input.name()));
  timelapse.source.read_import = reads_imports(files.input, {files.output});
  timelapse.report = opened->report;
  return use_newest_recording(input.name(), opened->drawing, timelapse);
}

}  // namespace

Result<TimelapseInput> read_timelapse(const TimelapseFiles& files, Console& console) {
  const std::string& on = files.on;
  const Result<Input> input = Input::open(files.input);
  if (!input) return tl::unexpected(with_context(input.error(), input_name(files.input)));
  TimelapseInput timelapse;
  timelapse.source.materials = known_materials(console).materials;
  if (!on.empty()) {
    Result<Drawing> start = read_start(on);
    if (!start) return tl::unexpected(start.error());
    timelapse.source.materials =
        with_texts(start->materials, std::move(timelapse.source.materials));
    timelapse.frame.page = start->page;
    timelapse.frame.has_page = start->has_page;
    timelapse.source.start = *std::move(start);
  }
  Result<void> done;
  if (input->format() == FileFormat::kFelt) {
    if (!on.empty()) {
      return fail(ErrorCode::kUnsupported,
                  input->name() +
                      ": --on is for scripts; the recording of a .felt file begins with "
                      "an empty page");
    }
    done = read_drawing_input(*input, files, timelapse);
  } else if (input->format() == FileFormat::kNdjson) {
    done = read_script_input(*input, files, timelapse);
  } else {
    return fail(ErrorCode::kUnsupported,
                input->name() + ": neither an event script (.ndjson) nor a .felt file");
  }
  if (!done) return tl::unexpected(done.error());
  report_notices(input->name(), timelapse.report, console);
  if (Result<void> any = check_has_moments(input->name(), timelapse); !any) {
    return tl::unexpected(any.error());
  }
  return timelapse;
}

}  // namespace felt::cli
