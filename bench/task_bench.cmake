# What a task costs in a control step.
project_program(task_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/task_bench.cpp
  LIBRARIES runtime_simulation runtime_task fmt::fmt benchmark::benchmark)
target_compile_definitions(task_bench PRIVATE
  SOURCE_DIR="${CMAKE_SOURCE_DIR}" TASKC="$<TARGET_FILE:taskc>"
  HUMANOID="${CMAKE_SOURCE_DIR}/plugins/humanoid/robot.toml")
add_dependencies(task_bench taskc)
