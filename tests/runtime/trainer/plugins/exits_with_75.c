// With a status that says to many programs: try again.
#define STATUS 75
#include "exits.c"
