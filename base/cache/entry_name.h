// The names of what both programs put into a cache. The folder may hold files of others as well:
// what has none of these names is not ours.
#pragma once

#include <string>
#include <string_view>

namespace cache {

enum class EntryKind {
  kForeign,
  kFile,        // a plugin or a net, with a seal (base/seal) at its end
  kEvidence,    // a folder: a task of which taskc has made something wrong
  kUnfinished,  // a file or folder that is being made, or was when its maker was killed
};

// By its name alone.
EntryKind KindOf(std::string_view name);

// `key`: 32 hexadecimal digits of the hash of all that it is made from.
std::string PluginName(std::string_view task, std::string_view key);
// Evidence: the C++ compiler has refused what taskc made, or it computes something else.
std::string RefusalName(std::string_view task, std::string_view key);
std::string DifferenceName(std::string_view task, std::string_view key);
std::string NetName(std::string_view key);

// A pattern for mkstemp() and mkdtemp(). `what`: the task, or "net".
std::string UnfinishedName(std::string_view what, std::string_view key);

}  // namespace cache
