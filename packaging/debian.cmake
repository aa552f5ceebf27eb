# Run by CPack over the installed files, before it makes the package of them: what Debian wants
# beyond `cmake --install`.
set(files ${CPACK_TEMPORARY_INSTALL_DIRECTORY})
file(COPY ${CPACK_TASKC_CHANGELOG} DESTINATION ${files}/usr/share/doc/taskc)
execute_process(COMMAND gzip -9nf ${files}/usr/share/doc/taskc/changelog
                COMMAND_ERROR_IS_FATAL ANY)
# Debian's Python finds its packages there.
file(MAKE_DIRECTORY ${files}/usr/lib/python3/dist-packages)
file(CREATE_LINK ../../../share/taskc/python/taskc ${files}/usr/lib/python3/dist-packages/taskc
     SYMBOLIC)
configure_file(${CPACK_TASKC_LINTIAN_OVERRIDES} ${files}/usr/share/lintian/overrides/taskc COPYONLY)
