# Debian's packages: the one list of them. CPack makes packages of it (CMakeLists.txt), debian_source.cmake the control file of the
# source package.
set(DEBIAN_REVISION 1)  # of the packages of one version
set(DEBIAN_VERSION ${PROJECT_VERSION}-${DEBIAN_REVISION})
set(DEBIAN_MAINTAINER "The GLuRay developers <gluray@example.org>")
set(DEBIAN_SECTION graphics)

# debian_package(COMPONENT NAME SYNOPSIS text DESCRIPTION lines... [ARCHITECTURE all] [SECTION name] [DEPENDS packages] [RECOMMENDS packages]
# [SUGGESTS packages]): the package NAME has what the component installs. @DEBIAN_VERSION@ in DEPENDS is the version of the packages. Libraries that
# files are linked with are not listed: dpkg-shlibdeps finds them. Packages for all architectures allow rebuilt packages of the same version (+b1).
set(DEBIAN_COMPONENTS)
macro(debian_package component name)
  cmake_parse_arguments(DEBIAN_${component} "" "SYNOPSIS;ARCHITECTURE;SECTION;DEPENDS;RECOMMENDS;SUGGESTS" "DESCRIPTION" ${ARGN})
  set(DEBIAN_${component}_NAME ${name})
  if(NOT DEBIAN_${component}_ARCHITECTURE)
    set(DEBIAN_${component}_ARCHITECTURE any)
  endif()
  if(NOT DEBIAN_${component}_SECTION)
    set(DEBIAN_${component}_SECTION ${DEBIAN_SECTION})
  endif()
  list(APPEND DEBIAN_COMPONENTS ${component})
endmacro()

# The engine opens the real OpenGL by name, which no linker sees.
debian_package(Unspecified gluray
  SYNOPSIS "Ray traces what unmodified OpenGL programs draw"
  DESCRIPTION "GLuRay sits between an OpenGL program and its OpenGL library, keeps the scene"
              "that the calls describe, traces it with Embree on the CPU, and puts colour and"
              "depth back into the program's own framebuffer. What it cannot trace is drawn"
              "by the real OpenGL."
  DEPENDS "libgl1" RECOMMENDS "libgl1-mesa-dri, libegl1" SUGGESTS "bash-completion, man-db, python3-gluray, gluray-panel")
debian_package(panel gluray-panel
  SYNOPSIS "Window that controls OpenGL programs under GLuRay"
  DESCRIPTION "GLuRay's panel shows every program that runs under GLuRay, and changes its"
              "light, materials and quality from one frame to the next."
  DEPENDS "gluray (= @DEBIAN_VERSION@)")
debian_package(python python3-gluray
  SYNOPSIS "Ray traces what Python programs draw with OpenGL"
  DESCRIPTION "The module gluray makes what a Python process draws ray traced, and changes"
              "settings of programs that run under GLuRay."
  ARCHITECTURE all SECTION python DEPENDS "python3, gluray (>= @DEBIAN_VERSION@), gluray (<< @DEBIAN_VERSION@.1~)")
# Useful without GLuRay as well: it depends on nothing of it.
debian_package(osmesa gluray-osmesa
  SYNOPSIS "OSMesa for machines whose Mesa has none any more"
  DESCRIPTION "libOSMesa.so.8 over EGL without a screen: programs that draw into memory,"
              "such as VTK without a display, find it under GLuRay, or by LD_LIBRARY_PATH."
  RECOMMENDS "libegl-mesa0")
debian_package(openmpi gluray-openmpi
  SYNOPSIS "Jobs of gluray-worker under Open MPI"
  DESCRIPTION "Many ranks of gluray-worker, started by the launcher of Open MPI, trace"
              "images for a program under GLuRay."
  DEPENDS "gluray (= @DEBIAN_VERSION@)")
debian_package(mpich gluray-mpich
  SYNOPSIS "Jobs of gluray-worker under MPICH"
  DESCRIPTION "Many ranks of gluray-worker, started by the launcher of MPICH, trace images"
              "for a program under GLuRay."
  DEPENDS "gluray (= @DEBIAN_VERSION@)")

# debian_changelog(FILE): the changelog of the packages, whose only entry has the date $SOURCE_DATE_EPOCH.
function(debian_changelog file)
  if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
    set(ENV{SOURCE_DATE_EPOCH} 1)
    string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
    unset(ENV{SOURCE_DATE_EPOCH})
  else()
    string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  endif()
  file(CONFIGURE OUTPUT ${file} @ONLY CONTENT
"gluray (${DEBIAN_VERSION}) unstable; urgency=medium

  * Version ${PROJECT_VERSION}: /usr/share/doc/gluray/changelog.gz says what is new.

 -- ${DEBIAN_MAINTAINER}  ${date}
")
endfunction()
