#pragma once

#ifdef __cplusplus
extern "C" {
#endif

// What a link's contact is at the start of an episode and after each step [s].
void FilterContacts(double step, const unsigned char* touches, int count, unsigned char* contact);

#ifdef __cplusplus
}
#endif
