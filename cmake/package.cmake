# Debian packages of what is installed, by `cpack`; `./run package` builds with the preset `package`, for
# /usr, and checks what comes out.
set(ROOMATLAS_MAINTAINER "Roomatlas developers <roomatlas@example.org>" CACHE STRING
    "Who answers for the packages: name and address")

# roomatlas_deb(COMPONENT PACKAGE SYNOPSIS [TEXT ...] [DEPENDS ...] [RECOMMENDS ...] [SUGGESTS ...]):
# the package of what is installed as COMPONENT. What it is linked with, dpkg-shlibdeps finds.
macro(roomatlas_deb component package synopsis)
  cmake_parse_arguments(DEB "" "SECTION" "TEXT;DEPENDS;RECOMMENDS;SUGGESTS" ${ARGN})
  string(TOUPPER ${component} name)
  set(CPACK_DEBIAN_${name}_PACKAGE_NAME ${package})
  list(JOIN DEB_TEXT "\n" text)
  set(CPACK_DEBIAN_${name}_DESCRIPTION "${synopsis}\n${text}")
  set(CPACK_DEBIAN_${name}_PACKAGE_SECTION ${DEB_SECTION})
  foreach(relation DEPENDS RECOMMENDS SUGGESTS)
    list(JOIN DEB_${relation} ", " CPACK_DEBIAN_${name}_PACKAGE_${relation})
  endforeach()
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  install(FILES packaging/debian/copyright DESTINATION share/doc/${package} COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/changelog.Debian.gz DESTINATION share/doc/${package}
          COMPONENT ${component})
endmacro()

configure_file(packaging/debian/changelog.in changelog.Debian @ONLY)
execute_process(COMMAND gzip -9nkf ${PROJECT_BINARY_DIR}/changelog.Debian
                COMMAND_ERROR_IS_FATAL ANY)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT ${ROOMATLAS_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SOURCE roomatlas)  # packages of one source may have its folder in their run paths
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL)

set(same "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
roomatlas_deb(program roomatlas "floor plans with rooms from the log of a robot mission"
  SECTION science
  TEXT "Roomatlas turns the log of a finished robot mission (a ROS bag or a CARMEN"
       "log, of a laser or sonars) into a floor plan with rooms, doors and walls: it"
       "maps the building room by room, corrects the drift of odometry, and draws the"
       "result. It needs no ROS."
       "."
       "This package has the program, its manual pages, and completions for bash, zsh"
       "and fish."
  RECOMMENDS "roomatlas-pictures ${same}"
  SUGGESTS "roomatlas-gdal ${same}" "python3-roomatlas ${same}" "roomatlas-fleet ${same}")
roomatlas_deb(pictures roomatlas-pictures "floor plans of Roomatlas as PDF and PNG"
  SECTION science
  TEXT "A plug-in of Roomatlas: drawings as PDF and PNG beside SVG, and maps that are"
       "PNG files."
  DEPENDS fonts-dejavu-core)
if(TARGET roomatlas_gdal)
  roomatlas_deb(gdal roomatlas-gdal "floor plans of Roomatlas as DXF and in the formats of GDAL"
    SECTION science
    TEXT "A plug-in of Roomatlas: DXF for programs of architects, and any vector format"
         "that GDAL can create, such as GML or shapefiles.")
endif()
if(TARGET roomatlas-fleet)
  roomatlas_deb(fleet roomatlas-fleet "floor plan of one building from many robot missions"
    SECTION science
    TEXT "The program roomatlas-fleet maps and joins many missions by the ranks of an"
         "MPI run, over the cores of one or of several machines."
    RECOMMENDS openmpi-bin "roomatlas ${same}")
endif()
if(TARGET roomatlas_python)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  roomatlas_deb(python python3-roomatlas "floor plans from robot missions, in Python"
    SECTION python
    TEXT "Roomatlas as a Python package: rooms for Shapely, their graph for networkx,"
         "trajectories as numpy arrays, and plans that show themselves in a notebook."
    DEPENDS "python3 (>= 3.${Python_VERSION_MINOR})" "python3 (<< 3.${next_minor})" python3-numpy
    RECOMMENDS python3-shapely python3-networkx "roomatlas-pictures ${same}")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
      ${PROJECT_SOURCE_DIR}/packaging/debian/postinst ${PROJECT_SOURCE_DIR}/packaging/debian/prerm)
endif()
roomatlas_deb(dev libroomatlas-dev "floor plans from robot missions, as a C++ library"
  SECTION libdevel
  TEXT "The static library of Roomatlas, its headers, and what find_package(roomatlas)"
       "of CMake reads."
  DEPENDS libeigen3-dev libceres-dev libpugixml-dev libsqlitecpp-dev libsqlite3-dev zlib1g-dev
          libbz2-dev liblz4-dev libzstd-dev libdeflate-dev libfftw3-dev libssl-dev libgmp-dev libmpfr-dev
          pkg-config
  RECOMMENDS "roomatlas-pictures ${same}"
  SUGGESTS "roomatlas-gdal ${same}")
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
include(CPack)
