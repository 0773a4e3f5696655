# One precompiled header for all targets that are compiled alike: each takes 170 MB and 10 s.
#
# tolman_precompiled(<name> <header>...) makes one; set on the target <name> what decides how its
# users are compiled (optimisation, visibility, position independence), then let them use it with
# target_precompile_headers(<user> REUSE_FROM <name>).
function(tolman_precompiled name)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Only its precompiled header is of interest.\n")
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE tolman::sdk)
  target_precompile_headers(${name} PRIVATE ${ARGN})
  tolman_warnings(${name})
endfunction()
