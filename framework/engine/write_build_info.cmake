# Writes build_info.hpp, if it has changed: run at each build, because the revision changes
# with each commit. cmake -D SOURCE=... -D INPUT=... -D OUTPUT=... -P write_build_info.cmake
set(TOLMAN_GIT_REVISION unknown)
find_package(Git QUIET)
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --dirty --abbrev=12
                  WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE described
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(TOLMAN_GIT_REVISION ${described})
  endif()
endif()
configure_file(${INPUT} ${OUTPUT} @ONLY)
