// What of a robot and of the things around it touches what, as MuJoCo finds it.
#pragma once

#include <span>
#include <vector>

#include "runtime/training/simulation/mujoco_library.h"
#include "runtime/training/simulation/spatial.h"

namespace runtime {

class MujocoContacts {
 public:
  // `model` outlives the object.
  MujocoContacts(const mjModel& model, size_t links, size_t things);

  // That `owner`, a link or after them a thing that moves, is MuJoCo's body of this number. All
  // others belong to the ground.
  void SetOwner(int body, int owner) { owners_[static_cast<size_t>(body)] = owner; }
  // That a thing, which moves or not, is the geom of this number.
  void SetThing(int geom, size_t thing) {
    things_[static_cast<size_t>(geom)] = static_cast<int>(thing);
  }

  // Takes in the contacts that MuJoCo has found.
  void Read(const mjData& data);
  // For each link 1 if it touches the ground, or the thing.
  std::span<const unsigned char> ground() const { return ground_; }
  std::span<const unsigned char> touches(size_t thing) const {
    return {&touches_[thing * ground_.size()], ground_.size()};
  }

  // Adds what the contacts do to each link and thing in a step of this length [N s].
  void AddImpulses(const mjData& data, double time_step, std::span<Vector3> impulses) const;

 private:
  int OwnerOf(int geom) const { return owners_[static_cast<size_t>(model_.geom_bodyid[geom])]; }
  void ReadTouch(int geom, int owner);

  const mjModel& model_;
  std::vector<int> owners_;             // of each body, or Contact::kGround
  std::vector<int> things_;             // that each geom is, or -1
  std::vector<unsigned char> ground_;   // [link]
  std::vector<unsigned char> touches_;  // [thing][link]
};

}  // namespace runtime
