# Needs made-up runs and the page's parts.
if(NOT TARGET sample_study OR NOT TARGET web)
  return()
endif()

project_program(report_bench
  SOURCES report_bench.cpp
  LIBRARIES runtime_picture runtime_report runtime_run runtime_study sample_run sample_study
            benchmark::benchmark_main)
add_dependencies(report_bench web)
