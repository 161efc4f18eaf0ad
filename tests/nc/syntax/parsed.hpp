// A block of one line, and the text it points into.
#pragma once

#include <string>
#include <utility>

#include "nc/syntax/parser.hpp"

namespace plumbline::nc::tests {

struct Parsed {
  std::string text;
  Block block;
  explicit Parsed(std::string line, std::string_view dialect_name = "linuxcnc", std::uint64_t offset = 100)
      : text(std::move(line)) {
    block.text = text;
    block.line = 7;
    block.offset = offset;
    Parser(dialect(dialect_name)).parse(block);
  }
  std::string at(Span span) const { return std::string(block.at(span)); }
};

}  // namespace plumbline::nc::tests
