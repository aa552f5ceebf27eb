#include "tests/runtime/core/task/allocation_count.h"

#include <cstdlib>
#include <new>

namespace {
int64_t count = 0;
}

int64_t AllocationCount() { return count; }

void* operator new(size_t size) {
  ++count;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }
