add_executable(simulation_bench simulation_bench.cpp)
target_link_libraries(simulation_bench PRIVATE runtime_simulation benchmark::benchmark_main)
target_compile_definitions(simulation_bench PRIVATE
  HUMANOID="${CMAKE_SOURCE_DIR}/plugins/humanoid/robot.toml")
# Calls of dWorldStep go through the benchmark, which takes their time.
target_link_options(simulation_bench PRIVATE -Wl,--wrap=dWorldStep)
