# What tasks cost in other programs: those of live_bench.
project_program(host_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/host_bench.cpp
  LIBRARIES libtaskc benchmark::benchmark)
target_compile_definitions(host_bench PRIVATE TASKS="${CMAKE_CURRENT_BINARY_DIR}")
add_dependencies(host_bench live_bench_plugins)
