# CPack runs this when it has made Debian's packages, which it has not compressed. CPack adds scripts that call ldconfig where
# libraries lie below /usr/lib, although ldconfig does not look into /usr/lib/gluray: they are taken out. Packages are compressed as dpkg-deb
# does, by one thread, so that they are the same on all machines.
foreach(package ${CPACK_PACKAGE_FILES})
  set(folder ${package}.unpacked)
  file(REMOVE_RECURSE ${folder})
  execute_process(COMMAND dpkg-deb --raw-extract ${package} ${folder} COMMAND_ERROR_IS_FATAL ANY)
  foreach(script postinst postrm)
    if(EXISTS ${folder}/DEBIAN/${script})
      file(READ ${folder}/DEBIAN/${script} text)
      if(text MATCHES "\n\tldconfig\n")
        file(REMOVE ${folder}/DEBIAN/${script})
      endif()
    endif()
  endforeach()
  execute_process(COMMAND dpkg-deb --root-owner-group --threads-max=1 --build ${folder} ${package} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE_RECURSE ${folder})
endforeach()
