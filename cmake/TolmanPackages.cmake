# Debian packages: tolman (program, plugins, configurations, pages), libtolman-sdk-dev,
# python3-tolman, and, built where ROS 1 and Cyclone DDS are, tolman-ros1 and tolman-ros2.
#   scripts/package, or of what is built: cpack --config build/CPackConfig.cmake
set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}") # the first line of both
set(CPACK_PACKAGE_NAME tolman)
set(CPACK_PACKAGE_CONTACT "Tolman maintainers <maintainers@tolman.example>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# Plugins that need ROS are in none of the others, so that these are the same wherever they are built.
set(packages program:tolman sdk:libtolman-sdk-dev python:python3-tolman)
get_property(has_ros1 GLOBAL PROPERTY tolman_has_ros1)
if(has_ros1)
  list(APPEND packages ros1:tolman-ros1)
endif()
get_property(has_ros2 GLOBAL PROPERTY tolman_has_ros2)
if(has_ros2)
  list(APPEND packages ros2:tolman-ros2)
endif()
list(TRANSFORM packages REPLACE ":.*" "" OUTPUT_VARIABLE CPACK_COMPONENTS_ALL)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tolman)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
    "Stereo odometry, local view templates, head direction and grid cells, and an
experience map, each a shared library, composed by one YAML file; every run is
recorded. With a procedural town that needs no data set.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "libtolman-sdk-dev, python3-tolman, tolman-ros1, tolman-ros2")

set(CPACK_DEBIAN_SDK_PACKAGE_NAME libtolman-sdk-dev)
set(CPACK_DEBIAN_SDK_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_SDK_PACKAGE_ARCHITECTURE all)
set(CPACK_COMPONENT_SDK_DESCRIPTION
    "This package has what authors of plugins need: headers, CMake package,
examples, and the templates that 'tolman plugins new' copies.")
set(CPACK_DEBIAN_SDK_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_SDK_PACKAGE_RECOMMENDS "tolman (= ${PROJECT_VERSION}), cmake (>= 3.22), g++")
set(CPACK_DEBIAN_SDK_PACKAGE_SUGGESTS "catch2, libopencv-dev")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-tolman)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "This package has the plugin that runs plugins written in Python, the classes
that they derive from, and the results of runs as arrays and tables.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "tolman (= ${PROJECT_VERSION}), python3 (>= 3.10), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-h5py")

set(CPACK_DEBIAN_ROS1_PACKAGE_NAME tolman-ros1)
set(CPACK_COMPONENT_ROS1_DESCRIPTION
    "This package has the source of live images and the publisher of pose and map,
nodes of ROS 1. Bags need it not: the package tolman reads them without ROS.")
set(CPACK_DEBIAN_ROS1_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_ROS1_PACKAGE_DEPENDS "tolman (= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_ROS2_PACKAGE_NAME tolman-ros2)
set(CPACK_COMPONENT_ROS2_DESCRIPTION
    "This package has the source of live images and the publisher of pose and map,
participants of ROS 2 through Cyclone DDS. ROS 2 itself need not be there.")
set(CPACK_DEBIAN_ROS2_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_ROS2_PACKAGE_DEPENDS "tolman (= ${PROJECT_VERSION})")

# Beside each other as in the repository, so that their links lead somewhere.
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/tolman COMPONENT program
        PATTERN site EXCLUDE)
install(DIRECTORY sdk/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/tolman/sdk
        COMPONENT program)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/doc_links)
file(CREATE_LINK ../../../../include ${PROJECT_BINARY_DIR}/doc_links/include SYMBOLIC)
install(FILES ${PROJECT_BINARY_DIR}/doc_links/include
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/tolman/sdk COMPONENT sdk)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/tolman COMPONENT program)
foreach(package ${packages})
  string(REPLACE ":" ";" package ${package})
  list(POP_FRONT package component)
  install(FILES cmake/debian/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
          COMPONENT ${component})
endforeach()
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/finish.cmake)
set(CPACK_TOLMAN_SOURCE_DIR ${PROJECT_SOURCE_DIR}) # for that script
set(CPACK_TOLMAN_PACKAGES ${packages})
include(CPack)
