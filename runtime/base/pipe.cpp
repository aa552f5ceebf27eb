#include "runtime/base/pipe.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

void Close(int end) {
  if (end >= 0) close(end);
}

}  // namespace

Pipe::Pipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    throw UserError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  }
  output_ = ends[0];
  input_ = ends[1];
}

Pipe::~Pipe() {
  CloseInput();
  CloseOutput();
}

void Pipe::CloseInput() { Close(TakeInput()); }

void Pipe::CloseOutput() { Close(TakeOutput()); }

int Pipe::TakeInput() { return std::exchange(input_, -1); }

int Pipe::TakeOutput() { return std::exchange(output_, -1); }

}  // namespace runtime
