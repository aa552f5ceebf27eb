# Simulates robots as the profile `mujoco`, and reads URDF and MJCF. Without it both say what is
# missing. Debian's own configuration of it names folders that are not there.
find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h)
find_library(MUJOCO_LIBRARY mujoco)
mark_as_advanced(MUJOCO_INCLUDE_DIR MUJOCO_LIBRARY)
if(MUJOCO_INCLUDE_DIR AND MUJOCO_LIBRARY)
  set(TASKC_HAS_MUJOCO ON)
  add_library(mujoco INTERFACE)
  target_include_directories(mujoco SYSTEM INTERFACE ${MUJOCO_INCLUDE_DIR})
  target_link_libraries(mujoco INTERFACE ${MUJOCO_LIBRARY})
else()
  set(TASKC_HAS_MUJOCO OFF)
endif()
