# Whole training runs.
find_package(nlohmann_json REQUIRED)

project_program(trainer_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/trainer_bench.cpp
  LIBRARIES runtime_simulation fmt::fmt nlohmann_json::nlohmann_json benchmark::benchmark)
target_compile_definitions(trainer_bench PRIVATE
  SOURCE_DIR="${CMAKE_SOURCE_DIR}" TRAINER="$<TARGET_FILE:trainer>")
add_dependencies(trainer_bench trainer taskc robot_files)
