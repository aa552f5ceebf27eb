#pragma once

#include <cstdint>

// How often the program has asked for memory from the heap with `new`.
int64_t AllocationCount();
