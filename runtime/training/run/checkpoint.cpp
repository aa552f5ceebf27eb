#include "runtime/training/run/checkpoint.h"

#include <fmt/format.h>

#include <sstream>

#include "base/seal/sha256.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/compression.h"

namespace runtime {

std::string SaveModules(const ModuleGraph& graph) {
  std::ostringstream state;
  graph.Save(state);
  const std::string bytes = state.str();
  return Compress(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

std::string StateHash(const std::string& state) { return seal::Sha256(state).substr(0, 16); }

void LoadModules(ModuleGraph& graph, const std::string& state,
                 const std::set<std::string>& left_out) {
  std::istringstream bytes(Decompress(state, "the checkpoint"));
  try {
    graph.Load(bytes, left_out);
    if (bytes.peek() != std::istringstream::traits_type::eof()) {
      throw UserError("the checkpoint has more than the agent's modules need");
    }
  } catch (const UserError& error) {
    throw UserError(fmt::format("{}; start another run", error.what()));
  }
}

}  // namespace runtime
