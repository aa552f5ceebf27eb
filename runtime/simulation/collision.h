// Finds where a robot touches the ground and itself, and makes the contacts.
#pragma once

#include <span>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/simulation/profile.h"
#include "runtime/simulation/robot_body.h"

namespace runtime {

// Walks a fixed list of pairs in a fixed order, which is faster for a few links than any of ODE's
// spaces, and gives the same bits in every run. Links connected by a joint do not collide.
class Collision {
 public:
  // `world` and `body` outlive the object. The ground is the plane z = 0.
  Collision(const robot::RobotDescription& robot, const RobotBody& body, dWorldID world,
            Softness softness);

  Collision(const Collision&) = delete;
  Collision& operator=(const Collision&) = delete;

  // Replaces the contacts of the step before by those of the present poses.
  void Update();
  void RemoveContacts();

  // For each link 1 if it touches the ground. From the last update.
  std::span<const unsigned char> ground() const { return ground_; }
  int contact_count() const { return contact_count_; }

 private:
  struct Pair {
    int first;
    int second;
    double reach;  // sum of the two bounding spheres' radii
  };

  void FindCentres();
  bool MayTouch(const Pair& pair) const;
  // Returns whether there is any contact between the two.
  bool AddContacts(dGeomID first, dGeomID second);

  static constexpr int kMaxContacts = 10;  // of one pair

  const RobotBody& body_;
  dWorldID world_;
  OdeGeom plane_;
  OdeJointGroup contacts_;
  dContact found_[kMaxContacts];
  std::vector<double> radii_;  // of the links' bounding spheres
  std::vector<robot::Vector3> centres_;
  std::vector<Pair> pairs_;
  std::vector<unsigned char> ground_;
  int contact_count_ = 0;
};

}  // namespace runtime
