# What a user of taskc waits for, and what a callback costs.
find_package(fmt REQUIRED)

project_program(taskc_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/taskc_bench.cpp
  LIBRARIES compiler_build compiler_emit compiler_syntax fmt::fmt robot taskc_abi
    benchmark::benchmark ${CMAKE_DL_LIBS})
target_compile_definitions(taskc_bench PRIVATE
  SOURCE_DIR="${CMAKE_SOURCE_DIR}" TASKC="$<TARGET_FILE:taskc>")
add_dependencies(taskc_bench taskc)
