#define NAME "seeing"
#define SEES
#include "paying.h"
