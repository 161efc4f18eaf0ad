# Debian packages, made by CPack of the installed components; scripts/packages builds and makes them. They are meant
# for the preset `packages`, whose prefix is /usr: the folders of libraries and completions are Debian's there.
if(NOT PLUMBLINE_INSTALL OR NOT PROJECT_IS_TOP_LEVEL OR CMAKE_CROSSCOMPILING)
  return()
endif()
set(PLUMBLINE_MAINTAINER "The plumbline authors" CACHE STRING "Who answers for the packages: Name <address>")
set(here ${PROJECT_SOURCE_DIR}/cmake/packages)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT ${PLUMBLINE_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${here}/documents.cmake)
set(CPACK_COMPONENTS_ALL program library development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE plumbline)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(about "plumbline reads an NC program for a hexapod machine tool, computes from a
model of the machine how far gravity, screw friction and elastic struts will
push the tool tip away at every point, and writes a program that brings the
tip to where the original program means it to go.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME plumbline)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "straightens NC programs for hexapod machine tools
${about}

This package has the command, its manual pages, completions for bash, zsh and
fish, the documentation, and models of machines to try it with.")

set(library libplumbline${PLUMBLINE_INTERFACE})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${library})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
# Which package a program needs that is linked with the library; and that the system's list of libraries is renewed.
file(WRITE ${PROJECT_BINARY_DIR}/debian/shlibs "libplumbline ${PLUMBLINE_INTERFACE} ${library} (>= ${PROJECT_VERSION})\n")
file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/shlibs ${PROJECT_BINARY_DIR}/debian/triggers)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "straightens NC programs for hexapod machine tools (library)
${about}

This package has the shared library, for programs in C and C++ that were linked
with it.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libplumbline-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library} (= ${PROJECT_VERSION}), libfmt-dev (>= 9)")  # the static one links fmt
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "straightens NC programs for hexapod machine tools (development files)
${about}

This package has what programs in C and C++ are built with: headers, the static
library, and the files by which CMake and pkg-config find both libraries.")

if(TARGET plumbline_python)
  execute_process(COMMAND ${PLUMBLINE_PYTHON_PROGRAM} -c
    "from sys import version_info as v; print(f'python3 (>= {v[0]}.{v[1]}~), python3 (<< {v[0]}.{v[1] + 1}~)')"
    OUTPUT_VARIABLE python OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-plumbline)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${python}, python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${here}/postinst ${here}/prerm)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "straightens NC programs for hexapod machine tools (Python 3)
${about}

This package has the module for Python 3, with its types.")
endif()

# scripts/packages takes the sources out of git; this packs a folder that has no git, as it lies there.
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME plumbline-${PROJECT_VERSION})
set(CPACK_SOURCE_IGNORE_FILES "/\\\\.git(/|$)" "/__pycache__/" "/\\\\.cache/" "^${PROJECT_SOURCE_DIR}/(build|out)/")
include(CPack)
