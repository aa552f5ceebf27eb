/* Lets an exported policy decide what a robot has decided, and prints the largest difference.
 *
 *   decide DECISIONS.csv
 *
 * The exit status is 1 where a target differs by more than 1e-5. */
#include <stdio.h>
#include <stdlib.h>

#include "policy.h"

enum { kMostNumbers = 4096 };

int main(int argc, char** argv) {
  static char line[1 << 18];
  FILE* decisions = argc == 2 ? fopen(argv[1], "r") : NULL;
  double largest = 0;
  int count = 0;
  if (decisions == NULL || fgets(line, sizeof line, decisions) == NULL) return 2;
  for (; fgets(line, sizeof line, decisions) != NULL; ++count) {
    static double numbers[kMostNumbers]; /* the time, the observation, ..., the targets */
    float observation[POLICY_OBSERVATIONS];
    float targets[POLICY_TARGETS];
    int size = 0;
    char* next = line;
    while (*next != '\0' && *next != '\n' && size < kMostNumbers) {
      numbers[size++] = strtod(next, &next);
      if (*next == ',') ++next;
    }
    for (int i = 0; i < POLICY_OBSERVATIONS; ++i) observation[i] = (float)numbers[1 + i];
#ifdef POLICY_MOTION_COLUMNS
    float offsets[POLICY_TARGETS];
    policy_step(observation, offsets);
    policy_targets(numbers[0], offsets, targets);
#else
    policy_step(observation, targets);
#endif
    for (int i = 0; i < POLICY_TARGETS; ++i) {
      const double difference = fabs(targets[i] - numbers[size - POLICY_TARGETS + i]);
      if (!(difference <= largest)) largest = difference;
    }
  }
  fclose(decisions);
  printf("%d decisions: %g\n", count, largest);
  return count > 0 && largest <= 1e-5 ? 0 : 1;
}
