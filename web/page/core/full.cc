// The readers of files and the replay of scripts: only in the full module.

#include <algorithm>
#include <utility>

#include "desktop/files/lost_words.h"
#include "felt/base/check.h"
#include "felt/formats/format_traits.h"
#include "felt/formats/line_drawing.h"
#include "felt/formats/lost_objects.h"
#include "felt/formats/plain_edit.h"
#include "felt/io/events/event_reader.h"
#include "felt/io/inkml/inkml_import.h"
#include "felt/io/inkml/inkml_writer.h"
#include "felt/io/svg/svg_import.h"
#include "felt/io/xopp/xopp_import.h"
#include "felt/replay/replay_machine.h"
#include "felt/replay/script_feed.h"
#include "felt/store/felt_file.h"
#include "web/page/core/files.h"

namespace felt::page {
namespace {

/// Plays a script as ScriptRun of the programs does.
Result<void> play(ReplayMachine& machine, std::string_view script) {
  ScriptFeed* running = nullptr;
  const auto play_added = [&]() -> Result<void> {
    if (Result<void> rested = running->rest(); !rested) return rested;
    if (Result<void> played = machine.play(); !played) return played;
    running->begin_play(machine.next_ns());
    return {};
  };
  FeedSink sink;
  sink.event = [&machine](const Event& event) { return machine.add(event); };
  sink.stroke_begins = [&machine] { machine.begin_stroke(); };
  sink.stroke_drawn = [&](const std::vector<Point>& meant) -> Result<void> {
    machine.stroke_drawn(meant);
    return machine.is_full() ? play_added() : Result<void>();
  };
  sink.hand = [&machine] { return machine.hand_options(); };
  ScriptFeed feed({.mm_per_unit = 1.0, .hand = {}, .seed = 0}, std::move(sink));
  running = &feed;
  if (Result<void> read = feed.read("script", read_text(script)); !read) return read;
  return play_added();
}

Result<Imported> import_felt(std::string_view bytes) {
  Imported result;
  std::vector<std::string> notices;
  Result<Drawing> drawing = parse_felt(bytes, &notices);
  if (!drawing) return tl::unexpected(drawing.error());
  for (std::string& notice : notices) result.report.add(0, {}, std::move(notice));
  result.drawing = *std::move(drawing);
  return result;
}

/// Adds a sentence with the number in place of %1, if there is any.
void add_text(std::string text, std::size_t count, std::vector<std::string>& texts) {
  if (count == 0) return;
  texts.push_back(text.replace(text.find("%1"), 2, std::to_string(count)));
}

}  // namespace

bool is_full_module() noexcept {
  return true;
}

Result<Imported> import_as(FileFormat format, std::string_view bytes) {
  switch (format) {
    case FileFormat::kFelt:
      return import_felt(bytes);
    case FileFormat::kSvg:
      return import_svg(bytes);
    case FileFormat::kInkml:
      return import_inkml(bytes);
    case FileFormat::kXopp:
      return import_xopp(bytes);
    case FileFormat::kNdjson:
      return import_lines(bytes);
    default:
      return fail(ErrorCode::kUnsupported,
                  "is a " + std::string(traits_of(format).title) +
                      ", which the page cannot read; save it as .svg in a program of Feltline");
  }
}

Result<std::string> inkml_of(const Drawing& drawing) {
  return inkml_text(drawing);
}

Result<std::string> lines_of(const Drawing& drawing) {
  Drawing plain = drawing;
  FELT_CHECK(plain.document.apply(plain_edit(drawing.document, FileFormat::kNdjson)).has_value());
  return bytes_of(*line_parts(plain));
}

std::vector<std::string> losses_of_writing(const Drawing& drawing, std::string_view format) {
  std::vector<std::string> texts;
  const Result<FileFormat> written = format_of_path("drawing." + std::string(format));
  if (!written) return texts;
  const LostObjects lost = lost_objects(drawing, *written);
  for (const desktop::LostWords& row : desktop::kLostWords)
    add_text(row.text, lost.*row.count, texts);
  return texts;
}

std::vector<std::string> losses_of_adding(const Drawing& drawing) {
  std::vector<std::string> texts;
  const LostObjects lost = lost_objects(drawing, FileFormat::kNdjson);
  for (const desktop::AddedWords& row : desktop::kAddedWords) {
    add_text(row.text, desktop::count_of(row, lost), texts);
  }
  return texts;
}

Result<std::string> felt_of(const Drawing& drawing) {
  return felt_bytes(drawing);
}

Result<Document> replay(std::string_view script, const ReplayChoice& choice) {
  if (choice.as_recorded) {
    Session session(make_tools(), SessionOptions{.device = {}});
    ScriptSink sink;
    sink.event = [&session](const Event& event) { return session.apply(event); };
    Result<void> done = read_script("recording", read_text(script), sink);
    if (done) done = session.finish();
    if (!done) return tl::unexpected(done.error());
    return session.document();
  }
  const StylusPreset* preset = find_stylus_preset(choice.device);
  if (!preset) return fail(ErrorCode::kNotFound, "unknown device " + choice.device);
  ReplayMachine machine(replay_settings(*preset, typical_hand(), choice.forces, {}, {}), {}, {});
  if (Result<void> done = play(machine, script); !done) return tl::unexpected(done.error());
  return machine.session().document();
}

}  // namespace felt::page
