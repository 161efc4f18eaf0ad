// What plumbline says of input that it will not take: what, where, and the way out.
#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <string_view>

namespace plumbline {

/// A place in a text: lines and columns count from 1, columns in bytes. line 0: the file as a whole.
struct Place {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  std::size_t length = 1;  // bytes that the caret underlines
  std::string text;        // the line itself, without its end
};

enum class Severity { error, warning, note };

struct Diagnostic {
  std::string code;     // stable and short: "nc-unknown-code"
  std::string message;  // one sentence, no full stop, what is wrong
  std::string help;     // the way out
  Place place;
  Severity severity = Severity::error;
};

/// As compilers print it: `file:line:column: error: message [code]`, the line, a caret, `help: ...`.
std::string to_text(const Diagnostic& diagnostic);

/// Input is refused. The only exception that the libraries throw at bad input; what() is the message.
class Refusal : public std::exception {
 public:
  explicit Refusal(Diagnostic diagnostic) : diagnostic_(std::move(diagnostic)) {}
  const char* what() const noexcept override { return diagnostic_.message.c_str(); }
  const Diagnostic& diagnostic() const noexcept { return diagnostic_; }

 private:
  Diagnostic diagnostic_;
};

/// Throws the Refusal of these parts.
[[noreturn]] void refuse(std::string_view code, std::string message, std::string help, Place place = {});

/// The line of `text` that holds byte `offset`, with its number and the column of the offset.
Place place_in(std::string_view file, std::string_view text, std::size_t offset, std::size_t length = 1);

}  // namespace plumbline
