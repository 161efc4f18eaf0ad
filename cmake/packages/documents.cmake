# Before CPack packs: manual pages are compressed, and each package gets the licences of what its binaries are made of.
# These are read where Debian has them, so that they are those of the versions that were compiled.
if(NOT CPACK_GENERATOR STREQUAL DEB)
  return()  # sources
endif()
set(compiled_in
  libceres-dev libcli11-dev libeigen3-dev libfmt-dev libsqlite3-dev libtomlplusplus-dev nlohmann-json3-dev
  libjs-three node-d3 pybind11-dev)
file(READ ${CMAKE_CURRENT_LIST_DIR}/../../LICENSE copyright)
string(APPEND copyright "
------------------------------------------------------------------------------
The binaries of plumbline's packages have parts of these works in them, and the
pages that plumbline writes are drawn by three.js and D3. What follows are the
copyright files of their Debian packages.
")
foreach(package IN LISTS compiled_in)
  set(file /usr/share/doc/${package}/copyright)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "${file} is missing, whose text belongs into the packages: is ${package} installed?")
  endif()
  file(READ ${file} text)
  string(APPEND copyright "\n---- ${package} ----\n\n${text}")
endforeach()

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  set(staged ${CPACK_TEMPORARY_DIRECTORY}/${component})
  string(TOUPPER ${component} name)
  set(documents ${staged}${CPACK_PACKAGING_INSTALL_PREFIX}/share/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME})
  file(MAKE_DIRECTORY ${documents})
  file(WRITE ${documents}/copyright "${copyright}")
  file(GLOB pages ${staged}${CPACK_PACKAGING_INSTALL_PREFIX}/share/man/man*/*)
  if(pages)
    execute_process(COMMAND gzip -9 -n -f ${pages} COMMAND_ERROR_IS_FATAL ANY)
  endif()
endforeach()
