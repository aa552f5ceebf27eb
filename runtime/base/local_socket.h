// Streams of bytes between programs of one machine, over a socket that has a place in the file
// system.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace runtime {

// One end of a connection. All functions wait as long as it takes; a signal does not end that.
class LocalSocket {
 public:
  // Connects to who listens at `path`; tries again for `patience`. Throws UserError where nobody
  // does.
  LocalSocket(const std::filesystem::path& path, std::chrono::milliseconds patience);
  LocalSocket(LocalSocket&& other) noexcept;
  LocalSocket& operator=(LocalSocket&&) = delete;
  ~LocalSocket();

  // Whether all bytes were passed on; else the other side is gone.
  bool Write(std::string_view bytes);
  // The next line, without its end; nothing where the other side is gone, or where there is no end
  // within kLongestLine bytes.
  std::optional<std::string> ReadLine();
  // Fills `bytes`. Returns whether it could, before the other side was gone.
  bool Read(std::span<std::byte> bytes);

  // From any thread: from now on the other side is gone.
  void Interrupt() const;

  static constexpr size_t kLongestLine = size_t{1} << 24;

 private:
  friend class LocalListener;
  explicit LocalSocket(int descriptor) : descriptor_(descriptor) {}

  // Appends what has come to what was read before. Returns whether something has.
  bool Receive();

  int descriptor_;
  std::string unread_;
  size_t start_ = 0;  // of what is unread
};

// Who waits for others to connect.
class LocalListener {
 public:
  // Makes the socket at `path`; one that nobody listens at any more is replaced. Throws UserError.
  explicit LocalListener(std::filesystem::path path);
  LocalListener(const LocalListener&) = delete;
  LocalListener& operator=(const LocalListener&) = delete;
  // Removes it.
  ~LocalListener();

  // The next who connects within `time`, or nobody.
  std::optional<LocalSocket> Accept(std::chrono::milliseconds time) const;

 private:
  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace runtime
