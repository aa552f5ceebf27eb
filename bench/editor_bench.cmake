# How long an editor's user waits.
project_program(editor_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/editor_bench.cpp
  LIBRARIES compiler_language_server benchmark::benchmark)
target_compile_definitions(editor_bench PRIVATE SOURCE_DIR="${CMAKE_SOURCE_DIR}")
