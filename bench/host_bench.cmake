# What tasks cost in other programs.
set(host_bench_tasks)
foreach(task crawling turning)
  set(plugin ${CMAKE_CURRENT_BINARY_DIR}/${task}.so)
  add_custom_command(OUTPUT ${plugin}
    COMMAND taskc build ${CMAKE_SOURCE_DIR}/tasks/${task}.task -o ${plugin}
    DEPENDS taskc ${CMAKE_SOURCE_DIR}/tasks/${task}.task)
  list(APPEND host_bench_tasks ${plugin})
endforeach()
project_program(host_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/host_bench.cpp ${host_bench_tasks}
  LIBRARIES libtaskc benchmark::benchmark)
target_compile_definitions(host_bench PRIVATE TASKS="${CMAKE_CURRENT_BINARY_DIR}")
