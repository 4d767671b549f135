# The package for Debian: `cmake --workflow --preset deb`, or `deb-checker` for the checker alone.
set(PLC_CONTACT "point-line-certificates authors <root@localhost>" CACHE STRING
    "who maintains the package: name <address>")
if(PLC_PROVER)
  set(CPACK_PACKAGE_NAME ${PROJECT_NAME})
  set(summary "certified classification of point-line minimal problems")
  set(other_package plcheck)
else()
  set(CPACK_PACKAGE_NAME plcheck)
  set(summary "checker of certificates for point-line minimal problems")
  set(other_package ${PROJECT_NAME})
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT ${PLC_CONTACT})
set(CPACK_PACKAGE_VENDOR "point-line-certificates")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Packages: the programs, the checker as a library, documents; and the solver's library.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL programs checker-library documents)
if(TARGET pointline)
  list(APPEND CPACK_COMPONENTS_ALL library)
endif()
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME ${CPACK_PACKAGE_NAME})
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS ${CPACK_PACKAGE_NAME}-doc)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_CONFLICTS ${other_package})
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_REPLACES ${other_package})
set(CPACK_DEBIAN_CHECKER-LIBRARY_PACKAGE_NAME libplcheck-dev)
set(CPACK_DEBIAN_CHECKER-LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_CHECKER-LIBRARY_PACKAGE_DEPENDS ${PLCHECK_DEB_NEEDS})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libpointline-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
# It has a shared library: others depend on this package by it, and the linker hears of it.
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/triggers)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_NAME ${CPACK_PACKAGE_NAME}-doc)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_CONFLICTS ${other_package}-doc)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_REPLACES ${other_package}-doc)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${summary})
set(question
"Which points and lines in three photos fix the cameras? A certificate gives the
answer for a problem.")
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION
"${question} plcheck replays it, and believes nothing.
plprove, where it is part of the package, finds certificates.")
set(CPACK_COMPONENT_CHECKER-LIBRARY_DESCRIPTION
"${question} This is plcheck, which replays it, as a library.")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
"Which points and lines in three photos fix the cameras? This library finds all
cameras and scenes that explain given photos of a minimal problem, and the
cameras that explain most of many matches, some of them wrong.")
set(CPACK_COMPONENT_DOCUMENTS_DESCRIPTION
"${question} Here are all certificates, their format, and the
proofs on which the checker rests.")
include(CPack)

# Debian wants licence and change log of each package here.
configure_file(changelog.in changelog @ONLY)
execute_process(COMMAND ${GZIP} -9 -n -c changelog
  WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
  OUTPUT_FILE changelog.gz
  COMMAND_ERROR_IS_FATAL ANY)
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(only_in_packages EXCLUDE_FROM_ALL)
  if(component STREQUAL programs)
    set(only_in_packages)
  endif()
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz DESTINATION ${folder}
          COMPONENT ${component} ${only_in_packages})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${folder} RENAME copyright
          COMPONENT ${component} ${only_in_packages})
endforeach()
