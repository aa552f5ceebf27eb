# How fast the robots' simulation is, and how alike its profiles are.
project_program(simulation_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/simulation_bench.cpp
          ${CMAKE_CURRENT_LIST_DIR}/engines_bench.cpp
  LIBRARIES runtime_simulation benchmark::benchmark)
project_program(profile_ensemble
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/profile_ensemble.cpp
  LIBRARIES runtime_simulation fmt::fmt)
foreach(program simulation_bench profile_ensemble)
  target_compile_definitions(${program} PRIVATE
    HUMANOID="${CMAKE_SOURCE_DIR}/plugins/humanoid/robot.toml"
    ROBOTS="${CMAKE_SOURCE_DIR}/plugins")
endforeach()
# Calls of dWorldStep go through the benchmark, which takes their time.
target_link_options(simulation_bench PRIVATE -Wl,--wrap=dWorldStep)
