// The Open Dynamics Engine as this project uses it: initialized once, errors as exceptions, handles
// that destroy what they own.
#pragma once

#include <ode/ode.h>

#include <exception>
#include <memory>
#include <string>
#include <type_traits>

namespace runtime {

// A state that ODE cannot continue from, and would have stopped the program for.
class OdeFailure : public std::exception {
 public:
  explicit OdeFailure(std::string message) : message_(std::move(message)) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

// Makes ODE ready for the calling thread, and the first time for the program. Must have been called
// in every thread that makes or steps a world. From then on ODE throws OdeFailure instead of
// aborting, and prints nothing.
void UseOdeInThisThread();

template <auto Destroy>
struct OdeDeleter {
  template <class T>
  void operator()(T* object) const {
    Destroy(object);
  }
};
template <class Id, auto Destroy>
using OdeHandle = std::unique_ptr<std::remove_pointer_t<Id>, OdeDeleter<Destroy>>;

using OdeWorld = OdeHandle<dWorldID, dWorldDestroy>;
using OdeBody = OdeHandle<dBodyID, dBodyDestroy>;
using OdeGeom = OdeHandle<dGeomID, dGeomDestroy>;
using OdeJoint = OdeHandle<dJointID, dJointDestroy>;
using OdeJointGroup = OdeHandle<dJointGroupID, dJointGroupDestroy>;
using OdeThreading = OdeHandle<dThreadingImplementationID, dThreadingFreeImplementation>;

// A step that failed half-way leaves work behind in ODE's threading, which cannot be destroyed
// then. Keeps it until the end of the program.
void KeepForever(OdeThreading threading);

}  // namespace runtime
