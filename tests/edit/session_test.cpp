// SPDX-License-Identifier: Apache-2.0
#include "edit/src/session.hpp"

#include <cstdio>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "jounce/base/file.hpp"

#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::session_test {
namespace {

using OnDisk = EditSession::OnDisk;
using ::testing::HasSubstr;

class Sessions : public test::WithFolder {
 protected:
  Sessions() { write_file(path, "one\n"); }

  /// Another program writes the file.
  void write_by_another(const std::string& text) const { write_file(path, text); }
  [[nodiscard]] std::string on_disk() const { return read_file(path); }
  [[nodiscard]] bool has_side_file() const { return access(side.c_str(), F_OK) == 0; }

  const std::string path = in("a.toml");
  const std::string side = in("a.toml.autosave");
};

void edit(EditSession& session, const char* text) {
  ASSERT_TRUE(session.set(session.revision(), text, "edit"));
}

TEST_F(Sessions, UndoWithoutALimit) {
  EditSession session(path);
  EXPECT_FALSE(session.undo());
  constexpr int many = 1000;
  for (int i = 0; i < many; ++i) edit(session, std::to_string(i).c_str());
  for (int i = 0; i < many; ++i) ASSERT_TRUE(session.undo());
  EXPECT_EQ(session.text(), "one\n");
  EXPECT_TRUE(session.is_saved());
  EXPECT_FALSE(session.undo_label());
  for (int i = 0; i < many; ++i) ASSERT_TRUE(session.redo());
  EXPECT_EQ(session.text(), "999");
  EXPECT_EQ(session.undo_label(), "edit");
}

TEST_F(Sessions, AChangeAfterUndoDropsTheLaterVersions) {
  EditSession session(path);
  edit(session, "two");
  session.undo();
  edit(session, "three");
  EXPECT_FALSE(session.redo());
  session.undo();
  EXPECT_EQ(session.text(), "one\n");
}

TEST_F(Sessions, AChangeOfAnotherRevisionIsRejected) {
  EditSession session(path);
  const std::int64_t old = session.revision();
  edit(session, "two");
  EXPECT_FALSE(session.set(old, "three", "late"));
  EXPECT_EQ(session.text(), "two");
}

TEST_F(Sessions, OnlySaveWritesTheFile) {
  EditSession session(path);
  edit(session, "two\n");
  session.undo();
  session.redo();
  EXPECT_EQ(on_disk(), "one\n");
  EXPECT_FALSE(session.is_saved());
  EXPECT_TRUE(session.save());
  EXPECT_EQ(on_disk(), "two\n");
  EXPECT_TRUE(session.is_saved());
  session.undo();
  EXPECT_FALSE(session.is_saved());
}

TEST_F(Sessions, UnsavedTextIsInTheSideFile) {
  {
    EditSession session(path);
    edit(session, "two\n");
    EXPECT_THAT(read_file(side), HasSubstr("\ntwo\n"));
    session.undo();
    EXPECT_FALSE(has_side_file());
    session.redo();
  }  // the program ends without saving
  EXPECT_EQ(on_disk(), "one\n");
  EditSession again(path);
  EXPECT_TRUE(again.is_recovered());
  EXPECT_EQ(again.text(), "two\n");
  EXPECT_EQ(again.on_disk(), OnDisk::same);
  EXPECT_EQ(again.undo_label(), "recover the unsaved text");
  again.save();
  EXPECT_EQ(on_disk(), "two\n");
  EXPECT_FALSE(has_side_file());
}

TEST_F(Sessions, AFileThatChangedBeforeTheRecoveryIsAConflict) {
  {
    EditSession session(path);
    edit(session, "two\n");
  }
  write_by_another("other\n");
  for (int start = 0; start < 2; ++start) {  // also at the second start, without a decision
    EditSession again(path);
    EXPECT_EQ(again.on_disk(), OnDisk::changed);
    EXPECT_EQ(again.text(), "two\n");
    EXPECT_EQ(again.file_text(), "other\n");
    EXPECT_FALSE(again.save());
    edit(again, start == 0 ? "two and a half\n" : "three\n");
    again.undo();
  }
  EXPECT_EQ(on_disk(), "other\n");
}

TEST_F(Sessions, AFileWithTheNameOfTheSideFileIsNotReplaced) {
  write_file(side, "mine\n");
  EXPECT_THAT(test::why([&] { EditSession session(path); }),
              HasSubstr("a.toml.autosave:1: was not written by `jounce edit`"));
  EXPECT_EQ(read_file(side), "mine\n");
}

TEST_F(Sessions, StandardInputIsNoFile) {
  EXPECT_THAT(test::why([] { EditSession session("-"); }), HasSubstr("-: is standard input"));
  EXPECT_THAT(test::why([] { EditSession session("missing/x.toml"); }),
              HasSubstr("missing/x.toml: the folder missing does not exist"));
}

TEST_F(Sessions, AChangeOnTheDiskIsAVersion) {
  EditSession session(path);
  EXPECT_FALSE(session.poll());
  write_by_another("other\n");
  EXPECT_TRUE(session.poll());
  EXPECT_EQ(session.text(), "other\n");
  EXPECT_TRUE(session.is_saved());
  session.undo();
  EXPECT_EQ(session.text(), "one\n");
  EXPECT_FALSE(session.is_saved());
}

TEST_F(Sessions, AChangeOnTheDiskBesideUnsavedTextIsAConflict) {
  EditSession session(path);
  edit(session, "two\n");
  write_by_another("other\n");
  EXPECT_FALSE(session.save()) << "save() looks at the file itself";
  EXPECT_EQ(session.on_disk(), OnDisk::changed);
  EXPECT_EQ(session.text(), "two\n");
  EXPECT_EQ(session.file_text(), "other\n");
  EXPECT_EQ(on_disk(), "other\n");
}

TEST_F(Sessions, TheFileResolvesAConflict) {
  EditSession session(path);
  edit(session, "two\n");
  write_by_another("other\n");
  session.poll();
  session.use_file();
  EXPECT_EQ(session.text(), "other\n");
  EXPECT_TRUE(session.is_saved());
  session.undo();
  EXPECT_EQ(session.text(), "two\n") << "not lost";
}

TEST_F(Sessions, TheOwnTextResolvesAConflict) {
  EditSession session(path);
  edit(session, "two\n");
  write_by_another("other\n");
  session.poll();
  session.use_mine();
  EXPECT_EQ(session.text(), "two\n");
  EXPECT_TRUE(session.save());
  EXPECT_EQ(on_disk(), "two\n");
}

TEST_F(Sessions, TheSameChangeOnBothSidesIsNoConflict) {
  EditSession session(path);
  edit(session, "two\n");
  write_by_another("two\n");
  EXPECT_TRUE(session.poll());
  EXPECT_TRUE(session.is_saved());
  EXPECT_FALSE(has_side_file());
}

TEST_F(Sessions, AFileThatIsTouchedHasNotChanged) {
  EditSession session(path);
  const timespec times[2]{{1, 0}, {1, 0}};
  utimensat(AT_FDCWD, path.c_str(), times, 0);
  const std::int64_t before = session.revision();
  EXPECT_FALSE(session.poll());
  EXPECT_EQ(session.revision(), before);
}

TEST_F(Sessions, ARemovedFileIsReportedAndWrittenAgain) {
  EditSession session(path);
  unlink(path.c_str());
  EXPECT_TRUE(session.poll());
  EXPECT_EQ(session.on_disk(), OnDisk::missing);
  EXPECT_TRUE(has_side_file()) << "the text is nowhere else";
  EXPECT_FALSE(session.poll());
  EXPECT_TRUE(session.save());
  EXPECT_EQ(on_disk(), "one\n");
  EXPECT_FALSE(has_side_file());
}

// A folder without access would do the same, but not for the superuser.
TEST_F(Sessions, AFolderThatIsGoneKeepsTheTextInMemory) {
  EditSession session(path);
  const std::string away = folder() + ".away";
  ASSERT_EQ(std::rename(folder().c_str(), away.c_str()), 0);
  edit(session, "two\n");
  EXPECT_EQ(session.text(), "two\n");
  EXPECT_THAT(session.side_error(), HasSubstr("a.toml.autosave"));
  ASSERT_EQ(std::rename(away.c_str(), folder().c_str()), 0);
  edit(session, "three\n");
  EXPECT_EQ(session.side_error(), "") << "the folder is back";
  EXPECT_TRUE(has_side_file());
}

}  // namespace
}  // namespace jounce::session_test
