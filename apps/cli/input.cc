#include "input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

#include "felt/base/input_files.h"
#include "felt/store/felt_file.h"

namespace felt::cli {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{1} << 18;

tl::unexpected<Error> cannot_open(int error) {
  const ErrorCode code = error == ENOENT ? ErrorCode::kNotFound : ErrorCode::kIo;
  return fail(code, std::generic_category().message(error));
}

/// Returns true if the input is a device that never ends, like /dev/zero. Terminals end with
/// Ctrl-D, and /dev/null ends immediately, so this returns false for them.
bool is_endless(const struct stat& status, int fd) {
  if (S_ISBLK(status.st_mode)) return true;
  return S_ISCHR(status.st_mode) && ::isatty(fd) == 0 && status.st_rdev != makedev(1, 3);
}

/// Returns true if the input is a stream, without an extension that shows its format. A stream is
/// read as lines unless its first bytes show another format.
bool is_stream(const std::string& path) {
  return path == "-" || path.rfind("/dev/", 0) == 0;
}

}  // namespace

bool is_blank(const Document& document) noexcept {
  if (document.stroke_count() > 0 || document.fill_count() > 0) return false;
  return std::none_of(document.layers().begin(), document.layers().end(),
                      [](const Layer& layer) { return layer.picture != nullptr; });
}

std::string input_name(const std::string& path) {
  return path == "-" ? "stdin" : path;
}

Result<Input> Input::open(const std::string& path) {
  return begin(path, path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC),
               false);
}

Result<Input> Input::open_regular(const std::string& path) {
  // Without O_NONBLOCK, opening a pipe waits for its writer.
  return begin(path, ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK), true);
}

Result<Input> Input::begin(const std::string& path, int fd, bool regular_only) {
  if (fd < 0) return cannot_open(errno);
  Input input(input_name(path), fd);
  note_input_file(fd, input.name_);
  struct stat status {};
  if (::fstat(fd, &status) != 0) return cannot_open(errno);
  if (S_ISDIR(status.st_mode)) return cannot_open(EISDIR);
  if (is_endless(status, fd) || (regular_only && !S_ISREG(status.st_mode))) {
    return fail(ErrorCode::kUnsupported, "not a regular file");
  }
  if (S_ISREG(status.st_mode)) input.size_bytes_ = status.st_size;
  if (Result<void> read = input.read_head(); !read) return tl::unexpected(read.error());
  if (Result<void> known = input.find_kind(path); !known) return tl::unexpected(known.error());
  return input;
}

Result<void> Input::read_head() {
  head_.resize(kFormatHeadBytes);
  std::size_t have = 0;
  const ReadBytes read = read_descriptor(fd_);
  while (have < head_.size()) {
    const Result<std::size_t> more = read({head_.data() + have, head_.size() - have});
    if (!more) return tl::unexpected(more.error());
    if (*more == 0) break;
    have += *more;
    // Does not wait for more bytes if the first bytes already show that the input consists of
    // lines, because a pipe may deliver lines slowly.
    if (format_of_bytes({head_.data(), have}) == FileFormat::kNdjson) break;
  }
  head_.resize(have);
  return {};
}

Result<void> Input::find_kind(const std::string& path) {
  if (is_stream(path) && !format_of_bytes(head_)) return {};
  const bool has_ending = format_of_path(path).has_value();
  const std::string file = path.substr(path.find_last_of('/') + 1);
  // A file without extension and magic bytes is read as lines. If that is wrong, the reader of
  // lines reports it.
  if (!has_ending && !format_of_bytes(head_) && file.find('.', 1) == std::string::npos) return {};
  const Result<FileFormat> format = readable_format(head_, path);
  if (!format) return tl::unexpected(format.error());
  format_ = *format;
  const NdjsonContent content = ndjson_content(head_);
  is_lines_ = format_ == FileFormat::kNdjson && content == NdjsonContent::kStrokes;
  is_quickdraw_ = format_ == FileFormat::kNdjson && content == NdjsonContent::kQuickdraw;
  return {};
}

ReadBytes Input::reader() const {
  return [this, given = std::size_t{0},
          rest = read_descriptor(fd_)](std::span<char> out) mutable -> Result<std::size_t> {
    if (given == head_.size()) return rest(out);
    const std::size_t count = std::min(out.size(), head_.size() - given);
    std::memcpy(out.data(), head_.data() + given, count);
    given += count;
    return count;
  };
}

Result<std::string> Input::read_all(std::size_t max_bytes) const {
  const auto too_large = [max_bytes] {
    return fail(ErrorCode::kLimitExceeded,
                "is larger than " + std::to_string(max_bytes) + " bytes");
  };
  if (static_cast<std::uint64_t>(size_bytes_) > max_bytes) return too_large();
  std::string bytes = head_;
  // Reserves one block more than the size of the file. Otherwise the last read, which finds the end
  // of the file, would double the memory.
  if (size_bytes_ > 0) bytes.reserve(static_cast<std::size_t>(size_bytes_) + kBlockBytes);
  const ReadBytes read = read_descriptor(fd_);
  for (std::size_t more = head_.size(); more > 0;) {
    const std::size_t have = bytes.size();
    if (have > max_bytes) return too_large();
    bytes.resize(have + kBlockBytes);
    const Result<std::size_t> got = read({bytes.data() + have, kBlockBytes});
    if (!got) return tl::unexpected(got.error());
    more = *got;
    bytes.resize(have + more);
  }
  return bytes;
}

tl::unexpected<Error> Input::with_salvage_hint(Error error, const ReadOptions& options) const {
  if (format_ == FileFormat::kFelt && !options.salvage && error.code == ErrorCode::kInvalidData) {
    error.message += "; `feltline convert --salvage` recovers the readable parts";
  }
  return tl::unexpected(std::move(error));
}

Result<Imported> Input::read_drawing(const ReadOptions& options) const {
  try {
    const Result<std::size_t> max_bytes =
        check_drawing_head(head_, static_cast<std::uint64_t>(size_bytes_), name_, options.salvage);
    if (!max_bytes) return with_salvage_hint(max_bytes.error(), options);
    const Result<std::string> bytes = read_all(*max_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    ReadOptions with_folder = options;
    with_folder.import.folder = folder_of(name_);
    Result<Imported> drawing = parse_drawing(*bytes, name_, with_folder);
    if (drawing) return drawing;
    return with_salvage_hint(drawing.error(), options);
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::kLimitExceeded, "not enough memory to read it");
  }
}

Input::Input(Input&& other) noexcept
    : name_(std::move(other.name_)),
      fd_(std::exchange(other.fd_, -1)),
      size_bytes_(other.size_bytes_),
      head_(std::move(other.head_)),
      format_(other.format_),
      is_lines_(other.is_lines_),
      is_quickdraw_(other.is_quickdraw_) {}

Input::~Input() {
  if (fd_ > STDERR_FILENO) ::close(fd_);
}

}  // namespace felt::cli
