# The libraries that others link, made of the modules' objects: plumbline::static and plumbline::shared.
# plumbline::plumbline is the one that BUILD_SHARED_LIBS asks for, static by default.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(PLUMBLINE_INTERFACE 1)  # as in include/plumbline/plumbline.hpp: the number in the name of the shared library
get_property(modules GLOBAL PROPERTY PLUMBLINE_MODULES)
get_property(libraries GLOBAL PROPERTY PLUMBLINE_LIBRARIES)
list(REMOVE_DUPLICATES libraries)
list(REMOVE_ITEM libraries Eigen3::Eigen nlohmann_json::nlohmann_json tomlplusplus::tomlplusplus plumbline_jet)  # headers alone
set(objects)
foreach(module IN LISTS modules)
  list(APPEND objects $<TARGET_OBJECTS:${module}>)
endforeach()

foreach(kind static shared)
  string(TOUPPER ${kind} type)
  add_library(plumbline_${kind} ${type} ${objects})
  add_library(plumbline::${kind} ALIAS plumbline_${kind})
  set_target_properties(plumbline_${kind} PROPERTIES OUTPUT_NAME plumbline EXPORT_NAME ${kind} LINKER_LANGUAGE CXX)
  target_include_directories(plumbline_${kind} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                                         $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(plumbline_${kind} INTERFACE cxx_std_17)
  target_link_libraries(plumbline_${kind} PRIVATE ${libraries} $<BUILD_INTERFACE:plumbline_link_options>)
endforeach()
target_compile_definitions(plumbline_static INTERFACE PLUMBLINE_STATIC)
if(WIN32)
  set_target_properties(plumbline_shared PROPERTIES PREFIX "")  # plumbline.dll, as programs there ask for it
endif()
set_target_properties(plumbline_shared PROPERTIES
  SOVERSION ${PLUMBLINE_INTERFACE} VERSION ${PLUMBLINE_INTERFACE}.${PROJECT_VERSION})
if(NOT WIN32 AND NOT APPLE)
  set(symbols ${PROJECT_SOURCE_DIR}/cmake/plumbline.symbols)
  target_link_options(plumbline_shared PRIVATE LINKER:--version-script=${symbols} LINKER:--as-needed)
  set_target_properties(plumbline_shared PROPERTIES LINK_DEPENDS ${symbols})
endif()
if(BUILD_SHARED_LIBS)
  add_library(plumbline::plumbline ALIAS plumbline_shared)
else()
  add_library(plumbline::plumbline ALIAS plumbline_static)
endif()

if(NOT PLUMBLINE_INSTALL)
  return()
endif()
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/plumbline)
install(TARGETS plumbline RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/plumbline COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION ${CMAKE_INSTALL_DATADIR}/plumbline COMPONENT program
  FILES_MATCHING PATTERN *.toml)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(TARGETS plumbline_static EXPORT plumbline-static ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(TARGETS plumbline_shared EXPORT plumbline-shared
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT library
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/plumbline DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
foreach(kind static shared)
  install(EXPORT plumbline-${kind} NAMESPACE plumbline:: DESTINATION ${package} COMPONENT development)
endforeach()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/plumbline-config.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/plumbline-config.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/plumbline-config-version.cmake
  VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/plumbline-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/plumbline-config-version.cmake DESTINATION ${package} COMPONENT development)
file(RELATIVE_PATH PLUMBLINE_INCLUDE_FROM_PC ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_FULL_INCLUDEDIR})
foreach(name plumbline plumbline-static)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endforeach()
