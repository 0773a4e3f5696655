# What makes compiling faster: shared precompiled headers, files that are compiled together, and a
# compiler that need not save memory.
#
# GCC looks for memory to free whenever its heap has doubled; a twelfth of the time for a tenth of
# the memory. The objects are the same bytes.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-heapsize=1000000) # kB
endif()

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

# Headers take longer to compile than most files that include them: CLI11 alone instantiates five
# seconds of code in each. So the files of a folder are compiled in batches. OFF: each file for
# itself, for tools that look at single files, and for those who often edit the same one.
option(TOLMAN_BATCHES "Compile files in batches" ON)
set(tolman_batch 24) # files

# tolman_batches(<variable> <name> <file>...) makes the sources <name>_<number>.cpp, each of which
# includes `tolman_batch` of the files, and puts their names into <variable>. Those with an absolute
# path stay single. The includes are relative: a compiler cache finds a batch from another checkout.
function(tolman_batches variable name)
  set(sources ${ARGN})
  if(TOLMAN_BATCHES)
    set(files ${ARGN})
    list(FILTER sources INCLUDE REGEX "^/")
    list(FILTER files EXCLUDE REGEX "^/")
    set(number 0)
    while(files)
      list(SUBLIST files 0 ${tolman_batch} batch)
      list(REMOVE_ITEM files ${batch})
      list(TRANSFORM batch REPLACE "(.+)" "#include \"\\1\"" OUTPUT_VARIABLE lines)
      list(JOIN lines "\n" text)
      set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}_${number}.cpp)
      file(CONFIGURE OUTPUT ${source} CONTENT "${text}\n")
      set_source_files_properties(${source} PROPERTIES INCLUDE_DIRECTORIES
                                                       ${CMAKE_CURRENT_SOURCE_DIR})
      list(APPEND sources ${source})
      math(EXPR number "${number} + 1")
    endwhile()
  endif()
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()
