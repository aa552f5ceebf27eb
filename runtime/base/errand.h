// What a process in the sandbox asks of the one outside (program_starter.h), as one message over a
// socket.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/program_starter.h"

namespace runtime {

// The first word of errands for no program: the file at the second word goes to the output.
inline constexpr const char* kReadPlugin = "read-plugin";  // an ELF file
inline constexpr const char* kReadTable = "read-table";    // one that is called `.csv`

struct Errand {
  static constexpr size_t kDescriptors = 4;  // the three streams, and the control socket

  std::vector<std::string> words;
  std::array<int, kDescriptors> descriptors{-1, -1, -1, -1};

  Streams streams() const { return {descriptors[0], descriptors[1], descriptors[2]}; }
  int control() const { return descriptors[3]; }
};

// The descriptors are the receiver's own copies. Nothing at the end of the socket.
std::optional<Errand> ReceiveErrand(int socket);
// Returns whether it was sent.
bool SendErrand(int socket, const Errand& errand);
void CloseDescriptors(const Errand& errand);

// Does the errand, if it is one for no program. Returns 0, or an errno.
int ReadForErrand(const Errand& errand);

}  // namespace runtime
