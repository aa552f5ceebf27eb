// Finds where a robot touches the ground, itself and the things around it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/robot_body.h"
#include "runtime/training/simulation/surroundings.h"

namespace runtime {

// A point at which two bodies, or a body and what does not move, touch.
struct Contact {
  static constexpr int kGround = -1;  // and things that are fixed

  int first;   // body: a link or a thing, or kGround; the geometry's normal points into it
  int second;  // body, or kGround
  dContactGeom geometry;
  double friction;  // coefficient; infinity where nothing slides
};

// The links of a robot that collide with each other, as pairs in ascending order.
std::vector<std::array<int, 2>> CollidingLinks(const robot::RobotDescription& robot);

// Walks a fixed list of pairs in a fixed order, which is faster for a few links than any of ODE's
// spaces, and gives the same bits in every run. Links connected by a joint do not collide.
class Collision {
 public:
  // `body` and `around` outlive the object.
  Collision(const robot::RobotDescription& robot, const RobotBody& body,
            const Surroundings& around);

  Collision(const Collision&) = delete;
  Collision& operator=(const Collision&) = delete;

  // Finds the contacts of the present poses.
  void Update();

  // From the last update.
  std::span<const Contact> contacts() const { return contacts_; }

  // For each link 1 if it touches the ground. From the last update.
  std::span<const unsigned char> ground() const { return {ground_.data(), links_}; }
  // For each link 1 if it touches the thing. From the last update.
  std::span<const unsigned char> touches(size_t thing) const {
    return {&touches_[thing * links_], links_};
  }

 private:
  struct Solid {
    dGeomID geom;
    int body;       // or kGround
    double radius;  // of its bounding sphere
    double friction;
    std::span<const Vector3> corners{};  // of a convex link
  };
  struct Part {
    const GroundPart* ground;
    Solid solid;
  };
  struct Pair {
    size_t first;
    size_t second;
    double reach;    // sum of the two bounding spheres' radii
    int touch = -1;  // of a link and a thing: which of touches_
  };

  void AddSolids(const robot::RobotDescription& robot, const RobotBody& body,
                 const Surroundings& around);
  // `are_joined`: whether two links do not collide.
  template <class AreJoined>
  void AddPairs(const AreJoined& are_joined);
  bool TouchesGround(size_t solid);
  bool MayTouch(const Pair& pair) const;
  static int FindContacts(const Solid& first, const Solid& second, std::span<dContactGeom> found);
  // Returns whether there is any contact between the two.
  bool AddContacts(const Solid& first, const Solid& second);

  static constexpr int kMaxContacts = 10;  // of one pair

  size_t links_;
  int first_movable_;  // link: a fixed base touches no ground
  std::vector<Part> parts_;
  std::vector<Solid> solids_;  // the links, then the things
  std::vector<robot::Vector3> centers_;
  std::vector<Pair> pairs_;
  std::vector<unsigned char> ground_;
  std::vector<unsigned char> touches_;  // [thing][link]
  std::vector<Contact> contacts_;
};

}  // namespace runtime
