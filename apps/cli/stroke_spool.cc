#include "stroke_spool.h"

#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "felt/io/ndjson/ndjson_parser.h"

namespace felt::cli {
namespace {

constexpr std::size_t kSpoolBatchBytes = std::size_t{64} << 10;

tl::unexpected<Error> failed(const char* doing) {
  return fail(ErrorCode::kIo, std::string("temporary file: cannot ") + doing + ": " +
                                  std::generic_category().message(errno));
}

}  // namespace

Result<void> StrokeSpool::add_lines(std::string_view lines) {
  if (!file_) file_.reset(std::tmpfile());
  if (!file_) return failed("create");
  if (std::fwrite(lines.data(), 1, lines.size(), file_.get()) == lines.size()) return {};
  return failed("write");
}

Result<void> StrokeSpool::for_each(const std::function<Result<void>(NamedStroke)>& handle) {
  if (!file_) return {};
  if (std::fflush(file_.get()) != 0) return failed("write");
  const int fd = fileno(file_.get());
  if (::lseek(fd, 0, SEEK_SET) < 0) return failed("read");
  LineReader reader(read_descriptor(fd));
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
      if (auto ok = handle({std::move(record.id), *std::move(stroke)}); !ok) return ok;
    }
  }
}

}  // namespace felt::cli
