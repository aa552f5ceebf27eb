#pragma once

namespace libtaskc_sim {

// Robots and agents that come with taskc lie beside this library, not beside the program that uses
// it: from now on they are looked for there.
void FindSharedFiles();

}  // namespace libtaskc_sim
