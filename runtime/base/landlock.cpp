#include "runtime/base/landlock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

// As in linux/landlock.h of a later kernel than the one that this is built on.
struct RulesetAttributes {
  uint64_t files = 0;
  uint64_t network = 0;  // from version 4
  uint64_t scopes = 0;   // from version 6
};
constexpr uint64_t kRefer = uint64_t{1} << 13;        // from version 2: rename to another folder
constexpr uint64_t kTruncate = uint64_t{1} << 14;     // from version 3
constexpr uint64_t kIoctlDevice = uint64_t{1} << 15;  // from version 5
constexpr uint64_t kBindTcp = uint64_t{1} << 0;
constexpr uint64_t kConnectTcp = uint64_t{1} << 1;
constexpr uint64_t kAbstractSockets = uint64_t{1} << 0;
constexpr uint64_t kSignals = uint64_t{1} << 1;

constexpr uint64_t kRead = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr uint64_t kWrite = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                            LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_DIR |
                            LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SOCK |
                            LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_SYM;
// What nobody needs, and so nobody is granted.
constexpr uint64_t kNever =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_BLOCK;
constexpr uint64_t kOfFiles =
    LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate;

class Ruleset {
 public:
  explicit Ruleset(int version) {
    attributes_.files = kRead | kWrite | kNever;
    if (version >= 2) attributes_.files |= kRefer;
    if (version >= 3) attributes_.files |= kTruncate;
    if (version >= 5) attributes_.files |= kIoctlDevice;
    if (version >= 4) attributes_.network = kBindTcp | kConnectTcp;
    if (version >= 6) attributes_.scopes = kAbstractSockets | kSignals;
    // An older kernel takes the shorter struct, a newer one takes both.
    const size_t size = version >= 6   ? sizeof attributes_
                        : version >= 4 ? offsetof(RulesetAttributes, scopes)
                                       : offsetof(RulesetAttributes, network);
    descriptor_ =
        static_cast<int>(syscall(SYS_landlock_create_ruleset, &attributes_, size, uint32_t{0}));
    if (descriptor_ < 0) Refuse("cannot be set up");
  }
  Ruleset(const Ruleset&) = delete;
  Ruleset& operator=(const Ruleset&) = delete;
  ~Ruleset() { close(descriptor_); }

  void Allow(const std::filesystem::path& path, uint64_t access) const {
    const int parent = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (parent < 0) return;
    struct stat status {};
    access &= attributes_.files;
    if (fstat(parent, &status) == 0 && !S_ISDIR(status.st_mode)) access &= kOfFiles;
    landlock_path_beneath_attr rule{};
    rule.allowed_access = access;
    rule.parent_fd = parent;
    const bool is_added = syscall(SYS_landlock_add_rule, descriptor_, LANDLOCK_RULE_PATH_BENEATH,
                                  &rule, uint32_t{0}) == 0;
    const int reason = errno;
    close(parent);
    if (is_added || reason == EBADFD) return;  // the latter is of memory, which is not restricted
    errno = reason;
    Refuse(fmt::format("cannot grant `{}`", path.string()));
  }

  void Enforce() const {
    if (syscall(SYS_landlock_restrict_self, descriptor_, uint32_t{0}) != 0) {
      Refuse("cannot be entered");
    }
  }

 private:
  [[noreturn]] static void Refuse(const std::string& what) {
    throw UserError(fmt::format("the sandbox {}: {}; `--no-sandbox` does without it", what,
                                std::strerror(errno)));
  }

  RulesetAttributes attributes_;
  int descriptor_ = -1;
};

}  // namespace

int LandlockVersion() {
  const long version =
      syscall(SYS_landlock_create_ruleset, nullptr, size_t{0}, LANDLOCK_CREATE_RULESET_VERSION);
  return static_cast<int>(std::max(0L, version));
}

void RestrictFiles(const FileRules& rules) {
  const int version = LandlockVersion();
  if (version == 0) return;
  const Ruleset ruleset(version);
  for (const std::filesystem::path& path : rules.readable) ruleset.Allow(path, kRead);
  for (const std::filesystem::path& path : rules.writable) {
    ruleset.Allow(path, kRead | kWrite | kRefer | kTruncate);
  }
  for (const std::filesystem::path& path : rules.tidied) {
    ruleset.Allow(path, LANDLOCK_ACCESS_FS_REMOVE_DIR);
  }
  ruleset.Enforce();
}

}  // namespace runtime
