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
# What a program needs that links the library.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, libgmp-dev, libflint-dev, libflint-arb-dev")
set(CPACK_DEBIAN_PACKAGE_CONFLICTS ${other_package})
set(CPACK_DEBIAN_PACKAGE_REPLACES ${other_package})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${summary})
set(CPACK_PACKAGE_DESCRIPTION
"Which points and lines in three photos fix the cameras? A certificate gives the
answer for a problem. plcheck replays it, and believes nothing. plprove, where
it is part of the package, finds certificates.")
include(CPack)

# Debian wants licence and change log here.
set(package_documents ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_PACKAGE_NAME})
configure_file(changelog.in changelog @ONLY)
add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz
  COMMAND ${GZIP} -9 -n -c changelog > ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz
  DEPENDS ${CMAKE_CURRENT_BINARY_DIR}/changelog)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz DESTINATION ${package_documents})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${package_documents} RENAME copyright)
