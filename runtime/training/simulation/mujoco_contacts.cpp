#include "runtime/training/simulation/mujoco_contacts.h"

#include <algorithm>

#include "runtime/training/simulation/collision.h"

namespace runtime {

MujocoContacts::MujocoContacts(const mjModel& model, size_t links, size_t things)
    : model_(model),
      owners_(static_cast<size_t>(model.nbody), Contact::kGround),
      things_(static_cast<size_t>(model.ngeom), -1),
      ground_(links, 0),
      touches_(links * things, 0) {}

void MujocoContacts::Read(const mjData& data) {
  std::ranges::fill(ground_, 0);
  std::ranges::fill(touches_, 0);
  for (int i = 0; i < data.ncon; ++i) {
    const mjContact& contact = data.contact[i];
    ReadTouch(contact.geom1, OwnerOf(contact.geom2));
    ReadTouch(contact.geom2, OwnerOf(contact.geom1));
  }
}

// `owner`: of what touches the geom.
void MujocoContacts::ReadTouch(int geom, int owner) {
  const auto link = static_cast<size_t>(owner);
  if (owner == Contact::kGround || link >= ground_.size()) return;
  const int thing = things_[static_cast<size_t>(geom)];
  if (thing >= 0) {
    touches_[static_cast<size_t>(thing) * ground_.size() + link] = 1;
  } else if (OwnerOf(geom) == Contact::kGround) {
    ground_[link] = 1;
  }
}

// A contact's force is told in its own frame, and acts on the second of the two shapes.
void MujocoContacts::AddImpulses(const mjData& data, double time_step,
                                 std::span<Vector3> impulses) const {
  for (int i = 0; i < data.ncon; ++i) {
    const mjContact& contact = data.contact[i];
    mjtNum force[6];
    mj_contactForce(&model_, &data, i, force);
    const Vector3 impulse = time_step * Matrix3::Map(contact.frame).transpose() * ToEigen(force);
    const int first = OwnerOf(contact.geom1);
    const int second = OwnerOf(contact.geom2);
    if (first != Contact::kGround) impulses[static_cast<size_t>(first)] -= impulse;
    if (second != Contact::kGround) impulses[static_cast<size_t>(second)] += impulse;
  }
}

}  // namespace runtime
