#include "record_copy.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "felt/base/atomic_file.h"
#include "felt/io/ndjson_writer.h"

namespace felt::cli {
namespace {

/// Telling the strokes takes a share of our time that a hand does not feel.
constexpr int kMostShare = 50;

std::string path_for(const std::string& output) {
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(output, none);
  const bool is_file = output != "-" && (!std::filesystem::exists(status) ||
                                         std::filesystem::is_regular_file(status));
  const std::string name = std::filesystem::temp_directory_path(none).string() + "/feltline-record";
  return (is_file ? output : name) + ".unsaved-" + std::to_string(getpid()) + ".ndjson";
}

}  // namespace

RecordCopy::RecordCopy(const std::string& output, Clock::duration every)
    : path_(path_for(output)), every_(every), next_(Clock::now() + every) {}

void RecordCopy::keep(const Session& session) {
  const Clock::time_point now = Clock::now();
  if (!is_changed_ || now < next_) return;
  if (writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return;
  }
  is_changed_ = false;
  std::string text;
  for (const SketchStroke& stroke : session.sketch()) {
    append_sketch_line(text, stroke.id, stroke.stroke.data());
  }
  next_ = now + std::max(every_, kMostShare * (Clock::now() - now));
  try {
    writing_ = std::async(std::launch::async, [path = path_, text = std::move(text)] {
      return write_file(path, text);  // what fails is tried again with the next change
    });
  } catch (const std::system_error&) {  // there is no thread to be had now
    is_changed_ = true;
  }
}

void RecordCopy::remove() {
  if (writing_.valid()) writing_.wait();
  std::error_code none;
  std::filesystem::remove(path_, none);
}

}  // namespace felt::cli
