/* Which symbols the shared library shows. Who links the static library on Windows defines PLUMBLINE_STATIC;
   the CMake targets and plumbline.pc do it by themselves. */
#ifndef PLUMBLINE_EXPORT_H
#define PLUMBLINE_EXPORT_H

#if defined(_WIN32) && !defined(PLUMBLINE_STATIC)
#ifdef PLUMBLINE_BUILDING
#define PLUMBLINE_API __declspec(dllexport)
#else
#define PLUMBLINE_API __declspec(dllimport)
#endif
#elif defined(_WIN32)
#define PLUMBLINE_API
#else
#define PLUMBLINE_API __attribute__((visibility("default")))
#endif

#endif
