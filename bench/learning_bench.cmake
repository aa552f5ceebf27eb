project_program(learning_bench
  SOURCES learning_bench.cpp
  LIBRARIES runtime_learning benchmark::benchmark_main)
target_compile_definitions(learning_bench PRIVATE SOURCE_DIR="${CMAKE_SOURCE_DIR}")
