#include "sketch_spool.h"

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "felt/io/ndjson/ndjson_parser.h"

namespace felt::cli {
namespace {

constexpr std::size_t kSpoolBatchBytes = std::size_t{64} << 10;

tl::unexpected<Error> failed(const char* doing) {
  return fail(ErrorCode::kIo, std::string("temporary file: cannot ") + doing + ": " +
                                  std::generic_category().message(errno));
}

}  // namespace

Result<void> SketchSpool::add_lines(std::string_view lines) {
  if (!file_) file_.reset(std::tmpfile());
  if (!file_) return failed("create");
  if (std::fwrite(lines.data(), 1, lines.size(), file_.get()) == lines.size()) return {};
  return failed("write");
}

Result<void> SketchSpool::for_each(const TakeStroke& take) {
  if (!file_) return {};
  if (std::fflush(file_.get()) != 0) return failed("write");
  const int fd = fileno(file_.get());
  if (::lseek(fd, 0, SEEK_SET) < 0) return failed("read");
  return for_each_line_stroke(read_descriptor(fd), take);
}

Result<void> for_each_line_stroke(ReadBytes source, const TakeStroke& take) {
  LineReader reader(std::move(source));
  LineBatch batch;
  NdjsonParser parser;
  for (;;) {
    const Result<bool> more = reader.fill(batch, kSpoolBatchBytes);
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    for (std::size_t i = 0; i < batch.size(); ++i) {
      SketchRecord record;
      const Result<NdjsonKind> kind = parser.sketch_stroke(batch.line(i), record);
      if (!kind) return tl::unexpected(kind.error());
      Result<Stroke> stroke = Stroke::create(std::move(record.data));
      if (!stroke) return tl::unexpected(stroke.error());
      Result<void> taken = take({std::move(record.id), *std::move(stroke)});
      if (!taken) return taken;
    }
  }
}

}  // namespace felt::cli
