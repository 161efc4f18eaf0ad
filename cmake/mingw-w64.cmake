# Toolchain: plumbline.exe and plumbline.dll for 64-bit Windows, by Debian's MinGW-w64 (scripts/setup --with-windows).
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

# GCC does not align the stack of Windows for vectors of more than 16 bytes (its bug 54412): what it keeps there is moved
# as unaligned.
# -fno-ipa-ra: an inline function that several objects hold is linked from one of them, yet GCC trusts that it spares the
# registers which the copy in its own object spares; on ELF it does not trust that.
set(CMAKE_CXX_FLAGS_INIT "-Wa,-muse-unaligned-vector-move -fno-ipa-ra")
# No other DLL than those of Windows.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_SHARED_LINKER_FLAGS_INIT -static)

# The libraries are headers alone, the build machine's own; headers of its system must not be seen.
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
