# tolman_add_plugin(<name> ROLE <role> SOURCES <file>... [LIBRARIES <target>...]
#                   [OPENCV [COMPONENTS <module>...]])
#
# Builds the plugin library tolman_<role>_<name>.so, as the host wants it: hidden visibility, no
# undefined symbols, C++20. Target names: tolman_<role>_<name>, and tolman_<role>_<name>_objects
# for tests that call the algorithm directly. OPENCV links OpenCV's core and writes its version into
# the manifest; COMPONENTS links further modules of it, such as calib3d.
function(tolman_add_plugin name)
  cmake_parse_arguments(ARG "OPENCV" "ROLE" "SOURCES;LIBRARIES;COMPONENTS" ${ARGN})
  set(roles source odometry place cells map observer program)
  if(NOT ARG_ROLE IN_LIST roles)
    message(FATAL_ERROR "tolman_add_plugin(${name}): ROLE must be one of: ${roles}")
  endif()
  if(NOT ARG_SOURCES OR ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tolman_add_plugin(${name}): give SOURCES; unknown: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  if(ARG_COMPONENTS AND NOT ARG_OPENCV)
    message(FATAL_ERROR "tolman_add_plugin(${name}): COMPONENTS are those of OPENCV; write OPENCV COMPONENTS ...")
  endif()
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    message(STATUS "tolman_add_plugin: no CMAKE_BUILD_TYPE given, building Release")
    set(CMAKE_BUILD_TYPE Release PARENT_SCOPE)
  endif()
  set(target tolman_${ARG_ROLE}_${name})

  add_library(${target}_objects OBJECT ${ARG_SOURCES})
  target_include_directories(${target}_objects PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${target}_objects PUBLIC tolman::sdk ${ARG_LIBRARIES})
  set_target_properties(${target}_objects PROPERTIES POSITION_INDEPENDENT_CODE ON
                        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(ARG_OPENCV)
    find_package(OpenCV REQUIRED COMPONENTS core ${ARG_COMPONENTS})
    list(TRANSFORM ARG_COMPONENTS PREPEND opencv_)
    target_compile_definitions(${target}_objects PRIVATE TOLMAN_USES_OPENCV)
    target_link_libraries(${target}_objects PUBLIC opencv_core ${ARG_COMPONENTS})
  endif()

  add_library(${target} MODULE)
  target_link_libraries(${target} PRIVATE ${target}_objects)
  set_target_properties(${target} PROPERTIES PREFIX "" LINKER_LANGUAGE CXX)
  if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize" AND NOT TOLMAN_ASAN)
    target_link_options(${target} PRIVATE -Wl,-z,defs) # a sanitizer's symbols come from the host
  endif()
endfunction()

# tolman_add_conformance_test(<target> [LEVEL 1|2|3] [SET <key=value>...])
#
# Adds the test <target>_conformance: `tolman plugins validate` of the plugin library, see
# docs/conformance.md. SET gives parameters that a plugin requires. The program is that of the build
# or installation that this file belongs to, or TOLMAN_PROGRAM.
function(tolman_add_conformance_test target)
  cmake_parse_arguments(ARG "" "LEVEL" "SET" ${ARGN})
  if(NOT ARG_LEVEL)
    set(ARG_LEVEL 3)
  endif()
  if(TARGET tolman)
    set(program $<TARGET_FILE:tolman>)
  else()
    find_program(TOLMAN_PROGRAM tolman
                 HINTS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../../bin
                       ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../../../bin)
    if(NOT TOLMAN_PROGRAM)
      message(FATAL_ERROR "tolman_add_conformance_test(${target}): no program 'tolman'; "
                          "give -DTOLMAN_PROGRAM=<prefix>/bin/tolman")
    endif()
    set(program ${TOLMAN_PROGRAM})
  endif()
  list(TRANSFORM ARG_SET PREPEND "--set;")
  add_test(NAME ${target}_conformance
           COMMAND ${program} plugins validate $<TARGET_FILE:${target}> --level ${ARG_LEVEL} ${ARG_SET})
  set_tests_properties(${target}_conformance PROPERTIES TIMEOUT 900)
endfunction()
