// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/file.hpp"

#include <csignal>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace {
int umask_calls = 0;
}

/// Replaces the function of the C library in this program.
extern "C" mode_t umask(mode_t mask) noexcept {
  ++umask_calls;
  return static_cast<mode_t>(syscall(SYS_umask, mask));
}

namespace jounce::file_test {
namespace {

using test::why;
using ::testing::HasSubstr;

class Files : public test::WithFolder {};

/// Writes in a process of its own whose files may have 1000 bytes; 0: it failed, as it should.
int write_too_much(const std::string& path) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{1000, 1000};
  setrlimit(RLIMIT_FSIZE, &limit);
  try {
    write_files({{path, "fits"}, {path + "2", std::string(2000, 'a')}});
  } catch (const std::system_error&) {
    return 0;
  }
  return 1;
}

TEST_F(Files, AFailedWriteLeavesNoTemporaryFile) {
  write_file(in("a"), "old");
  const pid_t child = fork();
  if (child == 0) _exit(write_too_much(in("a")));
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(files(), 1U) << "a alone";
  EXPECT_EQ(read_file(in("a")), "old") << "all files or none";
}

mode_t rights_of(const std::string& path) {
  struct stat about {};
  return stat(path.c_str(), &about) == 0 ? about.st_mode & 07777U : 0;
}

// All threads share the umask: a call changes it for the files that other threads create.
TEST_F(Files, HaveTheRightsOfTheUmaskOrOfTheFileBefore) {
  const mode_t before = umask(027);
  umask_calls = 0;
  write_file(in("new"), "1");
  write_file(in("private"), "1");
  write_file(in("program"), "1");
  chmod(in("private").c_str(), 0600);
  chmod(in("program").c_str(), 0755);
  write_file(in("private"), "2");
  write_file(in("program"), "2");
  EXPECT_EQ(umask_calls, 0);
  EXPECT_EQ(umask(before), 027U);
  EXPECT_EQ(rights_of(in("new")), 0640U);
  EXPECT_EQ(rights_of(in("private")), 0600U);
  EXPECT_EQ(rights_of(in("program")), 0755U);
}

TEST_F(Files, ADeviceWithoutEndIsRejected) {
  EXPECT_THAT(why([] { (void)read_file("/dev/zero"); }),
              HasSubstr("/dev/zero: must be a regular file, or a pipe of at most 256 MiB"));
}

/// Runs what writes to a pipe in a process of its own.
template <class Write>
pid_t beside(Write write) {
  const pid_t child = fork();
  if (child == 0) {
    write();
    _exit(0);
  }
  return child;
}

TEST_F(Files, APipeWithoutAWriterIsRejected) {
  ASSERT_EQ(mkfifo(in("pipe").c_str(), 0600), 0);
  EXPECT_THAT(why([&] { (void)read_file(in("pipe")); }),
              HasSubstr("pipe: is a pipe that no program opened for writing within 5 s"));
}

TEST_F(Files, APipeIsReadToTheEndOfItsWriter) {
  ASSERT_EQ(mkfifo(in("pipe").c_str(), 0600), 0);
  const pid_t writer = beside([&] {
    usleep(100'000);  // after the reader
    const int pipe = open(in("pipe").c_str(), O_WRONLY);
    usleep(200'000);  // open, and nothing written yet
    for (int i = 0; i < 3; ++i) {
      if (write(pipe, "part ", 5) != 5) _exit(1);
      usleep(50'000);
    }
  });
  EXPECT_EQ(read_file(in("pipe")), "part part part ");
  int status = 1;
  waitpid(writer, &status, 0);
  EXPECT_EQ(status, 0);
}

/// Why it cannot be written.
std::string fault_of(const std::string& path) {
  try {
    write_file(path, "text");
  } catch (const std::system_error& error) {
    return error.what();
  }
  return "";
}

TEST_F(Files, APipeWithoutAReaderIsAFault) {
  ASSERT_EQ(mkfifo(in("pipe").c_str(), 0600), 0);
  EXPECT_THAT(fault_of(in("pipe")), HasSubstr("no program reads this pipe within 5 s"));
}

TEST_F(Files, ALinkIsWrittenThroughAlsoToNothing) {
  std::filesystem::create_symlink("there", in("link"));
  std::filesystem::create_symlink("link", in("second"));
  write_file(in("second"), "text");
  EXPECT_EQ(read_file(in("there")), "text");
  EXPECT_TRUE(std::filesystem::is_symlink(in("second")));
  std::filesystem::create_symlink("none/there", in("broken"));
  EXPECT_THAT(fault_of(in("broken")), HasSubstr("none/there: No such file or directory"));
}

TEST_F(Files, ALinkToItselfAndANameTooLongAreNamed) {
  std::filesystem::create_symlink("b", in("a"));
  std::filesystem::create_symlink("a", in("b"));
  EXPECT_THAT(why([&] { (void)read_file(in("a")); }),
              HasSubstr("a: cannot be read: Too many levels of symbolic links"));
  EXPECT_THAT(fault_of(in("a")), HasSubstr("cannot write "));
  EXPECT_THAT(fault_of(in("a")), HasSubstr("Too many levels of symbolic links"));
  const std::string name(300, 'a');
  EXPECT_THAT(why([&] { (void)read_file(in(name.c_str())); }),
              HasSubstr("cannot be read: File name too long"));
  EXPECT_THAT(fault_of(in(name.c_str())), HasSubstr("cannot write "));
  EXPECT_EQ(files(), 2U);
}

// A pipe without a name, whose writer may be gone already, as in `check /dev/stdin` and `check
// <(...)`.
TEST_F(Files, APipeOfTheShellIsReadByItsDescriptor) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  ASSERT_EQ(write(ends[1], "all", 3), 3);
  close(ends[1]);
  EXPECT_EQ(read_file("/dev/fd/" + std::to_string(ends[0])), "all");
  EXPECT_EQ(read_file("/dev/fd/" + std::to_string(ends[0])), "")
      << "nothing is left, and there is no writer";
  close(ends[0]);
}

TEST_F(Files, NoInputIsReplaced) {
  write_file(in("points.csv"), "points");
  write_file(in("other.csv"), "other");
  std::filesystem::create_symlink(in("points.csv"), in("link.csv"));
  const std::vector<std::string> inputs{"-", in("missing.csv"), in("points.csv")};
  for (const char* name : {"points.csv", "link.csv"})
    EXPECT_THAT(why([&] { write_file(in(name), "made", inputs); }),
                HasSubstr(std::string(name) + ": is also an input"));
  EXPECT_THAT(why([&] {
                write_files({{in("new.csv"), ""}, {in("points.csv"), ""}}, inputs);
              }),
              HasSubstr("is also an input"));
  EXPECT_FALSE(std::filesystem::exists(in("new.csv")));
  EXPECT_THAT(why([&] {
                write_files({{"two of one.json", ""}, {"./two of one.json", ""}});
              }),
              HasSubstr("two outputs have the name"));
  write_file(in("other.csv"), "made", inputs);
  EXPECT_THAT(why([&] { require_no_input({in("points.csv") + "#Sheet 1"}, in("points.csv")); }),
              HasSubstr("is also an input"));
  (void)read_file(in("points.csv"));
  write_file(in("points.csv"), "made");
  EXPECT_EQ(read_file(in("points.csv")), "made") << "a library's user may replace what it has read";

  EXPECT_THAT(why([&] { require_other_file(in("points.csv"), in("link.csv"), "output"); }),
              HasSubstr("link.csv: is also the input"));
  require_other_file(in("points.csv"), in("other.csv"), "output");
  require_other_file(in("points.csv"), in("missing.csv"), "output");
  require_other_file("-", "-", "output");
}

TEST_F(Files, StandardOutputTakesOneOutput) {
  EXPECT_EQ(text_stream(false, {"a.csv", ""}), stdout);
  EXPECT_EQ(text_stream(true, {"a.csv", ""}), stdout);
  EXPECT_EQ(text_stream(false, {"a.csv", "-"}), stderr);
  EXPECT_THAT(test::error_of([] {
                (void)text_stream(true, {"a.csv", "-"});
              }),
              ::testing::StartsWith("--json: standard output already receives another output: "));
}

TEST_F(Files, NameWhatIsNoText) {
  using namespace std::string_literals;
  write_file(in("a"), "\x1F\x8B\x08"s);
  EXPECT_THAT(why([&] { (void)read_file(in("a")); }), HasSubstr("compressed by gzip"));
  write_file(in("a"), "PK\x03\x04 and so on"s);
  EXPECT_THAT(why([&] { (void)read_file(in("a")); }), HasSubstr("workbook"));
  EXPECT_EQ(read_file(in("a"), Archive::returned), "PK\x03\x04 and so on"s);
  write_file(in("a"), "\xD0\xCF\x11\xE0 and so on"s);
  EXPECT_THAT(why([&] { (void)read_file(in("a"), Archive::returned); }), HasSubstr(".xlsx"));
}

TEST_F(Files, ReadUtf16AsSpreadsheetsWriteIt) {
  using namespace std::string_literals;
  const auto text_of = [&](const std::string& bytes) {
    write_file(in("a"), bytes);
    return read_file(in("a"));
  };
  EXPECT_EQ(text_of("\xFF\xFEt\0i\0m\0"s), "tim");
  EXPECT_EQ(text_of("\xFE\xFF\0t\0i"s), "ti");
  EXPECT_EQ(text_of("\xFF\xFE"s), "");
  EXPECT_EQ(text_of("\xFF\xFE\xB5\0\xB0\0"s), "\u00b5\u00b0");
  EXPECT_EQ(text_of("\xFF\xFE\xAC\x20"s), "\u20ac");
  EXPECT_EQ(text_of("\xFE\xFF\xD8\x3D\xDE\x00"s), "\U0001F600");
  const auto error = [&](const std::string& bytes) { return why([&] { (void)text_of(bytes); }); };
  EXPECT_THAT(error("\xFF\xFEt\0i"s),
              HasSubstr("a:1: is text in UTF-16 with half a character at byte 5"));
  for (const std::string& lone :
       {"\xFE\xFF\xD8\x3D\0t"s, "\xFE\xFF\xD8\x3D"s, "\xFE\xFF\xDE\0\0t"s})
    EXPECT_THAT(error(lone), HasSubstr("half a surrogate pair at byte 3"));
}

TEST(InputErrors, ShortenWhatIsTooLongToRead) {
  const std::string digits(100'000, '9');
  const InputError error("position", digits, "must be a finite number");
  EXPECT_EQ(std::string(error.what()),
            "position = " + std::string(60, '9') + "... (100000 bytes): must be a finite number");
  EXPECT_EQ(error.value(), digits);
  const std::string exact(200, 'a');
  EXPECT_THAT(InputError("k", exact, "r").what(), HasSubstr(exact));
  std::string two_bytes = "a";
  for (int i = 0; i < 200; ++i) two_bytes += "\u00b5";
  EXPECT_THAT(InputError("k", two_bytes, "r").what(), HasSubstr("\u00b5... (401 bytes)"));
}

}  // namespace
}  // namespace jounce::file_test
