// Finds where a robot touches the ground and itself.
#pragma once

#include <span>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/robot_body.h"

namespace runtime {

// A point at which two links, or a link and the ground, touch.
struct Contact {
  static constexpr int kGround = -1;

  int first;   // link, or kGround; the geometry's normal points into it
  int second;  // link, or kGround
  dContactGeom geometry;
  double friction;  // coefficient; infinity where nothing slides
};

// Walks a fixed list of pairs in a fixed order, which is faster for a few links than any of ODE's
// spaces, and gives the same bits in every run. Links connected by a joint do not collide.
class Collision {
 public:
  // `body` outlives the object. The ground is the plane z = 0.
  Collision(const robot::RobotDescription& robot, const RobotBody& body);

  Collision(const Collision&) = delete;
  Collision& operator=(const Collision&) = delete;

  // Finds the contacts of the present poses.
  void Update();

  // From the last update.
  std::span<const Contact> contacts() const { return contacts_; }

  // For each link 1 if it touches the ground. From the last update.
  std::span<const unsigned char> ground() const { return ground_; }

 private:
  struct Pair {
    int first;
    int second;
    double reach;  // sum of the two bounding spheres' radii
  };

  void FindCenters();  // of the links' shapes
  bool MayTouch(const Pair& pair) const;
  // Returns whether there is any contact between the two links, of which one may be the ground.
  bool AddContacts(int first, int second);
  dGeomID GeomOf(int link) const;

  static constexpr int kMaxContacts = 10;  // of one pair

  const RobotBody& body_;
  OdeGeom plane_;
  int first_movable_;          // link: a fixed base touches no ground
  std::vector<double> radii_;  // of the links' bounding spheres
  std::vector<double> frictions_;
  std::vector<robot::Vector3> centers_;
  std::vector<Pair> pairs_;
  std::vector<unsigned char> ground_;
  std::vector<Contact> contacts_;
};

}  // namespace runtime
