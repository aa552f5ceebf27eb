// A host in C that has raw contacts.
#include "tests/libtaskc/contact_filter_host.h"

#include <taskc/contact_filter.h>

void FilterContacts(double step, const unsigned char* touches, int count, unsigned char* contact) {
  const taskc_contact_filter filter = taskc_contact_filter_for(step);
  taskc_contact link;
  contact[0] = (unsigned char)taskc_contact_start(&filter, &link, touches[0]);
  for (int i = 1; i < count; ++i) {
    contact[i] = (unsigned char)taskc_contact_step(&filter, &link, touches[i]);
  }
}
