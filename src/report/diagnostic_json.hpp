// Diagnostics for machines: editors, CAM systems.
#pragma once

#include <string>

#include "base/diagnostic.hpp"

namespace plumbline::report {

/// One JSON object on one line, without its end: code, severity, message, help, file, line, column, length, text
/// [docs/formats.md]. Bytes that are no UTF-8 become U+FFFD.
std::string diagnostic_json(const Diagnostic& diagnostic);

}  // namespace plumbline::report
