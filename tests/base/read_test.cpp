#include "base/file/read.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <fstream>

namespace file {
namespace {

class ReadTest : public testing::Test {
 protected:
  ReadTest() {
    std::string name = testing::TempDir() + "read_test_XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~ReadTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

TEST_F(ReadTest, GivesEveryByte) {
  std::string bytes(200'000, '\0');
  for (size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i);
  std::ofstream(folder_ / "file", std::ios::binary) << bytes;
  std::filesystem::create_symlink("file", folder_ / "link");
  EXPECT_EQ(Read(folder_ / "link").bytes, bytes);
  EXPECT_EQ(Read(folder_ / "link").problem, "");
  EXPECT_EQ(Read(folder_ / "file", 70'000).bytes, bytes.substr(0, 70'000));
  std::ofstream(folder_ / "empty");
  EXPECT_EQ(Read(folder_ / "empty").bytes, "");
  EXPECT_EQ(Read(folder_ / "empty").problem, "");
}

TEST_F(ReadTest, SaysWhyItCannot) {
  EXPECT_EQ(Read(folder_ / "absent").problem, "No such file or directory");
  EXPECT_EQ(Read(folder_).problem, "it is a folder; name a regular file");
}

// Nobody ever writes into the pipe: whoever opens it as a file waits forever.
TEST_F(ReadTest, WaitsForNobody) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("pipe", folder_ / "link");
  EXPECT_EQ(Read(folder_ / "pipe").problem, "it is a named pipe; name a regular file");
  EXPECT_EQ(Read(folder_ / "link").problem, "it is a named pipe; name a regular file");
  EXPECT_EQ(Read("/dev/zero").problem, "it is a device; name a regular file");
}

TEST_F(ReadTest, NoSocketIsAFile) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string path = folder_ / "socket";
  ASSERT_LT(path.size(), sizeof address.sun_path);
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  const int socket_descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(socket_descriptor, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(Read(path).problem, "it is a socket; name a regular file");
  close(socket_descriptor);
}

}  // namespace
}  // namespace file
