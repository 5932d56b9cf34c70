// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/security/key.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/temporary_folder.hpp"

namespace jounce::key_test {
namespace {

namespace fs = std::filesystem;

class KeyFile : public test::WithFolder {
 protected:
  void write(const std::string& text, fs::perms mode = fs::perms::owner_read) {
    fs::remove(path);
    std::ofstream(path) << text;
    fs::permissions(path, mode);
  }
  std::string refusal() {
    try {
      static_cast<void>(read_key(path));
    } catch (const InputError& error) {
      return error.rule();
    }
    return "nothing";
  }

  const fs::path path = folder_ / "line.key";
};

TEST_F(KeyFile, IsDrawnOnceAndReadBack) {
  write_new_key(path);
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  const wire::Key key = read_key(path);
  EXPECT_NE(key, wire::Key{});
  EXPECT_THROW(write_new_key(path), InputError) << "it is there already";
  EXPECT_EQ(read_key(path), key);
  fs::remove(path);
  write_new_key(path);
  EXPECT_NE(read_key(path), key);
}

TEST_F(KeyFile, HoldsSixtyFourDigits) {
  const std::string digits(62, '0');
  write(" " + digits + "fF\n");
  EXPECT_EQ(read_key(path)[31], 0xFF);
  for (const std::string& text :
       {std::string(), digits, digits + "ff0", digits + "ffff", digits + "xy",
        digits + "ff and more", std::string(5000, '0'), digits + std::string("\0ff", 3)}) {
    write(text);
    EXPECT_EQ(refusal(), "must hold 64 hexadecimal digits") << text;
  }
}

TEST_F(KeyFile, IsItsOwnersAlone) {
  const std::string text(64, '1');
  for (const auto others :
       {fs::perms::group_read, fs::perms::others_read, fs::perms::group_write}) {
    write(text, fs::perms::owner_read | others);
    EXPECT_EQ(refusal(), "must be readable by its owner only: chmod 600 " + path.string());
  }
  fs::remove(path);
  EXPECT_EQ(refusal(), "cannot be read: No such file or directory");
  fs::create_directory(path);
  fs::permissions(path, fs::perms::owner_all);
  EXPECT_EQ(refusal(), "must be a file");
}

}  // namespace
}  // namespace jounce::key_test
