# How this project's own targets are declared; warnings, sanitizers and CPU flags live here only,
# so that code of others (imported targets) never gets them.
#
#   powderlink_library(NAME [STATIC|SHARED|MODULE|OBJECT|INTERFACE]     default STATIC
#     [SOURCES file...] [LIBRARIES target...] [PRIVATE_LIBRARIES target...]
#     [INCLUDES dir...] [DEFINITIONS def...])
#   powderlink_executable(NAME SOURCES file... [LIBRARIES ...] [INCLUDES ...] [DEFINITIONS ...]
#     [PRECOMPILE header...])  headers that most of its sources read
#   powderlink_benchmark(NAME [OWN_MAIN] SOURCES file... [LIBRARIES ...] ...)   Google Benchmark, with main
#                              unless OWN_MAIN; in bench_bin/, built by the target `benchmarks` only
#   powderlink_test(NAME SOURCES file...                                GoogleTest
#     [LIBRARIES ...] [INCLUDES ...] [DEFINITIONS ...]
#     [LABELS unit|host|...]   default unit; `unit` tests also run under the sanitizers, and so do
#                              those labelled `sanitized` (without the search for leaks)
#     [TIMEOUT seconds]        per test case, default 60
#     [PROCESSORS n] [ENVIRONMENT VAR=value...] [RUN_SERIAL] [OWN_MAIN])
#   powderlink_test_program(NAME SOURCES file... ...)                   a tool for command tests
#   powderlink_command_test(NAME COMMAND program arg...                 anything else
#     [LABELS ...] [TIMEOUT ...] [PROCESSORS ...] [ENVIRONMENT ...] [RUN_SERIAL]
#     [WORKING_DIRECTORY dir])
#
# Every target also answers to powderlink::NAME (libraries) and sees the repository's root as an
# include directory: #include "physics/contact/jkr_law.h".

include_guard(GLOBAL)
include(CheckCXXCompilerFlag)
include(GoogleTest)

option(POWDERLINK_NATIVE "Compile for this machine's processor (-march=native)" ON)
option(POWDERLINK_SANITIZE "Address and undefined-behaviour sanitizers in our own code" OFF)
# Templates of Boost, fmt and OpenFOAM cost more than our own lines: read once for several sources they
# cost a third. A file that lacks an include shows with OFF, as does clang-tidy.
option(POWDERLINK_UNITY "Compile several sources of a library at once" ON)
set(POWDERLINK_UNITY_SOURCES 8 CACHE STRING "Sources that are compiled at once, at most")
set(CMAKE_UNITY_BUILD_BATCH_SIZE ${POWDERLINK_UNITY_SOURCES})

add_library(powderlink_flags INTERFACE)
# Messages name files from the root of the repository.
target_compile_options(powderlink_flags INTERFACE -Wall -Wextra -Wpedantic
  -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
if(POWDERLINK_NATIVE)
  check_cxx_compiler_flag(-march=native POWDERLINK_HAS_MARCH_NATIVE)
  if(POWDERLINK_HAS_MARCH_NATIVE)
    target_compile_options(powderlink_flags INTERFACE -march=native)
    # Packaged libraries (Ceres) were built with Eigen's 16-byte alignment; with AVX, Eigen would
    # otherwise allocate and free memory in another way than they do.
    target_compile_definitions(powderlink_flags INTERFACE EIGEN_MAX_ALIGN_BYTES=16)
  endif()
endif()
if(POWDERLINK_SANITIZE)
  set(_powderlink_sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all)
  target_compile_options(powderlink_flags INTERFACE
    ${_powderlink_sanitizers} -fno-omit-frame-pointer)
  target_link_options(powderlink_flags INTERFACE ${_powderlink_sanitizers})
  target_compile_definitions(powderlink_flags INTERFACE _GLIBCXX_ASSERTIONS)
endif()

# What users need, without tests and benchmarks: the entry script builds this.
add_custom_target(programs)
# What ./powderlink bench runs beside the programs; nothing else needs it.
add_custom_target(benchmarks)
# What the sanitizer preset builds.
add_custom_target(tests_to_sanitize)

function(_powderlink_check_arguments function name prefix)
  if(${prefix}_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${function}(${name}): unknown arguments: ${${prefix}_UNPARSED_ARGUMENTS}; "
      "allowed ones are listed at the top of cmake/PowderlinkTargets.cmake")
  endif()
endfunction()

function(powderlink_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "STATIC;SHARED;MODULE;OBJECT;INTERFACE" ""
    "SOURCES;LIBRARIES;PRIVATE_LIBRARIES;INCLUDES;DEFINITIONS")
  _powderlink_check_arguments(powderlink_library ${name} arg)
  set(kind STATIC)
  foreach(candidate IN ITEMS SHARED MODULE OBJECT INTERFACE)
    if(arg_${candidate})
      set(kind ${candidate})
    endif()
  endforeach()
  add_library(${name} ${kind} ${arg_SOURCES})
  add_library(powderlink::${name} ALIAS ${name})
  if(kind STREQUAL INTERFACE)
    set(scope INTERFACE)
  else()
    set(scope PUBLIC)
    target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:powderlink_flags>
      ${arg_PRIVATE_LIBRARIES})
    set_target_properties(${name} PROPERTIES UNITY_BUILD ${POWDERLINK_UNITY})
  endif()
  target_include_directories(${name} ${scope} ${PROJECT_SOURCE_DIR} ${arg_INCLUDES})
  target_compile_definitions(${name} ${scope} ${arg_DEFINITIONS})
  target_link_libraries(${name} ${scope} ${arg_LIBRARIES})
  # Plugins are linked by nobody, so they must be named.
  if(kind STREQUAL SHARED OR kind STREQUAL MODULE)
    add_dependencies(programs ${name})
  endif()
endfunction()

function(_powderlink_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;INCLUDES;DEFINITIONS")
  _powderlink_check_arguments(powderlink_executable ${name} arg)
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR} ${arg_INCLUDES})
  target_compile_definitions(${name} PRIVATE ${arg_DEFINITIONS})
  target_link_libraries(${name} PRIVATE powderlink_flags ${arg_LIBRARIES})
endfunction()

function(powderlink_executable name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;INCLUDES;DEFINITIONS;PRECOMPILE")
  _powderlink_program(${name} SOURCES ${arg_SOURCES} LIBRARIES ${arg_LIBRARIES}
    INCLUDES ${arg_INCLUDES} DEFINITIONS ${arg_DEFINITIONS})
  target_precompile_headers(${name} PRIVATE ${arg_PRECOMPILE})
  add_dependencies(programs ${name})
endfunction()

function(powderlink_benchmark name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OWN_MAIN" "" "")
  _powderlink_program(${name} ${arg_UNPARSED_ARGUMENTS})
  if(NOT arg_OWN_MAIN)
    find_package(benchmark REQUIRED)
    target_link_libraries(${name} PRIVATE benchmark::benchmark_main)
  endif()
  set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bench_bin)
  add_dependencies(benchmarks ${name})
endfunction()

# Sets `variable` to the environment of a test. MPI and the host programs keep memory until exit on
# purpose, so only unit tests look for leaks.
function(_powderlink_test_environment variable labels)
  set(environment ${ARGN})
  if(POWDERLINK_SANITIZE)
    list(APPEND environment "UBSAN_OPTIONS=print_stacktrace=1")
    if(NOT "unit" IN_LIST labels)
      list(APPEND environment "ASAN_OPTIONS=detect_leaks=0")
    endif()
  endif()
  set(${variable} "${environment}" PARENT_SCOPE)
endfunction()

function(powderlink_test_program name)
  _powderlink_program(${name} ${ARGN})
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/test_bin)
endfunction()

function(powderlink_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "RUN_SERIAL;OWN_MAIN" "TIMEOUT;PROCESSORS"
    "SOURCES;LIBRARIES;INCLUDES;DEFINITIONS;LABELS;ENVIRONMENT")
  _powderlink_check_arguments(powderlink_test ${name} arg)
  if(NOT arg_LABELS)
    set(arg_LABELS unit)
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 60)
  endif()
  if(NOT arg_PROCESSORS)
    set(arg_PROCESSORS 1)
  endif()
  set(framework GTest::gtest_main)
  if(arg_OWN_MAIN)
    set(framework GTest::gtest)
  endif()
  powderlink_test_program(${name} SOURCES ${arg_SOURCES} INCLUDES ${arg_INCLUDES}
    DEFINITIONS ${arg_DEFINITIONS} LIBRARIES ${arg_LIBRARIES} ${framework})
  if("unit" IN_LIST arg_LABELS OR "sanitized" IN_LIST arg_LABELS)
    add_dependencies(tests_to_sanitize ${name})
  endif()

  _powderlink_test_environment(environment "${arg_LABELS}" ${arg_ENVIRONMENT})
  gtest_discover_tests(${name}
    TEST_PREFIX "${name}."
    TEST_LIST ${name}_test_cases
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
    DISCOVERY_TIMEOUT 60)
  # gtest_discover_tests loses properties that are lists (labels, environment); ctest reads this
  # file after the one with the discovered cases.
  set(properties_file ${CMAKE_CURRENT_BINARY_DIR}/${name}_properties.cmake)
  string(CONFIGURE [[
if(@name@_test_cases)
  set_tests_properties(${@name@_test_cases} PROPERTIES
    LABELS "@arg_LABELS@"
    TIMEOUT @arg_TIMEOUT@
    PROCESSORS @arg_PROCESSORS@
    ENVIRONMENT "@environment@"
    RUN_SERIAL @arg_RUN_SERIAL@)
endif()
]] properties @ONLY)
  file(GENERATE OUTPUT ${properties_file} CONTENT "${properties}")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${properties_file})
endfunction()

function(powderlink_command_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "RUN_SERIAL" "TIMEOUT;PROCESSORS;WORKING_DIRECTORY"
    "COMMAND;LABELS;ENVIRONMENT")
  _powderlink_check_arguments(powderlink_command_test ${name} arg)
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 60)
  endif()
  if(NOT arg_PROCESSORS)
    set(arg_PROCESSORS 1)
  endif()
  if(NOT arg_WORKING_DIRECTORY)
    set(arg_WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  endif()
  _powderlink_test_environment(environment "${arg_LABELS}" ${arg_ENVIRONMENT})
  add_test(NAME ${name} COMMAND ${arg_COMMAND} WORKING_DIRECTORY ${arg_WORKING_DIRECTORY})
  set_tests_properties(${name} PROPERTIES
    LABELS "${arg_LABELS}"
    TIMEOUT ${arg_TIMEOUT}
    PROCESSORS ${arg_PROCESSORS}
    ENVIRONMENT "${environment}"
    RUN_SERIAL ${arg_RUN_SERIAL})
endfunction()
