// The Unix socket in a run's folder, over which its trainer is talked to. It is reached through the
// folder's descriptor: a socket's address has no room for a long path.
#pragma once

#include <filesystem>

#include "runtime/live/server/descriptor.h"

namespace runtime {

// Throws UserError where there is no such folder.
Descriptor OpenRunFolder(const std::filesystem::path& folder);

// A connection to the trainer that works in `folder`; not open where none answers.
Descriptor ConnectToTrainer(const Descriptor& folder);

// control.sock in a run's folder, for its owner only. It is there for as long as this object lives.
class ControlSocket {
 public:
  // Takes the place of a socket that a killed trainer has left. `path`: of the folder, for
  // messages. Throws UserError where a living one listens, or where no socket can be made. `folder`
  // must outlive this object.
  ControlSocket(const Descriptor& folder, const std::filesystem::path& path);
  ControlSocket(const ControlSocket&) = delete;
  ControlSocket& operator=(const ControlSocket&) = delete;
  ~ControlSocket();

  // Listens, without ever blocking. To be asked for once: it becomes the caller's.
  Descriptor TakeListener() { return std::move(listener_); }

 private:
  const Descriptor& folder_;
  Descriptor listener_;
};

}  // namespace runtime
