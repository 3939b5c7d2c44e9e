# What `cmake --install` puts where, and what an installed program knows of itself.
include(GNUInstallDirs)

if(TARGET facet_cli)
  get_target_property(kind facet_cli TYPE)
  if(kind STREQUAL "STATIC_LIBRARY")
    target_compile_definitions(facet_cli PUBLIC FACET_VERSION="${PROJECT_VERSION}")
  endif()
endif()

if(TARGET facet)
  install(TARGETS facet RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  if(TARGET facet-bench)
    install(TARGETS facet-bench RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
  if(TARGET facet_oiio)  # the program looks for its modules in ../lib/facet
    install(TARGETS facet_oiio LIBRARY DESTINATION lib/facet)
  endif()
  foreach(room base math tables image brdf scene gl frame trace render batch explain teach)
    get_target_property(kind facet_${room} TYPE)
    if(kind STREQUAL "STATIC_LIBRARY")
      install(TARGETS facet_${room} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    endif()
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/facet
            FILES_MATCHING PATTERN "*.h" PATTERN "*.def")
  endforeach()
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/glsl ${PROJECT_SOURCE_DIR}/resources
          DESTINATION ${CMAKE_INSTALL_DATADIR}/facet)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/scripts/slurm ${PROJECT_SOURCE_DIR}/scripts/k8s
          DESTINATION ${CMAKE_INSTALL_DATADIR}/facet/scripts USE_SOURCE_PERMISSIONS)

  # The program itself knows its commands and options, and writes what others read about them.
  set(pages ${PROJECT_BINARY_DIR}/pages)
  file(MAKE_DIRECTORY ${pages})
  file(WRITE ${pages}/facet.thumbnailer "[Thumbnailer Entry]
TryExec=facet
Exec=sh -c 'facet render \"$0\" -q --quality draft --size \"$2x$2\" --background none -o - >\"$1\"' %i %o %s
MimeType=model/gltf-binary;model/gltf+json;
")
  install(CODE "execute_process(COMMAND \"${PROJECT_BINARY_DIR}/facet\" help man-page
    OUTPUT_FILE \"${pages}/facet.1\" COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND \"${PROJECT_BINARY_DIR}/facet\" help bash-completion
    OUTPUT_FILE \"${pages}/facet\" COMMAND_ERROR_IS_FATAL ANY)")
  install(FILES ${pages}/facet.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${pages}/facet DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${pages}/facet.thumbnailer DESTINATION ${CMAKE_INSTALL_DATADIR}/thumbnailers)
endif()
