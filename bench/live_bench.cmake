# What it costs that tasks can be exchanged, compared and talked to while a robot learns.
find_package(fmt REQUIRED)

set(plugins)
foreach(task crawling turning)
  set(plugin ${CMAKE_CURRENT_BINARY_DIR}/${task}.so)
  add_custom_command(OUTPUT ${plugin}
    COMMAND taskc build ${CMAKE_SOURCE_DIR}/tasks/${task}.task -o ${plugin}
    DEPENDS taskc ${CMAKE_SOURCE_DIR}/tasks/${task}.task ${CMAKE_SOURCE_DIR}/plugins/humanoid/robot.toml)
  list(APPEND plugins ${plugin})
endforeach()
add_custom_target(live_bench_plugins DEPENDS ${plugins})

project_program(live_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/live_bench.cpp
  LIBRARIES runtime_agent runtime_client runtime_control fmt::fmt benchmark::benchmark)
target_compile_definitions(live_bench PRIVATE
  SOURCE_DIR="${CMAKE_SOURCE_DIR}"
  PLUGIN_FOLDER="${CMAKE_CURRENT_BINARY_DIR}"
  TRAINER="$<TARGET_FILE:trainer>")
add_dependencies(live_bench live_bench_plugins trainer)
