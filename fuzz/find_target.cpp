#include <cstdio>
#include <cstdlib>

#include "fuzz/targets.h"

namespace fuzz {

void Require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "fuzz: %s\n", what);
  std::abort();
}

const Target& FindTarget(std::string_view name) {
  for (const Target& target : Targets()) {
    if (target.name == name) return target;
  }
  std::fprintf(stderr, "fuzz: there is no target of this name\n");
  std::exit(2);
}

}  // namespace fuzz
