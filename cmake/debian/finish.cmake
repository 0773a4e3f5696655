# Run by CPack when all packages are installed into their folders and not yet packed: Debian's
# changelog, and what makes two builds of the same sources the same bytes. Times are those of the
# newest dated release in docs/changelog.md.
set(folder ${CPACK_TEMPORARY_DIRECTORY})
file(STRINGS ${CPACK_TOLMAN_SOURCE_DIR}/docs/changelog.md releases
     REGEX "^## \\[[0-9.]+\\], [0-9]+-[0-9]+-[0-9]+$")
set(date 1980-01-01) # nothing was released yet
if(releases)
  list(GET releases 0 release)
  string(REGEX REPLACE ".*, " "" date ${release})
endif()

function(run output)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C TZ=UTC ${ARGN}
                  OUTPUT_VARIABLE text OUTPUT_STRIP_TRAILING_WHITESPACE
                  COMMAND_ERROR_IS_FATAL ANY)
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

run(seconds date -d ${date} +%s)
run(day date -d ${date} -R)
set(ENV{SOURCE_DATE_EPOCH} ${seconds}) # CPack gives it to what it packs itself

foreach(package ${CPACK_TOLMAN_PACKAGES})
  string(REPLACE ":" ";" package ${package})
  list(POP_FRONT package component)
  set(changelog ${folder}/${component}/usr/share/doc/${package}/changelog)
  file(WRITE ${changelog}
       "tolman (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n"
       "  * Release ${CPACK_PACKAGE_VERSION}. What changed is listed in\n"
       "    /usr/share/doc/tolman/docs/changelog.md of the package tolman.\n\n"
       " -- ${CPACK_PACKAGE_CONTACT}  ${day}\n")
  run(nothing gzip -9nf ${changelog})
endforeach()

file(GLOB_RECURSE man_pages ${folder}/*/usr/share/man/*.[1-9])
if(man_pages)
  run(nothing gzip -9nf ${man_pages})
endif()

# Neither the modes of the sources nor the hour may show.
run(nothing chmod -R u=rwX,go=rX ${folder})
run(nothing find ${folder} -exec touch -h -d @${seconds} {} +)
