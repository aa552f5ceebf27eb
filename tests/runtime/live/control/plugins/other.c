#define NAME "other"
#include "paying.h"
