// The filters of a robot's contacts: taskc/contact_filter.h says what they do.
#pragma once

#include <taskc/contact_filter.h>

#include <span>
#include <vector>

namespace runtime {

// One for each link.
class ContactFilter {
 public:
  ContactFilter(int links, double time_step)
      : filter_(taskc_contact_filter_for(time_step)), links_(links) {}

  // As if the contacts had been like that for long.
  void Start(std::span<const unsigned char> raw) {
    for (size_t i = 0; i < links_.size(); ++i) taskc_contact_start(&filter_, &links_[i], raw[i]);
  }
  // One physics step.
  void Update(std::span<const unsigned char> raw) {
    for (size_t i = 0; i < links_.size(); ++i) taskc_contact_step(&filter_, &links_[i], raw[i]);
  }

  bool flag(int link) const { return taskc_is_contact(&links_[link]) != 0; }

 private:
  taskc_contact_filter filter_;
  std::vector<taskc_contact> links_;
};

}  // namespace runtime
