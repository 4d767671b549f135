# A bill of materials, sbom.spdx.json (SPDX 2.3): the project, and what its programs link or include, with
# the versions that CMake found. No clock and no random name gets in: the date is that of CITATION.cff.
function(read_version variable header prefix)
  foreach(part "" _MINOR _PATCHLEVEL)
    file(STRINGS ${header} line REGEX "^#define ${prefix}${part}[ \t]+[0-9]+" LIMIT_COUNT 1)
    string(REGEX MATCH "[0-9]+$" number "${line}")
    list(APPEND numbers ${number})
  endforeach()
  list(JOIN numbers . version)
  set(${variable} ${version} PARENT_SCOPE)
endfunction()

set(sbom_packages)
set(sbom_relations)
# sbom_package(NAME VERSION LICENCE [LIBRARY]): a library that is shared has a file.
function(sbom_package name version licence)
  string(REPLACE _ - id ${name})
  set(file "")
  if(ARGN)
    set(file "\"packageFileName\": \"${ARGN}.so\",\n      ")
  endif()
  string(APPEND sbom_packages ",
    {
      \"SPDXID\": \"SPDXRef-${id}\",
      \"name\": \"${name}\",
      \"versionInfo\": \"${version}\",
      ${file}\"licenseDeclared\": \"${licence}\",
      \"licenseConcluded\": \"NOASSERTION\",
      \"copyrightText\": \"NOASSERTION\",
      \"downloadLocation\": \"NOASSERTION\",
      \"filesAnalyzed\": false
    }")
  string(APPEND sbom_relations ",
    {
      \"spdxElementId\": \"SPDXRef-project\",
      \"relationshipType\": \"DEPENDS_ON\",
      \"relatedSpdxElement\": \"SPDXRef-${id}\"
    }")
  set(sbom_packages "${sbom_packages}" PARENT_SCOPE)
  set(sbom_relations "${sbom_relations}" PARENT_SCOPE)
endfunction()

find_file(GMP_HEADER gmp.h REQUIRED)
mark_as_advanced(GMP_HEADER)
read_version(version ${GMP_HEADER} __GNU_MP_VERSION)
sbom_package(GMP ${version} "LGPL-3.0-or-later OR GPL-2.0-or-later" libgmp)
if(PLCHECK_NEEDS_FLINT OR PLC_PROVER)
  read_version(version ${FLINT_INCLUDE_DIR}/flint/flint.h __FLINT_VERSION)
  sbom_package(FLINT ${version} LGPL-2.1-or-later libflint)
endif()
if((PLCHECK_NEEDS_FLINT OR PLC_PROVER) AND ARB_LIBRARY) # beside FLINT 2
  read_version(version ${FLINT_INCLUDE_DIR}/arb.h __ARB_VERSION)
  cmake_path(GET ARB_LIBRARY STEM arb_file)
  sbom_package(Arb ${version} LGPL-2.1-or-later ${arb_file})
endif()
if(PLC_PROVER)
  find_package(Eigen3 REQUIRED NO_MODULE)
  find_package(CLI11 REQUIRED)
  find_package(OpenSSL REQUIRED COMPONENTS Crypto)
  find_package(nlohmann_json REQUIRED)
  find_package(SQLite3 REQUIRED)
  set(MPI_CXX_SKIP_MPICXX ON)
  find_package(MPI QUIET COMPONENTS CXX)
  sbom_package(Eigen3 ${Eigen3_VERSION} MPL-2.0)
  sbom_package(CLI11 ${CLI11_VERSION} BSD-3-Clause)
  sbom_package(OpenSSL ${OPENSSL_VERSION} Apache-2.0 libcrypto)
  sbom_package(nlohmann_json ${nlohmann_json_VERSION} MIT)
  sbom_package(SQLite3 ${SQLite3_VERSION} blessing libsqlite3)
  if(MPI_CXX_FOUND) # the version is that of the standard
    sbom_package(MPI ${MPI_CXX_VERSION} NOASSERTION libmpi)
  endif()
endif()

file(STRINGS ${PROJECT_SOURCE_DIR}/CITATION.cff line REGEX "^date-released: ")
string(REGEX MATCH "[0-9-]+$" sbom_date ${line})
string(SHA256 sbom_digest "${sbom_packages}")
configure_file(sbom.spdx.json.in sbom.spdx.json @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/sbom.spdx.json
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME} COMPONENT programs)
