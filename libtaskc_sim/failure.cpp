#include "libtaskc_sim/failure.h"

#include <system_error>

namespace libtaskc_sim {

taskc_status KeepHandled(taskc_status of_runtime) noexcept {
  using libtaskc::Keep;
  try {
    throw;
  } catch (const Failure& failure) {
    return Keep(failure.status(), failure.what());
  } catch (const host::PluginError& error) {
    return Keep(libtaskc::StatusOf(error.defect()), error.what());
  } catch (const std::bad_alloc&) {
    return Keep(TASKC_ERROR_NO_MEMORY, "there is not enough memory");
  } catch (const std::system_error& error) {  // a thread that could not be made
    return Keep(TASKC_ERROR_NO_MEMORY, error.what());
  } catch (const std::exception& error) {
    return Keep(of_runtime, error.what());
  } catch (...) {
    return Keep(of_runtime, "something unknown was thrown");
  }
}

}  // namespace libtaskc_sim
