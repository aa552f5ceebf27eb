#define NAME "steady"
#include "paying.h"
