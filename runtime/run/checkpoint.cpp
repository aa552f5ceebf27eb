#include "runtime/run/checkpoint.h"

#include <fmt/format.h>

#include <cstdint>
#include <sstream>

#include "runtime/module/user_error.h"
#include "runtime/run/compression.h"

namespace runtime {
namespace {

// Per module, in the order of the network: length and name, length and what the module wrote.
void WriteText(std::ostream& out, const std::string& text) {
  const uint64_t size = text.size();
  out.write(reinterpret_cast<const char*>(&size), sizeof size);
  out.write(text.data(), static_cast<std::streamsize>(size));
}

// The rest of the blob and what is read from its front.
class BlobReader {
 public:
  explicit BlobReader(std::string_view rest) : rest_(rest) {}

  bool done() const { return rest_.empty(); }

  std::string ReadText() {
    uint64_t size = 0;
    if (rest_.size() < sizeof size) Fail();
    rest_.copy(reinterpret_cast<char*>(&size), sizeof size);
    rest_.remove_prefix(sizeof size);
    if (rest_.size() < size) Fail();
    std::string text(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return text;
  }

 private:
  [[noreturn]] static void Fail() {
    throw UserError("the checkpoint is damaged: it ends too early; start another run");
  }
  std::string_view rest_;
};

}  // namespace

std::string SaveModules(const Network& network) {
  std::ostringstream blob;
  for (const auto& module : network.modules()) {
    std::ostringstream state;
    module->Save(state);
    WriteText(blob, module->name());
    WriteText(blob, state.str());
  }
  const std::string bytes = blob.str();
  return Compress(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

void LoadModules(Network& network, const std::string& state) {
  const std::string bytes = Decompress(state, "the checkpoint");
  BlobReader blob(bytes);
  for (const auto& module : network.modules()) {
    const std::string name = blob.done() ? "" : blob.ReadText();
    if (name != module->name()) {
      throw UserError(fmt::format(
          "the checkpoint does not fit the agent: it has no state for module `{}` where it should; "
          "start another run",
          module->name()));
    }
    std::istringstream in(blob.ReadText());
    module->Load(in);
    if (in.fail()) {
      throw UserError(fmt::format(
          "the checkpoint is damaged: module `{}` cannot read its state; start another run", name));
    }
  }
  if (!blob.done()) {
    throw UserError(
        "the checkpoint does not fit the agent: it has more modules; start another run");
  }
}

}  // namespace runtime
