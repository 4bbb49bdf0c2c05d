#include "felt/film/film_writer.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace felt::film_writer_test {
namespace {

namespace fs = std::filesystem;

/// A folder for films, with encoders that are shell scripts.
class FilmWriterTest : public ::testing::Test {
 protected:
  FilmWriterTest() {
    std::string name = (fs::temp_directory_path() / "felt-film-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~FilmWriterTest() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ + "/" + name; }

  /// Returns the options of small films that a script encodes. Its output is descriptor 3.
  FilmOptions encoder(const std::string& script) {
    FilmOptions options;
    options.width_px = options.height_px = 16;
    options.program = path("encoder");
    std::ofstream(options.program) << "#!/bin/sh\n" << script << "\n";
    ::chmod(options.program.c_str(), 0755);
    return options;
  }
  static Image frame(int width, int height, std::uint8_t grey) {
    Image image = Image::create(width, height).value();
    fill(image.pixels(), image.pixels().rect(), {grey, grey, grey, 255});
    return image;
  }
  static std::string content(const std::string& name) {
    std::stringstream text;
    text << std::ifstream(name).rdbuf();
    return text.str();
  }
  /// Returns the number of files in the folder, hidden ones too, without the encoder.
  [[nodiscard]] int files() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      count += entry.path().filename() != "encoder";
    }
    return count;
  }
  static bool has_ffmpeg() { return std::system("command -v ffmpeg >/dev/null 2>&1") == 0; }

  std::string folder_;
};

TEST_F(FilmWriterTest, PassesEveryFrameByteForByte) {
  Result<FilmWriter> film = FilmWriter::create(path("out.webm"), encoder("cat >&3"), nullptr);
  ASSERT_TRUE(film);
  std::string sent;
  for (int i = 0; i < 100; ++i) {
    const Image image = frame(16, 16, static_cast<std::uint8_t>(i));
    sent.append(image.bytes().begin(), image.bytes().end());
    ASSERT_TRUE(film->add(image));
  }
  EXPECT_FALSE(fs::exists(path("out.webm"))) << "no name before it is complete";
  ASSERT_TRUE(film->finish());
  EXPECT_EQ(content(path("out.webm")), sent);
}

TEST_F(FilmWriterTest, TheReasonOfTheEncoderIsReportedAndNothingStays) {
  std::ofstream(path("out.webm")) << "the film before";
  Result<FilmWriter> film = FilmWriter::create(
      path("out.webm"), encoder("head -c 5000 >&3; echo 'the codec is tired' >&2; exit 1"),
      nullptr);
  ASSERT_TRUE(film);
  Result<void> done;
  for (int i = 0; done && i < 10'000; ++i) done = film->add(frame(16, 16, 7));
  if (done) done = film->finish();
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().message.find("out.webm: "), std::string::npos) << done.error().message;
  EXPECT_NE(done.error().message.find("the codec is tired"), std::string::npos);
  EXPECT_EQ(content(path("out.webm")), "the film before");
  EXPECT_FALSE(film->finish()) << "it has ended";
}

TEST_F(FilmWriterTest, AnEncoderThatIsKilledIsAnError) {
  Result<FilmWriter> film = FilmWriter::create(path("out.webm"), encoder("kill -9 $$"), nullptr);
  ASSERT_TRUE(film);
  const Result<void> done = film->finish();
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().message.find("signal 9"), std::string::npos) << done.error().message;
}

TEST_F(FilmWriterTest, AMissingEncoderSaysWhatToInstall) {
  FilmOptions options = encoder("");
  options.program = path("no-such-program");
  const Result<FilmWriter> film = FilmWriter::create(path("out.gif"), options, nullptr);
  ASSERT_FALSE(film);
  EXPECT_EQ(film.error().code, ErrorCode::kUnsupported);
  EXPECT_NE(film.error().message.find("apt install ffmpeg"), std::string::npos);
  EXPECT_EQ(files(), 0);
}

TEST_F(FilmWriterTest, CancellingEndsTheEncoderAndLeavesNothing) {
  {
    Result<FilmWriter> film = FilmWriter::create(
        path("out.webm"), encoder("echo $$ > " + path("pid") + "; cat >&3; sleep 1000"), nullptr);
    ASSERT_TRUE(film);
    for (int i = 0; i < 500; ++i) ASSERT_TRUE(film->add(frame(16, 16, 9)));
  }
  const pid_t pid = static_cast<pid_t>(std::atoi(content(path("pid")).c_str()));
  ASSERT_GT(pid, 0);
  EXPECT_NE(::kill(pid, 0), 0) << "the encoder still runs";
  EXPECT_EQ(files(), 1) << "only the file with the process id";
}

TEST_F(FilmWriterTest, AnEncoderThatReadsNothingCanBeCancelled) {
  FilmOptions options = encoder("sleep 1000");
  int asked = 0;
  options.is_cancelled = [&asked] { return ++asked > 2; };
  Result<FilmWriter> film = FilmWriter::create(path("out.webm"), options, nullptr);
  ASSERT_TRUE(film);
  Result<void> done;
  while (done) done = film->add(frame(16, 16, 9));
  EXPECT_NE(done.error().message.find("cancelled"), std::string::npos) << done.error().message;
}

TEST_F(FilmWriterTest, RefusesWhatCannotBeWritten) {
  EXPECT_FALSE(FilmWriter::create(path("no/such/folder/out.webm"), encoder("cat >&3"), nullptr));
  EXPECT_FALSE(FilmWriter::create(folder_, encoder("cat >&3"), nullptr));
  Result<FilmWriter> full = FilmWriter::create("/dev/full", encoder("cat >&3"), nullptr);
  ASSERT_TRUE(full);
  ASSERT_TRUE(full->add(frame(16, 16, 1)));
  const Result<void> done = full->finish();
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().message.find("No space left"), std::string::npos) << done.error().message;
}

TEST_F(FilmWriterTest, RefusesSizesAndFramesThatDoNotFit) {
  FilmOptions options = encoder("cat >&3");
  Result<FilmWriter> film = FilmWriter::create(path("out.webm"), options, nullptr);
  ASSERT_TRUE(film);
  EXPECT_FALSE(film->add(frame(17, 16, 0)));
  options.width_px = 15;
  EXPECT_FALSE(FilmWriter::create(path("a.webm"), options, nullptr));
  options.width_px = 10'000;
  EXPECT_FALSE(FilmWriter::create(path("a.webm"), options, nullptr));
  options = encoder("cat >&3");
  options.frames_per_second = 0;
  EXPECT_FALSE(FilmWriter::create(path("a.webm"), options, nullptr));
  options.frames_per_second = 24;
  options.format = FilmFormat::kGif;
  EXPECT_FALSE(FilmWriter::create(path("a.gif"), options, nullptr)) << "without its colours";
}

TEST_F(FilmWriterTest, TheFormatFollowsTheEnding) {
  EXPECT_EQ(film_format_of("a/b.webm"), FilmFormat::kWebm);
  EXPECT_EQ(film_format_of("B.GIF"), FilmFormat::kGif);
  EXPECT_EQ(film_format_of(".gif"), std::nullopt);
  EXPECT_EQ(film_format_of("a.mp4"), std::nullopt);
}

TEST_F(FilmWriterTest, FfmpegGivesTheFramesBack) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  for (const FilmFormat format : {FilmFormat::kWebm, FilmFormat::kGif}) {
    FilmOptions options;
    options.format = format;
    options.width_px = 33;  // odd, though the colours of WebM are stored for 2x2 pixels
    options.height_px = 51;
    const std::string name = path(format == FilmFormat::kGif ? "out.gif" : "out.webm");
    const Image colors = frame(33, 51, 200);
    Result<FilmWriter> film = FilmWriter::create(name, options, &colors);
    ASSERT_TRUE(film);
    for (int i = 0; i < 48; ++i) ASSERT_TRUE(film->add(frame(33, 51, i < 24 ? 255 : 200)));
    const Result<void> done = film->finish();
    ASSERT_TRUE(done) << done.error().message;
    const std::string raw = path("raw");
    ASSERT_EQ(
        std::system(("ffmpeg -nostdin -v error -y -i " + name + " -f rawvideo -pix_fmt gray " + raw)
                        .c_str()),
        0);
    const std::string frames = content(raw);
    ASSERT_EQ(frames.size() % (33 * 51), 0U);
    EXPECT_NEAR(static_cast<double>(frames.size() / (33 * 51)), 48.0, 1.0);
    EXPECT_NEAR(static_cast<unsigned char>(frames.back()), 200, 4);
    if (format == FilmFormat::kWebm) {
      EXPECT_NEAR(static_cast<unsigned char>(frames.front()), 255, 4);
    }
  }
}

}  // namespace
}  // namespace felt::film_writer_test
