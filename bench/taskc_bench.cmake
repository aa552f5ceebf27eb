# What a user of taskc waits for, and what a callback costs.
find_package(fmt REQUIRED)

project_program(taskc_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/taskc_bench.cpp
  LIBRARIES compiler_build compiler_emit compiler_syntax fmt::fmt robot task_host
    benchmark::benchmark ${CMAKE_DL_LIBS})
target_compile_definitions(taskc_bench PRIVATE
  SOURCE_DIR="${CMAKE_SOURCE_DIR}" TASKC="$<TARGET_FILE:taskc>")
add_dependencies(taskc_bench taskc)

# The callbacks of crawling as taskc emits them, to be inlined.
set(emitted ${CMAKE_CURRENT_BINARY_DIR}/crawling_callback.inc)
add_custom_command(OUTPUT ${emitted}
  COMMAND taskc emit ${CMAKE_SOURCE_DIR}/tasks/crawling.task -o ${emitted}
  DEPENDS taskc ${CMAKE_SOURCE_DIR}/tasks/crawling.task ${CMAKE_SOURCE_DIR}/plugins/humanoid/robot.toml)
target_sources(taskc_bench PRIVATE ${emitted})
target_include_directories(taskc_bench PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
# As plugins are compiled.
target_compile_options(taskc_bench PRIVATE -O2 -fno-math-errno -Wno-unused)
