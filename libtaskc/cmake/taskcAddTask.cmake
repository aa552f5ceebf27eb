# taskc_add_task(TARGET FILE.task [OUTPUT FILE.so] [ROBOTS DIR])
#
# Builds a task into a plugin whenever TARGET is built and the task, or a file that it imports,
# extends or reads, or its robot's, has changed. TARGET is part of `all`; what needs the plugin
# depends on it by add_dependencies().
#
#   OUTPUT  where the plugin goes; by default the task's name with .so in the current build folder
#   ROBOTS  a folder in which robots are looked for first
#
# The plugin's path is in TARGET's property TASKC_PLUGIN: $<TARGET_PROPERTY:TARGET,TASKC_PLUGIN>.
function(taskc_add_task target task)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "OUTPUT;ROBOTS" "")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "taskc_add_task: unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  cmake_path(ABSOLUTE_PATH task BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  if(NOT EXISTS ${task})
    message(FATAL_ERROR "taskc_add_task: there is no file ${task}")
  endif()
  cmake_path(GET task STEM LAST_ONLY name)
  if(NOT arg_OUTPUT)
    set(arg_OUTPUT ${name}.so)
  endif()
  cmake_path(ABSOLUTE_PATH arg_OUTPUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)
  set(robots)
  if(arg_ROBOTS)
    cmake_path(ABSOLUTE_PATH arg_ROBOTS BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    set(robots --robots ${arg_ROBOTS})
  endif()
  add_custom_command(OUTPUT ${arg_OUTPUT}
    COMMAND taskc::compiler build ${task} -o ${arg_OUTPUT} --depfile ${arg_OUTPUT}.d ${robots}
    MAIN_DEPENDENCY ${task}
    DEPENDS taskc::compiler
    DEPFILE ${arg_OUTPUT}.d
    COMMENT "Building the task ${name}"
    VERBATIM)
  add_custom_target(${target} ALL DEPENDS ${arg_OUTPUT})
  set_target_properties(${target} PROPERTIES TASKC_PLUGIN ${arg_OUTPUT})
endfunction()
