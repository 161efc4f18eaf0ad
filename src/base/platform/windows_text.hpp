// Names as Windows takes them, and its errors as errno tells them.
#pragma once

#include <string>
#include <string_view>

namespace plumbline::platform {

/// Empty, with errno EILSEQ, if the text is no UTF-8.
std::wstring wide(std::string_view text);
std::string narrow(std::wstring_view text);

/// Sets errno by GetLastError().
void tell_error();

}  // namespace plumbline::platform
