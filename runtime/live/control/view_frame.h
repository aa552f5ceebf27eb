// What those who watch a run get to see of its episodes; docs/api.md says what the bytes are.
#pragma once

#include <memory>
#include <string>

namespace runtime {

// What is wanted: instants of the episode that is running, up to thirty a second; a whole episode
// from its start to its end.
struct ViewWish {
  bool instants = false;
  bool episode = false;
};

// An instant, or an episode. Shared by all to whom it is sent.
struct ViewFrame {
  bool is_episode = false;
  // What the numbers of `content` are, as JSON: the same object as long as they stay what they are.
  std::shared_ptr<const std::string> layout;
  std::shared_ptr<const std::string> content;
};

}  // namespace runtime
