# Manual pages and completions of what the program itself says of its options.
if(CMAKE_CROSSCOMPILING)
  return()  # the program does not run here
endif()
set(pages ${CMAKE_BINARY_DIR}/pages)
add_custom_command(OUTPUT ${pages}/man1/plumbline.1
  COMMAND ${CMAKE_COMMAND} -E make_directory ${pages}
  COMMAND plumbline --description > ${pages}/description.json
  COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/cmake/command_pages.py ${pages}/description.json ${pages}
  DEPENDS plumbline ${PROJECT_SOURCE_DIR}/cmake/command_pages.py VERBATIM)
add_custom_target(plumbline_pages ALL DEPENDS ${pages}/man1/plumbline.1)
if(PLUMBLINE_INSTALL)
  install(DIRECTORY ${pages}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)
  install(FILES ${pages}/bash/plumbline DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
  set(zsh site-functions)
  if(CMAKE_INSTALL_PREFIX STREQUAL /usr AND EXISTS /etc/debian_version)
    set(zsh vendor-completions)  # zsh of Debian looks for site-functions in /usr/local alone
  endif()
  install(FILES ${pages}/zsh/_plumbline DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${zsh} COMPONENT program)
  install(FILES ${pages}/fish/plumbline.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)
endif()
