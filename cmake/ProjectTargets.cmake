# What all targets of this project have in common.

add_library(project_options INTERFACE)
target_include_directories(project_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(project_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Werror
  # g++ 12 sees overlaps in std::string that are none.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # Equal bits on every machine of one kind: no fused operations behind our back.
  -ffp-contract=off)
target_compile_definitions(project_options INTERFACE TASKC_VERSION="${PROJECT_VERSION}")
if(TASKC_SANITIZE)
  target_compile_options(project_options INTERFACE
    -fsanitize=${TASKC_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    # With sanitizers g++ 12 takes parts of std::regex for uninitialized.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(project_options INTERFACE -fsanitize=${TASKC_SANITIZE})
endif()

# libFuzzer comes with clang; without it the fuzzers have a main function of their own.
set(TASKC_LIBFUZZER OFF)
if(TASKC_FUZZ AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  set(TASKC_LIBFUZZER ON)
  target_compile_options(project_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# Compiles the files of a target in batches, each as one: the headers that they share, and the
# templates in them, are compiled once. The larger the batches, the sooner all is built (those of 24
# files take six tenths of the time of those of 6), and the later what one changed file asks for. No
# two files of a target may give one name to different things, in unnamed namespaces neither.
option(TASKC_UNITY "compile several files of a target as one" ON)
function(project_compile_in_batches name)
  set_target_properties(${name} PROPERTIES
    UNITY_BUILD ${TASKC_UNITY} UNITY_BUILD_BATCH_SIZE 24)
endfunction()

# project_optimize(TARGET LEVEL): in a release, with -O<LEVEL> instead of -O2.
function(project_optimize name level)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O${level}>)
endfunction()

# project_share_code(TARGET...): these libraries are also part of shared ones. Calls within them stay
# direct, as in a program.
function(project_share_code)
  foreach(name IN LISTS ARGN)
    set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  endforeach()
endfunction()

# project_library(NAME SOURCES file... [PUBLIC library...] [PRIVATE library...])
function(project_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_link_libraries(${name} PUBLIC project_options ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  project_compile_in_batches(${name})
endfunction()

# project_program(NAME SOURCES file... [LIBRARIES library...])
function(project_program name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE project_options ${arg_LIBRARIES})
  project_compile_in_batches(${name})
endfunction()

# project_share_file(TARGET FILE DESTINATION): a file that the programs look for in share/taskc, put
# there in the build tree as by an installation. The target stands for the one in the build tree.
function(project_share_file target file destination)
  set(staged ${CMAKE_BINARY_DIR}/share/taskc/${destination})
  add_custom_command(OUTPUT ${staged}
    COMMAND ${CMAKE_COMMAND} -E copy ${file} ${staged}
    DEPENDS ${file})
  add_custom_target(${target} ALL DEPENDS ${staged})
  cmake_path(GET destination PARENT_PATH folder)
  install(FILES ${file} DESTINATION share/taskc/${folder})
endfunction()

# project_test(NAME SOURCES file... [LIBRARIES library...]): a GoogleTest program, registered whole.
function(project_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE project_options ${arg_LIBRARIES} GTest::gmock_main)
  project_compile_in_batches(${name})
  project_optimize(${name} 1)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 300)
endfunction()

# The packages that package.json and package-lock.json beside the caller name, installed into its
# build folder by `npm ci`: once, and again when one of the two changes. `what`: whose they are. Sets
# `packages` to the file that what needs them depends on.
function(project_node_packages what)
  set(stamp ${CMAKE_CURRENT_BINARY_DIR}/packages.stamp)
  set(files package.json package-lock.json .npmrc)
  list(TRANSFORM files PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  add_custom_command(OUTPUT ${stamp}
    COMMAND ${CMAKE_COMMAND} -E copy ${files} .
    COMMAND ${NPM_PROGRAM} ci --ignore-scripts --no-update-notifier --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${files}
    COMMENT "Installing ${what} (needs network this once)")
  set(packages ${stamp} PARENT_SCOPE)
endfunction()
