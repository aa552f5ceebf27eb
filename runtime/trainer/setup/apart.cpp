#include "runtime/trainer/setup/apart.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <system_error>

#include "base/command_line/command.h"
#include "runtime/base/pipe.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

// The first word of what the process says. Without the last of these nothing is complete.
constexpr const char* kResult = "result";
constexpr const char* kUserError = "user error";
constexpr const char* kCallError = "call error";
constexpr std::string_view kComplete = "complete";

void Say(int pipe, Words words) {
  words.emplace_back(kComplete);
  std::string bytes;
  for (const std::string& word : words) bytes += fmt::format("{}:{}", word.size(), word);
  for (std::string_view rest = bytes; !rest.empty();) {
    const ssize_t count = write(pipe, rest.data(), rest.size());
    if (count > 0) rest.remove_prefix(static_cast<size_t>(count));
    if (count < 0 && errno != EINTR) return;
  }
}

// Not exit(): this process shares with its parent what is to be done at the end of a program.
[[noreturn]] void Work(int pipe, const std::function<Words()>& work) {
  try {
    Words words = work();
    words.insert(words.begin(), kResult);
    Say(pipe, std::move(words));
  } catch (const command_line::CallError& error) {
    Say(pipe, {kCallError, error.what()});
  } catch (const std::exception& error) {
    Say(pipe, {kUserError, error.what()});
  }
  std::fflush(nullptr);
  _exit(0);
}

std::string ReadToEnd(int pipe) {
  std::string bytes;
  char piece[4096];
  for (ssize_t size; (size = read(pipe, piece, sizeof piece)) != 0;) {
    if (size > 0) bytes.append(piece, static_cast<size_t>(size));
    if (size < 0 && errno != EINTR) break;
  }
  return bytes;
}

// Each word behind its size, "6:result". Nothing where it was ended before it had said all.
Words SplitComplete(std::string_view bytes) {
  Words words;
  while (!bytes.empty()) {
    size_t size = 0;
    const char* const end = bytes.data() + bytes.size();
    const auto [colon, error] = std::from_chars(bytes.data(), end, size);
    if (error != std::errc() || colon == end || *colon != ':') return {};
    bytes.remove_prefix(static_cast<size_t>(colon + 1 - bytes.data()));
    if (size > bytes.size()) return {};
    words.emplace_back(bytes.substr(0, size));
    bytes.remove_prefix(size);
  }
  if (words.size() < 2 || words.back() != kComplete) return {};
  words.pop_back();
  return words;
}

std::string EndText(int status) {
  if (WIFEXITED(status)) {
    return fmt::format("ended the process that loaded it (exit status {})", WEXITSTATUS(status));
  }
  if (WTERMSIG(status) == SIGXCPU) return "did not return while it was loaded";
  return fmt::format("crashed while it was loaded: {}", strsignal(WTERMSIG(status)));
}

}  // namespace

Words RunApart(const std::string& what, const std::function<Words()>& work) {
  Pipe pipe;
  std::fflush(nullptr);  // or else both would print what waits
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    pipe.CloseOutput();
    Work(pipe.input(), work);
  }
  const int reason = errno;
  pipe.CloseInput();
  const std::string bytes = child > 0 ? ReadToEnd(pipe.output()) : "";
  if (child < 0) {
    throw UserError(fmt::format("cannot start a process: {}", std::strerror(reason)));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  Words words = SplitComplete(bytes);
  if (words.empty()) {
    throw UserError(fmt::format("{}: its code {}", what, EndText(status)));
  }
  const std::string kind = words.front();
  words.erase(words.begin());
  if (kind == kCallError) throw command_line::CallError(words.front());
  if (kind == kUserError) throw UserError(words.front());
  return words;
}

}  // namespace runtime
