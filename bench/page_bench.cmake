# What it costs a run that its page is open.
find_package(fmt REQUIRED)

project_program(page_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/page_bench.cpp
  LIBRARIES runtime_client runtime_run runtime_server fmt::fmt benchmark::benchmark)
target_compile_definitions(page_bench PRIVATE
  SOURCE_DIR="${CMAKE_SOURCE_DIR}"
  TRAINER="$<TARGET_FILE:trainer>")
add_dependencies(page_bench trainer)
