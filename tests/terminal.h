// Programs on a terminal of their own.
#pragma once

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

// Whether this machine has pseudo terminals; a bare chroot has none.
inline bool HasTerminals() { return std::filesystem::exists("/dev/pts/ptmx"); }

// What the program of words[0] prints on a terminal where a person types `typed`.
inline std::string PrintedOnTerminal(const std::vector<std::string>& words,
                                     const std::string& typed = "") {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  std::string printed;
  if (write(terminal, typed.data(), typed.size()) != static_cast<ssize_t>(typed.size())) {
    printed = "(the terminal does not take what is typed)\n";
  }
  char bytes[4096];
  for (ssize_t size; (size = read(terminal, bytes, sizeof bytes)) > 0;) {
    printed.append(bytes, static_cast<size_t>(size));
  }
  close(terminal);
  waitpid(child, nullptr, 0);
  return printed;
}
