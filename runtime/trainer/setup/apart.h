// Work in a process of its own, so that what it loads, breaks or gives up is gone with it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace runtime {

using Words = std::vector<std::string>;  // of any bytes

// Forks, and returns what `work` returns there. Throws what it throws there, UserError and
// CallError as such; UserError, which names `what`, where the process ended otherwise. To be called
// where there are no other threads.
Words RunApart(const std::string& what, const std::function<Words()>& work);

}  // namespace runtime
