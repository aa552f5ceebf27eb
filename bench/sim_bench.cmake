# How fast environments for other programs are: crawling of live_bench.
project_program(sim_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/sim_bench.cpp
  LIBRARIES libtaskc_sim benchmark::benchmark)
target_compile_definitions(sim_bench PRIVATE PLUGIN_FOLDER="${CMAKE_CURRENT_BINARY_DIR}")
add_dependencies(sim_bench live_bench_plugins)
