// Counts in the environment how often it was loaded.
#include <stdio.h>
#include <stdlib.h>

#define NAME "counted"
#include "paying.h"

__attribute__((constructor)) static void count(void) {
  const char* const before = getenv("COUNTED_LOADS");
  char loads[16];
  snprintf(loads, sizeof loads, "%d", (before == NULL ? 0 : atoi(before)) + 1);
  setenv("COUNTED_LOADS", loads, 1);
}
